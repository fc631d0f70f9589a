import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from kit.desk.library_desk import LibraryDesk
from kit.labs.kept_library import KeptLibrary
from kit.labs.library_site import wink
from onika.desk.environment.diary_values import given
from onika.store.replaced_texts import ReplacedTexts
from onika.wire import act

RMOD = "module/wink.rmod"


@pytest.fixture
def kept(tmp_path):
    with KeptLibrary(tmp_path) as kept:
        yield kept


@pytest.fixture
def desk(tmp_path, kept):
    desk = LibraryDesk(tmp_path, kept.today)
    address = kept.server.address
    desk.value(act.TakeLibrary(address, desk.value(act.BrowseLibrary(address)).digest))
    return desk


def own(desk):
    return desk.site.own / RMOD


def change(desk, text):
    own(desk).parent.mkdir(parents=True, exist_ok=True)
    own(desk).write_text(text)


def send(desk, **more):
    return desk.value(act.SendBack("wings", (RMOD,), **more))


def test_what_own_copies_change_is_counted_and_shown(desk):  # R-F03
    assert desk.value(act.ListRemoteLibraries())[0].changed == 0
    mine = wink(says="winks slowly")
    change(desk, mine)
    assert desk.value(act.ListRemoteLibraries())[0].changed == 1
    (shown,) = desk.value(act.ListOwnChanges("wings"))
    assert (shown.path, shown.before, shown.mine, shown.is_text) == (RMOD, wink(), mine, True)
    own(desk).write_bytes(b"\xff\xfe")
    assert not desk.value(act.ListOwnChanges("wings"))[0].is_text


def test_a_change_is_sent_back_and_counts_no_longer(desk, kept):  # R-F03
    mine = wink(says="winks for ann")
    change(desk, mine)
    sent = send(desk, note="signed")
    assert (sent.version, sent.paths, sent.held) == (2, (RMOD,), ())
    assert kept.text(RMOD) == mine
    (used,) = desk.value(act.ListRemoteLibraries())
    assert (used.version, used.changed) == (2, 0)


def test_what_others_have_changed_elsewhere_is_merged_shown_and_agreed_to(desk, kept, tmp_path):  # R-F03
    theirs = "# by bob\n" + wink()
    change(desk, wink(says="winks for ann"))
    kept.change((RMOD, wink(), theirs))
    held = send(desk)
    assert held.version == 0 and kept.text(RMOD) == theirs
    ((file,), agreement) = held.held, held.agreement
    assert (file.contradicts, file.other) == (False, "# by bob\n" + wink(says="winks for ann"))
    assert send(desk, agreed="another").version == 0
    assert send(desk, agreed=agreement).version == 3
    assert kept.text(RMOD) == own(desk).read_text() == file.other
    assert [text.text for text in ReplacedTexts(tmp_path / "state").listed()] == [wink(says="winks for ann")]


def test_a_contradiction_shows_both_and_sends_nothing_until_one_counts(desk, kept):  # R-F03
    mine, theirs = (wink(says=word) for word in ("winks slowly", "winks fast"))
    change(desk, mine)
    kept.change((RMOD, wink(), theirs))
    held = send(desk)
    (file,) = held.held
    assert (held.version, file.contradicts, file.mine, file.other, held.agreement) == (0, True, mine, theirs, "")
    assert kept.text(RMOD) == theirs and own(desk).read_text() == mine
    assert send(desk, is_mine=True).version == 3
    assert kept.text(RMOD) == mine


def test_a_password_is_asked_for_and_not_written_down(desk, kept):  # R-F03
    change(desk, wink(says="winks for ann"))
    kept.server.password = "ann:secret"
    command = act.SendBack("wings", (RMOD,), user="ann", secret="secret")
    no = desk.later(act.SendBack("wings", (RMOD,))).no
    assert no is not None and "secret" in no.fields
    assert desk.value(command).version == 2
    assert not {"secret", "user"} & given(command, (), ()).keys()


def test_what_is_no_change_or_no_library_is_told(desk, tmp_path):  # R-F03
    assert desk.later(act.SendBack("wings", (RMOD,))).no.reason.key == "store.no_own_file"
    assert desk.later(act.SendBack("birds", (RMOD,))).no.reason.key == "store.library_unknown"
    assert desk.later(act.ListOwnChanges("birds")).no.reason.key == "store.library_unknown"
    for command in (act.ListOwnChanges("x"), act.SendBack("x", ())):
        assert EnvironmentFixture(tmp_path).no(command).reason.key == "desk.no_remote_libraries"
