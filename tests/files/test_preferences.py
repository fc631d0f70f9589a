from dataclasses import replace

import pytest

from onika.files.preferences import read, write
from onika.model.preferences import Preferences, Window, WindowCorner

TEXT = write(Preferences())


def result(text: str) -> list[str]:
    _, faults = read(text, ".onika", ".onika")
    return [f"{fault.reason}" for fault in faults]


def test_preferences_are_read_and_written() -> None:
    mine = replace(  # R-G01
        Preferences(),
        pin_length=3,
        show_invar=False,
        shows_period=True,
        library=Window(1, 2, 3, 4),
        main=WindowCorner(-5, 6),
        status_columns=("tid", "S"),
    )
    text = write(mine)
    assert read(text, ".onika", "f") == (mine, ())
    for line in ("PINLENGTH   3", "INVAR       no", "RATE        period", "LEXI        1 2 3 4", "MAIN        -5 6"):
        assert line + "\n" in text


def test_every_preference_may_be_missing() -> None:
    assert read("VERSION 1.3\nEOF", ".onika", "f") == (Preferences(), ())  # R-B12
    assert read("HITTOL 9\nEOF", ".onika", "f") == (replace(Preferences(), hit_tolerance=9), ())


def test_both_spellings_of_the_step_size_are_read() -> None:
    for word in ("STEPSIZE", "STEPWISE"):
        assert read(f"{word} 9\nEOF", ".onika", "f") == (replace(Preferences(), step_size=9), ())


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("LINELEN     12", "LINELEN x", "expected a whole number of at least 1 after LINELEN, found 'LINELEN x'"),
        ("LINELEN     12", "LINELEN 0", "expected a whole number of at least 1 after LINELEN, found 'LINELEN 0'"),
        (
            "LEXI        0 0 480 320",
            "LEXI 0 0 0 3",
            "expected a height and width above 0 after LEXI, found 'LEXI 0 0 0 3'",
        ),
        ("RATE        frequency", "RATE often", "expected frequency or period after RATE, found 'RATE often'"),
    ],
)
def test_the_default_stands_for_a_wrong_line_and_the_others_count(old: str, new: str, expected: str) -> None:
    text = TEXT.replace(old, new).replace("HITTOL      5", "HITTOL      8")  # R-B07, R-B12
    assert result(text) == [expected]
    assert read(text, ".onika", "f")[0] == replace(Preferences(), hit_tolerance=8)


def test_unknown_status_columns_are_named() -> None:
    assert len(result("STATINFO tid what\nEOF")) == 1
    assert len(result("STATINFO tid tid\nEOF")) == 1


def test_a_newer_file_gives_the_defaults() -> None:
    preferences, (fault,) = read("VERSION 9\nLINELEN 3\nEOF", ".onika", "f")  # R-B06
    assert preferences == Preferences()
    assert str(fault.instead) == "the defaults stand for what is wrong in .onika"
