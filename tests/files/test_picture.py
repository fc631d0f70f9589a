import pytest

from onika.files.picture import read, read_rows, write
from onika.files.text_reading import TextReading
from onika.model.picture import SIZE, SIZES, blank
from onika.words.reason import NOTHING

TEXT = write(blank())


def result(text: str) -> list[str]:
    picture, faults = read(text, "start", "OnikaStart.dta")
    assert (picture is None) == any(not fault.is_note for fault in faults)
    return [f"{fault.place.line}: {fault.reason} / {fault.instead}" for fault in faults]


def test_a_picture_file_is_32_lines_of_32_digits() -> None:
    assert TEXT.count("\n") == SIZE  # R-B05
    assert read(TEXT, "start", "f") == (blank(), ())
    assert read(TEXT.replace("\n", "\r\n") + "\n\n", "start", "f") == (blank(), ())


@pytest.mark.parametrize("size", SIZES)
def test_rows_say_themselves_how_many_there_are(size: int) -> None:
    text = write(blank(size))  # R-B09
    assert read(text, "start", "f") == (blank(size), ())
    assert result(text.replace("78\n", "8\n", 1))


def test_what_is_wrong_with_a_larger_picture_is_told_of_the_size_that_most_rows_have() -> None:
    lines = write(blank(48)).splitlines()  # R-B09, R-B07
    stands = "the shipped picture stands for start"
    assert result("\n".join(lines[:-1])) == [f"47: expected 48 rows of a picture, found 47 / {stands}"]
    short = "\n".join([lines[0][:SIZE], *lines[1:]])
    assert result(short) == [f"1: expected 48 digits from 0 to 8, found '{'8' * SIZE}' / {stands}"]


def test_a_picture_of_another_size_than_may_be_is_refused_in_words() -> None:
    reading = TextReading("f", NOTHING)  # R-B09, R-B06
    read_rows([(at, row) for at, row in enumerate(blank(64).rows, start=5)], 68, reading, (SIZE,))
    (fault,) = reading.faults
    assert (fault.place.line, str(fault.reason)) == (
        5,
        "expected VERSION 2.0 for a picture of 64 rows, found an older one",
    )


def test_a_9_is_read_as_black_with_a_note() -> None:
    text = TEXT.replace("8777", "8977", 1)  # reading 38
    assert result(text) == ["2: expected colours from 0 to 8, found a 9 / it is read as black"]
    picture, _ = read(text, "start", "f")
    assert picture
    assert picture.rows[1].startswith("8877")


def test_a_coloured_border_is_read_as_black_with_one_note() -> None:
    expected = ["2: expected a black border, found another colour on it / the border is read as black"]
    assert result(TEXT.replace("\n87", "\n07")) == expected  # R-B11


def test_missing_and_wrong_rows_are_faults() -> None:
    stands = "the shipped picture stands for start"
    assert result("") == [f"0: expected 32 rows of a picture, found 0 / {stands}"]
    assert result(TEXT + TEXT) == [f"33: expected 32 rows of a picture, found 64 / {stands}"]
    assert len(result(TEXT.replace("8777", "x777", 3))) == 3
    assert read(TEXT.replace("8777", "x777", 3), "start", "f")[0] is None


def test_rows_of_icons_go_the_same_way() -> None:
    reading = TextReading("f", NOTHING)
    rows = [(number + 5, row) for number, row in enumerate(blank().rows)]
    assert read_rows(rows, 36, reading, SIZES) == blank()
    read_rows(rows[:-1], 36, reading, SIZES)
    assert [fault.place.line for fault in reading.faults] == [36]
