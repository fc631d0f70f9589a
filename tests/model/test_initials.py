import pytest

from onika.model.initials import drawn, initials
from onika.model.picture import blank


@pytest.mark.parametrize(
    ("name", "letters"),
    [("assemble", "A"), ("go_home", "GH"), ("box2.aj-x", "BA"), ("jmoveC", "JC"), ("x9", "X"), ("a_1", "A1")],
)
def test_the_initials_of_a_name_are_those_of_its_first_two_words(name: str, letters: str) -> None:
    assert initials(name) == letters  # §5.6.2


def test_a_picture_shows_its_letters_in_black_on_white() -> None:
    rows = drawn("L").rows
    shown = [row[1:-1] for row in rows[1:-1]]
    assert {sign for row in shown for sign in row} == {"7", "8"}
    stem = [at for at, row in enumerate(rows) if at not in (0, 31) and row[8:11] == "888"]
    assert len(stem) == 21
    assert rows[stem[-1]][8:23] == "8" * 15
    assert rows[stem[0]][11:23] == "7" * 12


def test_two_letters_are_smaller_and_apart() -> None:
    columns = [all(row[at] == "7" for row in drawn("I_I").rows[1:-1]) for at in range(32)]
    assert columns[15:17] == [True, True]
    assert drawn("I_I") != drawn("I")


def test_what_has_no_letters_is_blank() -> None:
    assert drawn("é") == blank()
