from pathlib import Path

import pytest

from onika.store.base_directory import BaseDirectory
from onika.store.repeated_names import folded
from onika.store.site import Site
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

OTHER = Fault(Place("a.conf", 3), Reason.plain("something else"), Reason.plain("left out"))


def repeated(path: Path, count: int) -> tuple[Fault, ...]:
    """What two directories give of which the second is a copy of the first."""
    for base in ("first", "second"):
        (path / base / "appl").mkdir(parents=True)
        for number in range(count):
            (path / base / "appl" / f"program{number}.appl").write_text("")
    return Site((BaseDirectory(path / "first"), BaseDirectory(path / "second")), path / "prefs").duplicates()


@pytest.mark.parametrize("count", [1, 3])
def test_a_few_names_are_told_each_by_itself(tmp_path, count):  # R-D15
    notes = repeated(tmp_path, count)
    assert len(notes) == count
    assert folded((OTHER, *notes)) == [OTHER, *notes]


def test_of_a_copied_directory_one_note_tells_all_names(tmp_path):  # R-D15, R-B08
    notes = repeated(tmp_path, 12)
    assert len(notes) == 12
    together, last = folded((*notes, OTHER))
    assert last == OTHER
    assert (together.place.file, together.is_note) == (str(tmp_path / "second" / "appl"), True)
    assert together.reason.key == "store.names_twice"
    assert together.reason.args["count"] == 12
    assert together.reason.args["path"] == str(tmp_path / "first" / "appl")
    assert together.instead == notes[0].instead


def test_the_copies_of_two_directories_are_told_apart(tmp_path):  # R-D15
    notes = (*repeated(tmp_path / "a", 5), *repeated(tmp_path / "b", 5))
    assert len(folded(notes)) == 2
