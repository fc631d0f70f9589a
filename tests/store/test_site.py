from pathlib import Path

import pytest

from onika.files import buttons, picture, preferences, syntax
from onika.files.rmod import RmodText
from onika.model.application import AppFlow, Application
from onika.model.button import Button
from onika.model.configuration import Configuration, Placed
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.preferences import Preferences
from onika.model.syntax import SPECIAL_TYPES, Edge, IconType, Syntax
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.shipped import is_shipped, shipped, shipped_directories
from onika.store.site import Site, open_site
from onika.words.fault import Refusal

SHIPPED = Syntax(tuple(IconType(name, 0, 0) for name in SPECIAL_TYPES), (Edge(0, (1, 1, 1), ()),))
OWN = Syntax((*SHIPPED.types, IconType("My object", 0, 0)), SHIPPED.edges)


@pytest.fixture
def site(tmp_path: Path) -> Site:
    """Two base directories, the installation's files and an empty home."""
    for folder in ("one", "two", "prefs", "home"):
        (tmp_path / folder).mkdir()
    (tmp_path / "prefs" / syntax.NAME).write_text(syntax.write(SHIPPED))
    directories = (BaseDirectory(tmp_path / "one"), BaseDirectory(tmp_path / "two"))
    return Site(directories, tmp_path / "prefs", tmp_path / "home")


def home(site: Site) -> Path:
    assert site.home
    return site.home


def task(name: str, module: str) -> RmodText:
    return RmodText(Task(name, module, frequency=10.0))


def test_the_first_directory_that_has_a_name_wins(site: Site) -> None:
    item, two = site.directories  # reading 11
    two.save_task(task("pid", "second"))
    record, _ = site.task("pid")
    assert record
    assert record.task.module == "second"
    item.save_task(task("pid", "first"))
    record, _ = site.task("pid")
    assert record
    assert record.task.module == "first"
    assert site.home_of_task("pid") == item


def test_later_duplicates_are_reported_with_their_directory(site: Site) -> None:
    item, two = site.directories  # R-C01, R-D15
    for base in (item, two):
        base.save_task(task("pid", "pid"))
        base.save_onikon(Onikon("grip", "Complete job", "", (), blank()))
    two.save_task(task("other", "other"))
    assert [(fault.place.file, str(fault.instead)) for fault in site.duplicates()] == [
        (str(two.path / "module" / "pid"), "the first one is used"),
        (str(two.path / "dict" / "grip"), "the first one is used"),
    ]


def test_a_directory_of_the_search_path_that_is_none_is_noted(site: Site, tmp_path: Path) -> None:
    assert site.absent() == ()  # R-C01, R-C20
    (note,) = site.at(tmp_path / "typo").absent()
    assert (note.place.file, note.is_note) == (str(tmp_path / "typo"), True)


def test_what_is_nowhere_is_none_without_a_fault(site: Site) -> None:
    assert site.task("pid") == site.configuration("x") == (None, ())
    assert site.onikon("x", SHIPPED) == site.application("x", SHIPPED) == (None, ())
    assert site.task("../pid") == (None, ())


def test_only_the_file_asked_for_is_read(site: Site) -> None:
    item, _ = site.directories
    item.save_configuration(Configuration("hold", (Placed("pid"),)))
    (item.path / "conf" / "bad.conf").write_bytes(b"\xff")
    assert site.configuration("hold") == (Configuration("hold", (Placed("pid"),)), ())


def test_the_code_of_a_module_lies_beside_its_task_else_on_the_search_path(site: Site) -> None:
    item, two = site.directories
    two.save_task(task("pid", "control"))
    assert site.code_file(Task("pid", "control")) is None
    for base in (item, two):
        (base.path / "module").mkdir(exist_ok=True)
        base.code_file("control").touch()
    assert site.code_file(Task("pid", "control")) == two.code_file("control")
    two.code_file("control").unlink()
    assert site.code_file(Task("pid", "control")) == item.code_file("control")


