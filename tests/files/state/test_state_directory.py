import stat
from pathlib import Path

import pytest

from onika.files.state.access import ANYTHING, WRITING, guard
from onika.files.state.state_directory import guarded, make_own, state_directory


@pytest.mark.parametrize(
    ("environment", "folder"),
    [
        ({"XDG_STATE_HOME": "/s", "HOME": "/h"}, "/s/onika"),
        ({"XDG_STATE_HOME": "relative", "HOME": "/h"}, "/h/.local/state/onika"),
        ({"HOME": "/h"}, "/h/.local/state/onika"),
    ],
)
def test_it_lies_where_the_system_says(environment, folder):
    assert state_directory(environment) == Path(folder)


def test_without_a_home_it_is_that_of_the_user():
    assert state_directory({}) == Path.home() / ".local" / "state" / "onika"


def test_what_is_made_on_the_way_is_for_its_user_only_and_what_was_there_stays(tmp_path):  # R-X12
    tmp_path.chmod(0o755)
    make_own(tmp_path / "state" / "onika" / "audit")
    make_own(tmp_path / "state" / "onika" / "audit")
    folders = [tmp_path / "state", tmp_path / "state" / "onika", tmp_path / "state" / "onika" / "audit"]
    assert [stat.S_IMODE(folder.stat().st_mode) for folder in folders] == [0o700] * 3
    assert stat.S_IMODE(tmp_path.stat().st_mode) == 0o755


def test_where_a_file_is_in_the_way_that_is_an_error(tmp_path):
    (tmp_path / "state").write_text("")
    with pytest.raises(OSError):
        make_own(tmp_path / "state")


def test_secrets_are_kept_from_reading_and_recordings_from_writing(tmp_path):  # R-X12
    for name in (
        "token",
        "console_history",
        "staying",
        "staying.log",
        "bookings",
        "sites",
        "page-users",
        "address-book",
        "audit/audit.log",
        "diary/a.log",
        "black-boxes/a.mcap",
        "recordings/a.mcap",
    ):
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        path.write_text("")
    denied = {access.path.relative_to(tmp_path).as_posix(): access.denied for access in guarded(tmp_path)}
    assert denied.pop("recordings/a.mcap") == WRITING
    assert set(denied.values()) == {ANYTHING}
    named = {
        ".",
        "token",
        "console_history",
        "staying",
        "staying.log",
        "bookings",
        "sites",
        "page-users",
        "address-book",
        "audit",
        "audit/audit.log",
        "diary",
        "diary/a.log",
        "black-boxes",
        "library-tokens",
        "replaced",
    }
    others = {"black-boxes/a.mcap", "recordings", "recovery", "replaced", "meshes", "certificates", "browser"}
    assert set(denied) == named | others


def test_a_state_directory_of_before_is_closed_at_the_next_start(tmp_path):  # R-X12
    state = tmp_path / "onika"
    (state / "diary").mkdir(parents=True)
    log = state / "diary" / "a.log"
    log.write_text("who did what")
    for path, mode in ((state, 0o755), (state / "diary", 0o775), (log, 0o644)):
        path.chmod(mode)
    assert guard(guarded(state)).mended == (state, state / "diary", log)
    assert guard(guarded(state)).sentences == ()
