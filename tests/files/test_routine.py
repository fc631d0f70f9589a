from dataclasses import replace

import pytest

from onika.files.routine import is_extended, marked, read_condition, read_routine, write_routine
from onika.files.text_reading import TextReading
from onika.model.application import Hole, Icon
from onika.model.onikon import Onikon
from onika.model.picture import blank
from onika.model.syntax import IconType, Syntax
from onika.words.reason import Reason

SYNTAX = Syntax(tuple(IconType(name, 0, 0) for name in ("Complete job", "Joint job", "Joint object")), ())
OPEN = Icon(Onikon("open", "Complete job", "", (), blank()))
MOVE = Icon(Onikon("move", "Joint job", "", (), blank()))
HOME = Icon(Onikon("home", "Joint object", "", (), blank()))
CONDITIONAL = replace(
    OPEN, marker=True, marker_if="flow0/Q[2] > 1.5", while_tag="again", while_test=True, while_if="LAMP == 1"
)


def opened(text: str, version: str = "2.0") -> TextReading:
    reading = TextReading("f", Reason.plain("it is left out"))
    reading.open_versioned(f"VERSION {version}\n{text}EOF\n", extended=True)
    reading.lines = reading.lines[1:]
    return reading


def again(icon: Icon) -> Icon | Hole | None:
    reading = opened(write_routine(icon))
    routine = read_routine(reading.lines, SYNTAX, reading)
    assert reading.faults == ()
    return routine


@pytest.mark.parametrize(
    "icon",
    [
        OPEN,
        CONDITIONAL,
        replace(CONDITIONAL, marker=False),
        replace(MOVE, onikon=replace(MOVE.onikon, more_targets=("Joint object",))),
        replace(OPEN, onikon=replace(OPEN.onikon, picture=blank(64))),
    ],
)
def test_an_icon_is_read_as_it_was_written(icon: Icon) -> None:
    assert again(icon) == icon  # R-D13
    assert is_extended(icon) == (icon is not OPEN)


def test_conditions_stand_behind_their_marks() -> None:
    lines = [" ".join(line.split()) for line in write_routine(replace(CONDITIONAL, synch_tag="meet")).splitlines()]
    assert lines[1:7] == [
        "MARKER yes",
        "MARKERIF flow0/Q[2] > 1.5",
        "SYNCHTAG meet",
        "WHILETAG again",
        "WHILETEST yes",
        "WHILEIF LAMP == 1",
    ]


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (
            "MARKERIF    flow0/Q[2] > 1.5",
            "MARKERIF    Q^",
            "expected a condition such as LAMP == 1 after MARKERIF, found 'MARKERIF Q^'",
        ),
        ("WHILEIF     LAMP == 1", "WHILEIF", "expected a condition such as LAMP == 1 after WHILEIF, found 'WHILEIF'"),
        ("WHILETAG    again\nWHILETEST   yes\n", "", "expected WHILETEST before WHILEIF, found none"),
        ("WHILETEST   yes\n", "", "expected WHILETEST after WHILETAG, found none"),
    ],
)
def test_a_wrong_condition_is_a_fault(old: str, new: str, expected: str) -> None:
    reading = opened(write_routine(CONDITIONAL).replace(old, new))  # R-B07
    read_routine(reading.lines, SYNTAX, reading)
    assert expected in [str(fault.reason) for fault in reading.faults]
    assert reading.broken


def test_under_an_older_version_conditions_are_refused_line_by_line() -> None:
    reading = opened(write_routine(CONDITIONAL), "1.3")  # R-B06
    read_routine(reading.lines, SYNTAX, reading)
    assert [(fault.place.line, str(fault.reason)) for fault in reading.faults] == [
        (4, "expected VERSION 2.0 for a line MARKERIF, found 'MARKERIF flow0/Q[2] > 1.5'"),
        (7, "expected VERSION 2.0 for a line WHILEIF, found 'WHILEIF LAMP == 1'"),
    ]


def test_no_line_is_no_condition() -> None:
    reading = opened("")
    assert read_condition(None, reading) == ""
    assert reading.faults == ()


@pytest.mark.parametrize(
    ("job", "target", "expected"),
    [
        ({}, {"marker": True, "marker_if": "A == 1"}, {"marker": True, "marker_if": "A == 1"}),
        ({"marker": True}, {"marker_if": "A == 1"}, {"marker": True}),
        ({"marker_if": "A == 1"}, {"marker": True}, {"marker": True}),
        ({"marker_if": "A == 1"}, {"marker_if": "B == 1"}, {"marker_if": "A == 1"}),
        ({"synch_tag": "x"}, {"while_tag": "y", "while_test": True, "while_if": "A == 1"},
         {"synch_tag": "x", "while_tag": "y", "while_test": True, "while_if": "A == 1"}),
    ],
)  # fmt: skip
def test_the_marks_of_a_target_go_to_its_job(
    job: dict[str, object], target: dict[str, object], expected: dict[str, object]
) -> None:
    reading = opened("")  # reading 24
    whole, bare = marked(replace(MOVE, **job), replace(HOME, **target), reading)  # type: ignore[arg-type]
    assert reading.faults == ()
    assert whole == replace(MOVE, **expected)  # type: ignore[arg-type]
    assert bare == HOME


@pytest.mark.parametrize(
    ("job", "target", "meaning"),
    [
        ({"marker": True}, {"marker": True, "marker_if": "A == 1"}, "breakpoint"),
        ({"while_tag": "a", "while_if": "A == 1"}, {"while_tag": "a", "while_if": "B == 1"}, "condition of a loop"),
        ({"while_tag": "a"}, {"while_tag": "b"}, "while tag"),
    ],
)  # fmt: skip
def test_two_different_marks_of_one_kind_are_a_fault(
    job: dict[str, object], target: dict[str, object], meaning: str
) -> None:
    reading = opened("")
    marked(replace(MOVE, **job), replace(HOME, line=8, **target), reading)  # type: ignore[arg-type]
    (fault,) = reading.faults
    assert (fault.place.line, fault.reason.key) == (8, "files.icons_disagree")
    assert str(fault.reason.args["meaning"]) == meaning