def test_an_application_is_found_by_name_and_by_path(
    site: Site, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    _, two = site.directories
    two.save_application(Application("work", False, (AppFlow(()),)))
    path = two.application_file("work")
    assert site.application_file("work") == path
    assert site.application_file(str(path)) == path
    monkeypatch.chdir(path.parent)
    assert site.application_file("work.appl") == Path("work.appl")
    assert site.application_file("nothing") is None
    assert site.application_file(str(tmp_path / "nothing.appl")) is None


def test_one_directory_can_come_first(site: Site) -> None:
    item, two = site.directories
    assert site.at(two.path).directories == (two, item)
    assert site.at(two.path / ".." / "two").directories[1:] == (item,)


def test_the_users_syntax_wins_over_the_shipped_one(site: Site) -> None:
    assert site.syntax() == (SHIPPED, ())  # reading 39, R-D02
    (home(site) / syntax.NAME).write_text(syntax.write(OWN))
    assert site.syntax() == (OWN, ())
    (home(site) / ".OnikaUpperSetUp.dta").write_text(syntax.write(SHIPPED))
    assert site.syntax() == (SHIPPED, ())


def test_a_faulty_syntax_of_the_user_is_reported_and_the_next_is_taken(site: Site) -> None:
    (home(site) / syntax.NAME).write_text("EOF")  # R-B07
    result, faults = site.syntax()
    assert result == SHIPPED
    assert faults
    (site.prefs / syntax.NAME).unlink()
    result, faults = site.syntax()
    assert result is None
    assert faults[-1].place.file == str(site.prefs / syntax.NAME)


def test_preferences_and_buttons_are_optional(site: Site) -> None:
    assert site.preferences() == (Preferences(), ())  # R-B12
    assert site.buttons() == ((), ())
    (home(site) / ".onika").write_text(preferences.write(Preferences(pin_length=3)))
    (home(site) / ".onika.buttons").write_text(buttons.write([Button("a", "b")]))
    assert site.preferences() == (Preferences(pin_length=3), ())
    assert site.buttons() == ((Button("a", "b"),), ())
    (home(site) / ".onika.buttons").write_text("BUTTON a\nEOF")
    result, faults = site.buttons()
    assert (result, len(faults)) == ((), 1)
    (home(site) / ".onika").write_bytes(b"\xff")
    found_preferences, faults = site.preferences()
    assert (found_preferences, len(faults)) == (Preferences(), 1)


def test_preferences_are_written_where_the_user_has_none(site: Site) -> None:
    path = home(site) / ".onika"  # R-B12
    assert site.keep_preferences(Preferences(pin_length=3)) is None
    assert site.preferences() == (Preferences(pin_length=3), ())
    assert site.keep_preferences(Preferences(pin_length=4)) is None
    assert site.preferences() == (Preferences(pin_length=3), ())
    path.unlink()
    path.symlink_to("nowhere")
    assert site.keep_preferences(Preferences()) is None
    assert path.is_symlink()
    assert Site(site.directories, site.prefs).keep_preferences(Preferences()) is None


def test_edited_preferences_keep_the_users_comments(site: Site) -> None:
    path = home(site) / ".onika"  # R-B01, R-B12
    path.write_text("# mine\nPINLENGTH 3\nEOF\n")
    former, _ = site.open_preferences()
    saved = site.save_preferences(Preferences(pin_length=4), former)
    text = path.read_text()
    assert text.startswith("# mine\nVERSION     1.3\n")
    assert preferences.read(text, "", "") == (Preferences(pin_length=4), ())
    assert isinstance(site.save_preferences(Preferences(), former), Refusal)
    assert site.open_preferences() == (saved, ())
    homeless = Site(site.directories, site.prefs)
    assert homeless.open_preferences() == (None, ())
    assert isinstance(homeless.save_preferences(Preferences()), Refusal)


def test_the_shipped_pictures_stand_for_missing_and_faulty_ones_of_start_and_stop(site: Site) -> None:
    (site.prefs / "OnikaStart.dta").write_text(picture.write(blank()).replace("777", "111"))  # R-B05
    (start, stop), faults = site.flow_pictures()
    assert "1" in start.rows[5]
    (_, shipped_stop), none = open_site([], {}, None).flow_pictures()
    assert (stop, none) == (shipped_stop, ())
    assert [fault.place.file for fault in faults] == [str(site.prefs / "OnikaStop.dta")]


def test_a_site_without_a_home_has_the_shipped_files(site: Site) -> None:
    homeless = Site(site.directories, site.prefs)
    assert homeless.syntax() == (SHIPPED, ())
    assert homeless.preferences() == (Preferences(), ())


def test_the_search_path_is_the_given_directories_the_environment_and_the_shipped_ones(tmp_path: Path) -> None:
    named = {"ONIKA_LOCAL": f"{tmp_path / 'b'}::{tmp_path / 'a'}"}  # R-C19, R-C20
    site = open_site([tmp_path / "a"], named, None)
    paths = [base.path for base in site.directories]
    assert paths == [tmp_path / "a", tmp_path / "b", *shipped_directories()]
    assert site.prefs == shipped() / "prefs"
    assert open_site([], {"ONIKA_DIR": "/opt/onika"}, None).prefs == Path("/opt/onika/prefs")


def test_buttons_are_opened_changed_and_saved_again(site: Site) -> None:
    assert site.open_buttons() == (None, ())  # R-G02
    first = site.save_buttons((Button("tea", "make tea"),))
    assert not isinstance(first, Refusal)
    opened, faults = site.open_buttons()
    assert (opened, faults) == (first, ())
    assert not isinstance(site.save_buttons((), opened), Refusal)
    assert isinstance(site.save_buttons((Button("late", "true"),), opened), Refusal)
    homeless = Site(site.directories, site.prefs)
    assert homeless.open_buttons() == (None, ())
    assert isinstance(homeless.save_buttons(()), Refusal)


def test_a_directory_of_the_users_own_is_searched_before_the_shipped_ones(tmp_path):  # R-C19, R-C20
    home = tmp_path / "home"
    assert open_site([], {}, home).own == home / "onika"
    paths = [base.path for base in open_site([], {}, home).directories]
    assert paths[0] == home / "onika"
    assert [is_shipped(path) for path in paths] == [False] + [True] * (len(paths) - 1)
    assert open_site([], {}, home).absent() == ()  # it comes into being with what is saved in it first
