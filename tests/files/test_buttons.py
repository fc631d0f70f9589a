import pytest

from onika.files.buttons import read, write
from onika.model.button import Button

BUTTONS = (Button("my clock", "xclock -bg  white", False), Button("edit", "vi ~/.onika", True))
TEXT = write(BUTTONS)


def test_buttons_are_read_and_written() -> None:
    assert read(TEXT, ".onika.buttons", "f") == (BUTTONS, ())  # R-B05, R-G02
    assert "BUTTON      my clock\nFUNCTION    xclock -bg  white\nSPAWNNTTY   no\n" in TEXT


def test_both_spellings_of_the_terminal_are_read() -> None:
    assert read(TEXT.replace("SPAWNNTTY", "SPAWNTTY"), ".onika.buttons", "f") == (BUTTONS, ())


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("FUNCTION    vi ~/.onika", "FUNCTION", "expected text after FUNCTION, found 'FUNCTION'"),
        ("FUNCTION    vi ~/.onika\n", "", "expected a line FUNCTION, found none"),
        ("SPAWNNTTY   yes", "SPAWNNTTY 1", "expected yes or no after SPAWNNTTY, found 'SPAWNNTTY 1'"),
        ("BUTTON      edit", "BUTTOM edit", "expected no more lines here, found 'BUTTOM edit'"),
    ],
)
def test_what_is_wrong_is_named(old: str, new: str, expected: str) -> None:
    buttons, faults = read(TEXT.replace(old, new), ".onika.buttons", "f")  # R-B07
    assert buttons is None
    assert expected in [f"{fault.reason}" for fault in faults]


def test_a_file_without_buttons_is_legal() -> None:
    assert read("VERSION 1.3\nEOF", "b", "f") == ((), ())
    assert read("EOF", "b", "f") == ((), ())


def test_comments_of_the_former_text_are_kept() -> None:
    former = TEXT.replace("BUTTON      edit", "# mine\nBUTTON      edit")
    assert write(BUTTONS, former) == former
