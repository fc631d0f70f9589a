import pytest

from onika.files.icon import SLOTS, read_icon, write_icon
from onika.files.text_reading import TextReading
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.syntax import DataItem, IconType, Syntax
from onika.words.reason import NOTHING
from onika.words.value import ValueType

ITEMS = (
    DataItem("endpoint", ValueType.DOUBLE, 3),
    DataItem("file", ValueType.STRING, 2),
    DataItem("say", ValueType.LINE, 1),
)
SYNTAX = Syntax(
    (IconType("Joint object", 1, 0, ITEMS), IconType("Complete job", 0, 0), IconType("Joint job", 0, 1)), ()
)
PICT = "".join(f"PICT {row}\n" for row in blank().rows)
UI = 'UI 1 2.5 -3e-1\nUI a.txt "b c"\nUI turn  left\n'


def given(lines: str) -> tuple[Onikon | None, list[str], bool]:
    reading = TextReading("f", NOTHING)
    reading.open(lines + "EOF")
    onikon = read_icon("x", reading.arrange(reading.lines, SLOTS), SYNTAX, reading)
    faults = [f"{fault.place.line}: {fault.reason}" for fault in reading.faults]
    return onikon, faults, reading.broken


def target(ui: str = UI) -> tuple[Onikon | None, list[str], bool]:
    return given(f"ONIKON joint OBJECT\nDESC go  there\n{ui}{PICT}")


def test_values_are_read_by_the_data_items_of_the_type() -> None:
    values = ((1.0, 2.5, -0.3), ("a.txt", "b c"), ("turn  left",))  # R-B03, reading 40
    assert target() == (Onikon("x", "Joint object", "go there", values, blank()), [], False)


def test_a_line_value_may_stand_in_quotes() -> None:
    onikon, _, _ = target(UI.replace("turn  left", '" say \\"hi\\""'))
    assert onikon
    assert onikon.values[2] == (' say "hi"',)
    onikon, _, _ = target(UI.replace("turn  left", '"say" hi'))
    assert onikon
    assert onikon.values[2] == ('"say" hi',)


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("2.5", "", "3: expected 3 elements of type double for endpoint, found 2 in 'UI 1 -3e-1'"),
        ("2.5", "nan", "3: expected a finite number (double), found 'nan'"),
        ("2.5", "x", "3: expected a number (double), found 'x'"),
        ("UI turn  left\n", "", "4: expected 3 lines UI (endpoint, file, say), found 2"),
        ("UI turn  left\n", "UI\n", "5: expected 1 elements of type line for say, found 0 in 'UI'"),
        ('"b c"', '"b c', "4: expected words, those with blanks in double quotes, found '\"b c'"),
    ],
)
def test_wrong_values_are_named_with_their_line(old: str, new: str, expected: str) -> None:
    _, faults, broken = target(UI.replace(old, new))  # R-B07
    assert expected in faults
    assert broken


def test_an_action_has_no_values() -> None:
    assert given(f"ONIKON Complete job\nDESC\nUI none\n{PICT}")[1] == []
    assert given(f"ONIKON Complete job\nDESC\nUI 1\nUI none\n{PICT}")[1] == [
        "3: expected one line UI none for Complete job, found 'UI 1'",
        "4: expected one line UI none for Complete job, found 'UI none'",
    ]


def test_a_job_of_unknown_type_keeps_its_name_with_a_note() -> None:
    onikon, faults, broken = given(f"ONIKON Force job\nDESC\nUI none\n{PICT}")  # R-D16
    assert onikon
    assert onikon.type == "Force job"
    assert faults == ["1: expected a type of icon that the syntax defines, found 'ONIKON Force job'"]
    assert not broken


def test_a_target_of_unknown_type_is_left_out_with_a_note() -> None:
    onikon, faults, broken = given(f"ONIKON Force object\nDESC\nUI 1 2 3\n{PICT}")  # R-D16
    assert (onikon, len(faults), broken) == (None, 1, False)


def test_an_icon_is_written_so_that_it_reads_again() -> None:
    onikon, _, _ = target()
    assert onikon
    assert given(write_icon(onikon)) == (onikon, [], False)
    assert 'UI          "turn  left"\n' in write_icon(onikon)


def test_a_text_that_fits_on_no_line_cannot_be_written() -> None:
    with pytest.raises(ValueError, match="fits on a line"):
        write_icon(Onikon("x", "Joint object", "", (("two\nlines",),), blank()))
