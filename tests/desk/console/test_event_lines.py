import pytest

from onika.desk.console.display import Tone
from onika.desk.console.event_lines import lines as event_lines
from onika.wire import event
from onika.words.reason import NOTHING, Reason


def lines(message):
    return [(str(line), tone) for line, tone in event_lines(message)]


@pytest.mark.parametrize(
    ("message", "line", "tone"),
    [
        (event.Began(0, 1, 4, "jmoveC home", 2.5), "     2.50 s  2/4  jmoveC home", Tone.PLAIN),
        (event.TaskState("main", "puma", "ON", 1.0), "     1.00 s  main/puma ON", Tone.GOOD),
        (event.TaskState("main", "puma", "OFF", 1.0), "     1.00 s  main/puma OFF", Tone.DIM),
        (event.Warned("main", "puma", Reason.plain("late"), 1.0), "     1.00 s  note: main/puma: late", Tone.NOTE),
        (event.Warned("", "", Reason.plain("late"), 1.0), "     1.00 s  note: late", Tone.NOTE),
        (
            event.Stepped("main", "puma", "TAU_REF", "N m", 1, 40.0, 9.0, 9.76, 6, 1.0),
            "     1.00 s  note: main/puma: TAU_REF[1] stepped by 40 N m at a switch, more than 9.76 N m a cycle: "
            "blended over 6 cycles",
            Tone.NOTE,
        ),
        (
            event.Drive("boxes:arm", "PRESSED", 9, 0, 0, Reason.plain("panic button pressed"), 1.0),
            "     1.00 s  drive boxes:arm PRESSED: panic button pressed",
            Tone.FAULT,
        ),
        (
            event.Drive("boxes:arm", "TRIPPED", 9, 0, 0, Reason.plain("silent"), 1.0),
            "     1.00 s  drive boxes:arm TRIPPED: silent",
            Tone.FAULT,
        ),
        (event.Drive("boxes:arm", "HELD", 9, 0, 0, NOTHING, 1.0), "     1.00 s  drive boxes:arm HELD", Tone.DIM),
        (
            event.Signalled("main", "jtraj", "FINISH", 1, NOTHING, 1.0),
            "     1.00 s  main/jtraj signals FINISH 1",
            Tone.NOTE,
        ),
        (
            event.Signalled("main", "x", "ILLEGAL", 0, Reason.plain("why"), 1.0),
            "     1.00 s  main/x signals ILLEGAL: why",
            Tone.NOTE,
        ),
        (event.Lost("rt1", Reason.plain("killed"), 1.0), "     1.00 s  LOST rt1: killed", Tone.FAULT),
        (event.Outdated("cell", True, Reason.plain("changed"), 1.0), "     1.00 s  note: changed", Tone.NOTE),
        (event.Held("main", ""), "main is held by nobody", Tone.NOTE),
        (event.Held("main", "", Reason.plain("silent")), "main is held by nobody: silent", Tone.NOTE),
        (event.Offered("main", "a", "b", Reason.plain("accepted")), "a offers main to b: accepted", Tone.NOTE),
        (event.Stopped(True, Reason.plain("smoke")), "STOPPED: smoke; every drive holds until `reset`", Tone.FAULT),
        (event.Stopped(False, NOTHING), "motion is allowed again", Tone.GOOD),
        (
            event.Result(False, Reason.plain("why"), 1, 4, 2.0, 2.0, {}, (), ""),
            "     2.00 s  run aborted, 1 of 4 actions: why",
            Tone.FAULT,
        ),
    ],
)
def test_an_event_is_a_line(message, line, tone):
    assert list(lines(message)) == [(line, tone)]


@pytest.mark.parametrize("message", [event.Done(0, 1, 2.0), event.Edited("main", 1, NOTHING, 2.0)])
def test_what_only_machines_want_is_not_told(message):
    assert list(lines(message)) == []


def test_a_failure_shows_place_traceback_source_line_and_values():  # R-A18
    trace = "  File pd.py, line 7, in cycle\n    return 1 / 0\n"
    shown = [
        line
        for line, _ in lines(
            event.Failed("main", "pd", Reason.plain("ZeroDivisionError"), "pd.py", 7, trace, 1.0, "cycle", {"K": 2})
        )
    ]
    assert shown[0] == "     1.00 s  ERROR main/pd: ZeroDivisionError (pd.py:7)"
    assert [line.strip() for line in shown[1:]] == ["File pd.py, line 7, in cycle", "return 1 / 0", "K = 2"]


@pytest.mark.parametrize(
    ("low", "high", "default", "end"),
    [
        ((0.0,), (1.0,), None, "how high, from 0 to 1"),
        ((0.0,), None, (2,), "how high, at least 0, else 2"),
        (None, (1.0,), None, "how high, at most 1"),
        (None, None, None, "how high"),
    ],
)
def test_a_question_names_type_unit_bounds_and_default(low, high, default, end):  # R-A10
    item = event.Item("level", "double", 1, "m", "how high", default, low, high)
    shown = list(lines(event.Asked("main", "gauge", Reason.plain("too high"), (item,), 1.0)))
    assert shown[0] == ("     1.00 s  main/gauge: too high", Tone.ASK)
    assert shown[1] == (f"     1.00 s  main/gauge asks for level double in m, {end}", Tone.ASK)


@pytest.mark.parametrize(
    ("completed", "done", "of", "words"),
    [
        (True, 4, 4, "4 of 4 actions"),
        (True, 12, 4, " 12 actions"),
        (True, 1, 4, " 1 action"),
        (False, 3, 4, "3 of 4 actions"),
    ],
)
def test_a_run_with_loops_says_how_many_actions_and_not_of_how_many(completed, done, of, words):  # R-X21
    result = event.Result(completed, NOTHING, done, of, 1.0, 1.0, {}, (), "")
    assert words in lines(result)[0][0]
