import os
import stat
from datetime import UTC, datetime
from pathlib import Path

import pytest

from onika.record.black_box_folder import (
    black_box_folder,
    black_box_of,
    black_box_path,
    black_boxes,
    clear_unfinished,
    fault_path,
    is_being_written,
    rotate,
    write_black_box,
)

BEGAN = datetime(2026, 11, 21, 23, 15, tzinfo=UTC)


def made(folder, name, size=1, at=0):
    path = folder / name
    path.write_bytes(b"x" * size)
    os.utime(path, (at, at))
    return path


def test_it_lies_in_the_state_directory_of_the_user():  # R-X05
    assert black_box_folder({"XDG_STATE_HOME": "/s"}) == Path("/s/onika/black-boxes")
    assert black_box_folder({"XDG_STATE_HOME": "no", "HOME": "/h"}) == Path("/h/.local/state/onika/black-boxes")


@pytest.mark.parametrize(
    ("application", "name"),
    [("lift", "lift-20261121-231500-77-2.mcap"), ("../../etc/x", "_.._etc_x-20261121-231500-77-2.mcap")],
)
def test_a_name_from_elsewhere_leads_nowhere_else(tmp_path, application, name):  # R-X05
    path = black_box_path(tmp_path, application, BEGAN, 77, 2)
    assert (path.parent, path.name) == (tmp_path, name)


def test_the_newest_of_a_runtime_is_found(tmp_path):  # R-X05
    made(tmp_path, "a-20261121-231500-77-1.mcap", at=10)
    newest = made(tmp_path, "a-b-20261121-231501-77-2.mcap", at=20)
    made(tmp_path, "a-20261121-231502-7-1.mcap", at=30)
    assert black_box_of(tmp_path, 77) == newest
    assert black_box_of(tmp_path, 1) is None
    assert black_box_of(tmp_path / "none", 77) is None


def test_it_is_written_whole_or_not_at_all_and_for_its_user_only(tmp_path):  # R-X05
    folder = tmp_path / "boxes"
    write_black_box(folder / "a.mcap", lambda stream: stream.write(b"all") and None)

    def fail(stream):
        stream.write(b"half")
        raise OSError(28, "No space left on device")

    with pytest.raises(OSError, match="No space"):
        write_black_box(folder / "b.mcap", fail)
    assert [path.name for path in folder.iterdir()] == ["a.mcap"]
    assert stat.S_IMODE((folder / "a.mcap").stat().st_mode) == 0o600
    assert stat.S_IMODE(folder.stat().st_mode) == 0o700


def test_only_the_newest_are_kept(tmp_path):  # R-X05
    for number in range(6):
        made(tmp_path, f"{number}.mcap", at=number)
    rotate(tmp_path, kept=4)
    assert [path.name for path in black_boxes(tmp_path)] == ["5.mcap", "4.mcap", "3.mcap", "2.mcap"]


def test_all_together_are_bounded_but_the_newest_is_kept(tmp_path):  # R-X05
    for number in range(4):
        made(tmp_path, f"{number}.mcap", size=100, at=number)
    rotate(tmp_path, most_bytes=250)
    assert [path.name for path in black_boxes(tmp_path)] == ["3.mcap", "2.mcap"]
    rotate(tmp_path, most_bytes=50)
    assert [path.name for path in black_boxes(tmp_path)] == ["3.mcap"]


def test_what_a_power_cut_left_half_written_goes_later(tmp_path):  # R-X05
    half = made(tmp_path, "a.mcapx1.unfinished", at=10)
    made(tmp_path, "b.mcap", at=100)
    rotate(tmp_path)
    assert half.exists()
    made(tmp_path, "c.mcap", at=10_000)
    rotate(tmp_path)
    assert not half.exists()


def test_what_somebody_killed_left_unfinished_is_cleared_and_what_is_being_written_stays(tmp_path):  # R-X05
    (tmp_path / "run-1.mcapabc.unfinished").write_bytes(b"half")
    path = tmp_path / "run-2.mcap"

    def write(stream):
        stream.write(b"whole")
        clear_unfinished(tmp_path)

    write_black_box(path, write)
    assert [(one.name, one.read_bytes()) for one in tmp_path.iterdir()] == [("run-2.mcap", b"whole")]


def test_the_black_box_of_a_process_is_that_of_an_end_not_of_a_fault_before(tmp_path):  # R-X05
    end = tmp_path / "lift-20261121-231500-77-1.mcap"
    write_black_box(end, lambda stream: None)
    write_black_box(fault_path(end, 2), lambda stream: None)
    os.utime(fault_path(end, 2), (4e9, 4e9))
    assert black_box_of(tmp_path, 77) == end
    assert black_box_of(tmp_path, 7) is None


def test_it_is_being_written_until_it_is_there(tmp_path):  # R-X05
    path = tmp_path / "lift-20261121-231500-77-1.mcap"
    seen = []
    write_black_box(path, lambda stream: seen.append((is_being_written(tmp_path, 77), is_being_written(tmp_path, 7))))
    assert seen == [(True, False)]
    assert not is_being_written(tmp_path, 77)
