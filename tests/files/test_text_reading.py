import pytest

from onika.files.line import FileLine
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.words.reason import NOTHING, Reason

SLOTS = (
    KeywordSlot("A"),
    KeywordSlot("B", Need.SINCE_1_3),
    KeywordSlot("C", Need.OPTIONAL, many=True),
    KeywordSlot("D", Need.OPTIONAL),
)

REASON = Reason.plain("expected a, found b")


def opened(text: str, versioned: bool = False) -> TextReading:
    reading = TextReading("f", Reason.plain("it is left out"))
    (reading.open_versioned if versioned else reading.open)(text)
    return reading


def result(reading: TextReading) -> list[str]:
    return [f"{fault.place.line}: {fault.reason}" for fault in reading.faults]


def arranged(text: str, is_old: bool = False) -> list[str]:
    reading = opened(text + "\nEOF")
    reading.is_old = is_old
    reading.arrange(reading.lines, SLOTS)
    return result(reading)


def test_comments_and_blank_lines_are_no_lines_and_blanks_count_as_one() -> None:
    reading = opened("# x\n\n \tA \t 1  2\t\n  # y\nB\r\nEOF\n\n# end")  # R-B01
    assert reading.lines == [FileLine(3, "A", "1  2"), FileLine(5, "B", "")]
    assert reading.lines[0].words == ("1", "2")
    assert reading.lines[0].text == "1 2"
    assert result(reading) == []


def test_a_sign_within_a_line_begins_no_comment() -> None:
    assert opened("A x # y\nEOF").lines[0].rest == "x # y"


def test_a_file_without_eof_is_truncated() -> None:
    reading = opened("A 1\nB 2\n")  # R-B07
    assert result(reading) == ["2: expected EOF as the last line, found the end of the file after 'B 2'"]
    assert reading.broken


def test_an_empty_file_is_a_fault() -> None:
    assert result(opened("")) == ["0: expected lines with keywords and EOF, found an empty file"]
    assert result(opened("\n# only this\n")) == ["0: expected lines with keywords and EOF, found an empty file"]


def test_nothing_may_follow_eof() -> None:
    assert result(opened("EOF x\nA 1\n")) == [
        "1: expected EOF alone on its line, found 'EOF x'",
        "2: expected nothing after EOF, found 'A 1'",
    ]


def test_a_nul_byte_is_named_with_its_line() -> None:
    assert result(opened("A 1\nB \x002\nEOF")) == ["2: expected printable text, found 'B \\x002'"]  # R-B07


def test_a_fault_prints_as_the_requirement_says() -> None:
    reading = opened("A\n")  # R-B07
    assert str(reading.faults[0]) == (
        "f:1: expected EOF as the last line, found the end of the file after 'A'; instead: it is left out"
    )


def test_a_whole_text_or_a_part_of_it_is_left_out_or_nothing_at_all() -> None:
    reading = TextReading("f", Reason.plain("all of it is left out"))  # R-B07
    reading.note(1, REASON, Reason.plain("it is read as c"))
    reading.part(2, REASON, Reason.plain("this is left out"))
    assert not reading.broken
    reading.fault(3, REASON)
    assert reading.broken
    assert [(fault.is_note, str(fault.instead)) for fault in reading.faults] == [
        (True, "it is read as c"),
        (False, "this is left out"),
        (False, "all of it is left out"),
    ]


def test_faults_come_in_the_order_of_the_lines() -> None:
    reading = TextReading("f", NOTHING)
    reading.note(5, REASON, NOTHING)
    reading.fault(2, REASON)
    assert [fault.place.line for fault in reading.faults] == [2, 5]


@pytest.mark.parametrize("text", ["A\nB", "A\nB\nC\nC\nD", "A\nB\nD"])
def test_lines_in_order_are_right(text: str) -> None:
    assert arranged(text) == []  # reading 41


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("B\nA", ["2: expected A before B, found 'A' after it"]),
        ("A\nB\nD\nC", ["4: expected C before D, found 'C' after it"]),
        ("A\nA\nB", ["2: expected A once, found 'A' again"]),
        ("A\nX 1\nB", ["2: expected B, found 'X 1'"]),
        ("A\nB\nC\nX", ["4: expected C or D, found 'X'"]),
        ("A\nB\nD\nX", ["4: expected no more lines here, found 'X'"]),
        ("B\nD", ["1: expected a line A, found none"]),
        ("A", ["1: expected a line B, found none"]),
        ("X\nY", ["1: expected A, found 'X'", "2: expected A, found 'Y'", "2: expected a line B, found none"]),
        ("X 1\nB", ["1: expected A, found 'X 1'"]),
    ],
)
def test_every_line_out_of_order_is_named(text: str, expected: list[str]) -> None:
    assert arranged(text) == expected  # reading 41


def test_an_older_file_may_lack_lines() -> None:
    assert arranged("A", is_old=True) == []  # R-B06
    assert arranged("B", is_old=True) == ["1: expected a line A, found none"]


@pytest.mark.parametrize(
    ("version", "is_old"), [("1.3", False), ("1.3.0", False), ("1.2.9", True), ("0.9", True), (None, True)]
)
def test_files_of_older_versions_are_known(version: str | None, is_old: bool) -> None:
    reading = opened(f"VERSION {version}\nEOF" if version else "A\nEOF", versioned=True)  # R-B06
    assert (reading.is_old, reading.is_over, result(reading)) == (is_old, False, [])


@pytest.mark.parametrize("version", ["1.4", "1.3.1", "2", "10.0"])
def test_a_newer_file_is_refused_with_one_fault(version: str) -> None:
    reading = opened(f"VERSION {version}\nNEW\x00 \n", versioned=True)  # R-B06
    assert reading.is_over
    assert result(reading) == [f"1: expected a file of version 1.3 or older, found version {version}, which is newer"]


@pytest.mark.parametrize("version", ["", "new", "1.3x", "-1", "1..3", "1 3"])
def test_a_version_that_is_no_number_is_a_fault(version: str) -> None:
    reading = opened(f"VERSION {version}\nEOF", versioned=True)
    assert reading.broken
    assert not reading.is_over


def test_the_words_of_a_line_are_checked_and_a_default_stands_for_wrong_ones() -> None:
    reading = TextReading("f", NOTHING)
    assert reading.whole(FileLine(1, "N", "7"), 3) == 7
    assert reading.whole(None, 3) == 3
    assert reading.whole(FileLine(2, "N", "x"), 3) == 3
    assert reading.whole(FileLine(3, "N", "-1"), 3, low=0) == 3
    assert reading.wholes(FileLine(4, "XY", "1 2 3"), (5, 6)) == (5, 6)
    assert reading.wholes(FileLine(5, "XY", "1 99999999999"), (5, 6)) == (5, 6)
    assert reading.yes(FileLine(6, "Y", "yes"), default=False) is True
    assert reading.yes(FileLine(7, "Y", "Yes"), default=False) is False
    assert reading.word(FileLine(8, "W", "one two"), Reason.plain("a tag"), "d") == "d"
    assert result(reading) == [
        "2: expected a whole number after N, found 'N x'",
        "3: expected a whole number of at least 0 after N, found 'N -1'",
        "4: expected 2 whole numbers after XY, found 'XY 1 2 3'",
        "5: expected 2 whole numbers after XY, found 'XY 1 99999999999'",
        "7: expected yes or no after Y, found 'Y Yes'",
        "8: expected a tag after W, found 'W one two'",
    ]
