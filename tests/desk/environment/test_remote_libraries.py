from pathlib import Path

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from kit.desk.library_desk import LibraryDesk
from kit.labs.laboratory import Laboratory, job
from kit.labs.library_server import LibraryServer
from kit.labs.library_site import LibrarySite, new_key, wink
from onika.desk.environment.diary_values import given
from onika.store.remote.checkout import is_fetched
from onika.store.remote.rights import is_confined
from onika.store.shipped import shipped
from onika.wire import act


@pytest.fixture
def site(tmp_path) -> LibrarySite:
    site = LibrarySite(tmp_path)
    Laboratory(site.base).configuration("winkC", "wink 50")
    Laboratory(site.base).application("evening", [job("winkC")])
    site.publish(description="lamps")
    return site


@pytest.fixture
def desk(tmp_path) -> LibraryDesk:
    return LibraryDesk(tmp_path)


def test_a_library_is_looked_at_and_nothing_is_kept_of_it(desk, site):  # R-F06
    offer = desk.browse(site)
    assert (offer.name, offer.version, offer.description, offer.used) == ("wings", 1, "lamps", 0)
    assert [(entry.kind, entry.name) for entry in offer.entries] == [
        ("application", "evening"),
        ("configuration", "winkC"),
        ("task", "wink"),
    ]
    assert offer.signer.startswith("SHA256:")
    assert "wink" not in desk.tasks() and desk.value(act.ListRemoteLibraries()) == ()


def test_what_is_taken_joins_the_session_with_its_code(desk, site):  # R-F03 R-C01
    folder = desk.take(site)
    tree = desk.environment.tree
    assert "wink" in tree.tasks and folder in tree.libraries
    assert is_fetched(Path(tree.tasks["wink"].code))
    assert any(file.name == "evening" for file in tree.application_files.values())
    assert any(file.name == "winkC" for file in tree.files.values())
    doc = desk.new("wink")
    assert "wink" in desk.environment.tree.documents[doc].tasks
    (used,) = desk.value(act.ListRemoteLibraries())
    assert (used.name, used.version, used.lacking, used.folder) == ("wings", 1, 0, folder)


def test_an_application_of_ones_own_finds_what_was_taken_a_moment_ago(desk, site):  # R-F03
    desk.take(site)
    assert desk.site.configuration_file("winkC") is not None


def test_icons_of_others_stand_in_a_dictionary_at_once(desk, site):  # R-D01
    icon = (shipped() / "boxes/dict").glob("*.onk")
    site.write("dict/beside.onk", next(icon).read_text())
    site.publish()
    folder = desk.take(site)
    assert folder in desk.environment.tree.dictionaries


def test_what_was_shown_is_what_is_taken(desk, site):  # R-X16
    offer = desk.browse(site)
    site.write("module/wink.rmod", wink("LAMP", "Q_MEZ"))
    site.publish()
    no = desk.later(act.TakeLibrary(str(site.folder), offer.digest)).no
    assert no is not None and no.reason.key == "desk.library_changed_meanwhile"
    assert "wink" not in desk.tasks()


def test_a_newer_version_shows_what_is_new_and_what_is_written_further(desk, site):  # R-X16
    desk.take(site)
    site.write("module/wink.rmod", wink("LAMP", "Q_MEZ"))
    site.write("module/blink.rmod", wink(says="blinks"))
    site.publish()
    offer = desk.browse(site)
    assert (offer.used, offer.version, offer.refusal) == (1, 2, None)
    assert offer.further == (("wink", ("Q_MEZ",)),)
    assert {entry.name for entry in offer.entries if entry.is_new} == {"wink", "blink"}
    desk.take(site)
    assert {"wink", "blink"} <= desk.tasks()


def test_a_key_that_changed_is_told_and_refused(desk, site, tmp_path):  # R-X16
    desk.take(site)
    site.key = new_key(tmp_path, "other")
    site.publish()
    offer = desk.browse(site)
    assert offer.refusal is not None and offer.refusal.key == "store.signer_other"
    no = desk.later(act.TakeLibrary(str(site.folder), offer.digest)).no
    assert no is not None and no.reason.key == "store.signer_other"


def test_rights_are_given_and_taken_back(desk, site):  # R-X16
    folder = desk.take(site)
    (used,) = desk.value(act.ListRemoteLibraries())
    assert not used.has_all_rights
    desk.value(act.GiveLibraryRights(used.name, True))
    (used,) = desk.value(act.ListRemoteLibraries())
    assert used.has_all_rights
    assert not is_confined(Path(folder) / "module" / "wink.py")
    desk.value(act.GiveLibraryRights(used.name, False))
    assert is_confined(Path(folder) / "module" / "wink.py")
    no = desk.later(act.GiveLibraryRights("nobody", True)).no
    assert no is not None and no.reason.key == "store.library_unknown"


def test_what_is_dropped_is_gone_from_all_lists(desk, site):  # R-F03
    folder = desk.take(site)
    desk.value(act.DropLibrary("wings"))
    tree = desk.environment.tree
    assert "wink" not in tree.tasks and folder not in tree.libraries
    assert not any(file.name == "evening" for file in tree.application_files.values())
    assert desk.site.configuration_file("winkC") is None
    assert desk.no(act.DropLibrary("wings")).reason.key == "store.library_unknown"


def test_a_library_is_there_again_in_the_next_session(desk, site, tmp_path):  # R-F03
    desk.take(site)
    assert "wink" in LibraryDesk(tmp_path).tasks()


def test_a_password_is_asked_for_beside_its_place_and_not_written_down(desk, site):  # R-F03
    with LibraryServer(site.folder, password="ann:secret") as server:
        no = desk.later(act.BrowseLibrary(server.address)).no
        assert no is not None and "secret" in no.fields
        command = act.BrowseLibrary(server.address, "ann", "secret")
        assert desk.value(command).name == "wings"
        assert "secret" not in given(command, (), ())


def test_an_environment_without_a_home_has_none(tmp_path):  # R-B07
    desk = EnvironmentFixture(tmp_path)
    browse, take = act.BrowseLibrary("/x"), act.TakeLibrary("/x", "")
    for command in (act.ListRemoteLibraries(), browse, take, act.DropLibrary("x")):
        assert desk.no(command).reason.key == "desk.no_remote_libraries"
