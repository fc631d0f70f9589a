import pytest

from onika.store.folder_arrangement import FolderArrangement, in_order
from onika.store.shipped import shipped
from onika.words.fault import Refusal


def test_the_order_of_a_folder_stands_beside_what_is_in_it(tmp_path):  # R-D24
    place = FolderArrangement.of(tmp_path / "dict", tmp_path / "own")
    assert place.names() == ((), ())
    assert place.saved(("b", "a")) is None
    assert place.file == tmp_path / "dict" / "OnikaArrangement.dta"
    assert place.names() == (("b", "a"), ())
    assert place.saved(("a", "b")) is None
    assert place.names()[0] == ("a", "b")


def test_what_is_shipped_is_arranged_in_the_users_own_directory(tmp_path):  # R-D24, R-B07
    puma, generic = (FolderArrangement.of(shipped() / name / "module", tmp_path) for name in ("puma", "generic"))
    assert puma.file == generic.file == tmp_path / "module" / "OnikaArrangement.dta"
    assert puma.saved(("x",)) is None and generic.saved(("y",)) is None
    assert (puma.names()[0], generic.names()[0]) == (("x",), ("y",))
    assert isinstance(FolderArrangement.of(shipped() / "puma" / "dict", None), Refusal)


def test_a_file_at_fault_is_told_and_never_written_over(tmp_path):  # R-B07
    place = FolderArrangement.of(tmp_path / "dict", None)
    place.file.parent.mkdir()
    place.file.write_text("PLACE a\n")
    names, faults = place.names()
    assert names == () and faults
    assert isinstance(place.saved(("b",)), Refusal)
    assert place.file.read_text() == "PLACE a\n"


@pytest.mark.parametrize(
    ("arranged", "expected"), [((), "abc"), (("c", "a"), "cab"), (("x", "b"), "bac"), (("c", "b", "a"), "cba")]
)
def test_names_that_nobody_has_placed_come_behind(arranged, expected):  # R-D24
    assert "".join(in_order("abc", arranged)) == expected
