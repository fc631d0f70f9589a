import pytest

from onika.files.line import FileLine, is_number, one_line, parse_line, row, show, show_number, split


@pytest.mark.parametrize("text", ["", " \t ", "# x", "  # y"])
def test_a_comment_and_a_blank_line_are_no_lines(text: str) -> None:
    assert parse_line(1, text) is None  # R-B01


def test_a_line_is_its_keyword_and_what_follows_whatever_stands_between() -> None:
    assert parse_line(3, " \tA \t 1  2\t") == FileLine(3, "A", "1  2")  # R-B01
    assert parse_line(4, "A\tx") == FileLine(4, "A", "x")
    assert parse_line(5, "B") == FileLine(5, "B", "")


def test_lines_are_cut_into_blocks_at_their_heads() -> None:
    lines = [FileLine(number, keyword, "") for number, keyword in enumerate("VABBA")]
    assert [[line.keyword for line in block] for block in split(lines, {"A"})] == [["V"], ["A", "B", "B"], ["A"]]
    assert split([], {"A"}) == [[]]


@pytest.mark.parametrize(
    ("word", "expected"),
    [("1", True), ("-.5e3", True), ("1.", True), ("nan", False), ("1_0", False), ("0x1", False), ("", False)],
)
def test_a_number_is_decimal(word: str, expected: bool) -> None:
    assert is_number(word) is expected


@pytest.mark.parametrize(("value", "text"), [(500.0, "500"), (0.004, "0.004"), (1e300, "1e+300"), (-0.5, "-0.5")])
def test_numbers_are_written_short(value: float, text: str) -> None:
    assert show_number(value) == text
    assert float(text) == value


def test_a_row_has_its_words_in_a_column() -> None:
    assert row("NUMDOUBLEIN", "3") == "NUMDOUBLEIN 3\n"
    assert row("FREQ", "1", "2") == "FREQ        1 2\n"
    assert row("EOF") == "EOF\n"


def test_a_text_is_made_to_fit_on_a_line() -> None:
    assert one_line(" a \n\t b\x00c ") == "a b c"


def test_a_long_text_is_shortened_in_messages() -> None:
    assert len(show("x" * 500)) == 60
