from dataclasses import replace

import pytest

from onika.cli.event_text import SummaryTone, item_text, lines as event_lines, sentence, summary
from onika.desk.run.outcome import Outcome
from onika.wire import event
from onika.wire.figures import TaskFigures
from onika.words.condition import Condition
from onika.words.fault import Fault, Place
from onika.words.reason import NOTHING, Reason

FIGURES = TaskFigures("flow0", "pd", "rt0", 500.0, 1000, 3, 4.5, 20.0)


def result(**changes):
    fields = {
        "completed": True, "cause": "", "done": 2, "of": 3, "runtime_s": 20.0, "wall_s": 1.0, "values": {},
        "tasks": (FIGURES,), "hash": "",
    }  # fmt: skip
    return event.Result(**(fields | changes))


def english(outcome, drawn):
    """The summary in English."""
    return [str(line.reason) for line in summary(outcome, drawn)]


@pytest.mark.parametrize(
    ("happening", "line"),
    [
        (event.Began(0, 4, 12, "jmoveC home", 3.14159), "    3.14 s   5/12  jmoveC home"),
        (event.Warned("flow0", "jtraj", Reason.plain("too fast"), 1.0), "    1.00 s  note: jtraj: too fast"),
        (event.Warned("flow0", "", Reason.plain("waits"), 1.0), "    1.00 s  note: waits"),
        (event.Outdated("cell", True, Reason.plain("changed"), 1.0), "    1.00 s  note: changed"),
        (
            event.Stepped("flow0", "puma", "TAU_REF", "N m", 1, 40.0, 9.0, 9.76, 6, 1.0),
            "    1.00 s  note: flow0/puma: TAU_REF[1] stepped by 40 N m at a switch, more than 9.76 N m a cycle: "
            "blended over 6 cycles",
        ),
        (
            event.Failed("flow0", "pd", Reason.plain("cycle: no"), "pd.py", 7, "", 0.5),
            "    0.50 s  ERROR flow0/pd: cycle: no (pd.py:7)",
        ),
        (
            event.Failed("flow0", "pd", Reason.plain("cycle: no"), "pd.py", 0, "", 0.5),
            "    0.50 s  ERROR flow0/pd: cycle: no",
        ),
        (
            event.Drive("boxes:arm_left", "PRESSED", 9, 0, 0, Reason.plain("panic button pressed"), 2.5),
            "    2.50 s  boxes:arm_left holds: panic button pressed",
        ),
        (
            event.Drive("boxes:arm_left", "TRIPPED", 9, 0, 0, Reason.plain("its writer died"), 2.5),
            "    2.50 s  boxes:arm_left has tripped: its writer died",
        ),
        (event.Drive("boxes:arm_left", "HELD", 9, 0, 0, Reason.plain("stop"), 2.5), ""),
        (event.Done(0, 0, 1.0), ""),
        (event.Moved("flow1", "waiting", 0, 1.0, "t a", ("flow0",)), "    1.00 s  flow1 waits at a for flow0"),
        (event.Moved("flow0", "paused", 1, 1.0), "    1.00 s  flow0 is paused after 2"),
        (event.Moved("flow0", "paused", -1, 1.0), "    1.00 s  flow0 is paused before its first action"),
        (event.Moved("flow0", "paused", 1, 1.0, text=Reason.plain("why")), "    1.00 s  flow0 is paused after 2 (why)"),
        (
            event.Moved("flow0", "running", 1, 1.0, text=Reason.plain("does not pause")),
            "    1.00 s  flow0 does not pause",
        ),
        (event.Moved("flow0", "running", 1, 1.0), ""),
        (
            event.Met("t a", ("flow0", "flow1"), 12.4, 1.0),
            "    1.00 s  flow0 and flow1 go on together at a, 12 us apart",
        ),
        (event.TaskState("flow0", "pd", "ON", 0.0), ""),
    ],
)
def test_an_event_is_told_in_one_line_or_not_at_all(happening, line):  # R-E11
    assert sentence(happening, 12) == line


def test_a_refused_run_lists_every_fault_and_says_that_nothing_moved():  # R-E01
    fault = Fault(Place("a.rmod", 3), Reason.plain("expected one, found two"), Reason.plain("left out"))
    other = replace(fault, place=Place("b.rmod"))
    lines = english(Outcome("go", [fault, other], [Reason.plain("by the way")]), NOTHING)
    assert lines == [str(fault), str(other), "note: by the way", "go: refused, nothing moved (2 faults)"]
    assert english(Outcome("go", [fault]), NOTHING)[-1] == "go: refused, nothing moved (1 fault)"


def test_a_virtual_run_tells_its_pace_and_its_hash_and_no_misses():  # R-X08
    lines = english(Outcome("go", result=result(hash="abc")), Reason.plain("picture: out.png"))
    assert lines == [
        "go: completed, 2 actions, 20.00 s, in 1.00 s of wall time (20x)",
        "hash: abc",
        "picture: out.png",
    ]


def test_a_virtual_run_that_had_to_do_with_the_outside_says_so():  # law 15
    lines = english(Outcome("go", result=result(hash="abc", outside=("flow0/view",))), NOTHING)
    assert lines[1:] == ["hash: abc", "not reproducible: flow0/view had to do with the outside"]


def test_a_run_in_wall_time_tells_its_cycles_and_misses():  # R-A17
    assert english(Outcome("go", result=result()), NOTHING)[1:] == ["cycles: 1000, missed 3"]


def test_an_aborted_run_tells_its_cause_and_what_was_printed_last():  # R-E14, R-E10
    printed = "\n".join(f"line {number}" for number in range(30))
    lines = english(Outcome("go", result=result(completed=False, cause="it fell"), printed=printed), NOTHING)
    assert lines[0].startswith("go: aborted, 2 of 3 actions")
    assert lines[1:4] == ["cause: it fell", "the runtime printed:", "  line 10"]
    assert lines[-2] == "  line 29"


def test_each_expectation_is_told_with_what_was_found():  # R-X07
    expectations = [
        (Condition.parse("LAMP == 1"), value, holds) for value, holds in ((1, True), (0, False), (None, False))
    ]
    lines = english(Outcome("go", result=result(wall_s=0.0), expectations=expectations), NOTHING)
    assert lines[2:] == [
        "expect LAMP == 1: yes",
        "expect LAMP == 1: NO, found 0",
        "expect LAMP == 1: NO, found nothing",
    ]


@pytest.mark.parametrize(
    ("holds", "tones"),
    [(True, [SummaryTone.WELL, SummaryTone.PLAIN]), (False, [SummaryTone.FAILED, SummaryTone.WRONG])],
)
def test_a_line_of_the_summary_says_how_it_is_meant(holds, tones):  # R-E14
    expectations = [(Condition.parse("LAMP == 1"), 1, holds)]
    outcome = Outcome("go", result=result(hash="abc"), expectations=expectations)
    assert [line.tone for line in summary(outcome, NOTHING)][:2] == tones


def test_a_question_says_bounds_and_default():  # R-A10
    item = event.Item("duration", "double", 1, "s", "how long", (2.0,), (0.1,), (600.0,))
    assert str(item_text(item)) == "duration, how long, in s, from 0.1 to 600, else 2.0"
    assert str(item_text(event.Item("n", "int", 1, "-", "", None, (1.0,), None))) == "n, at least 1"


def test_where_there_are_several_flows_each_action_says_whose_it_is():  # R-E11
    happening = event.Began(1, 4, 7, "jmoveC home", 3.14159)
    assert sentence(happening, 12, ("left", "right")) == "    3.14 s  right   5/7  jmoveC home"


def test_why_a_flow_stands_still_takes_several_lines():  # R-X06
    choices = (("clear", Reason.plain("clear the error and repeat")),)
    happening = event.Explained(
        "flow0", "pd", "move", 1, "a.appl:3", Reason.plain("it broke"), "", 0, (), (), choices, 4.0
    )
    printed = list(event_lines(happening, 12, ("flow0",), 100))
    assert len(printed) > 1
    assert "it broke" in printed[0]
    assert list(event_lines(event.Done(0, 0, 1.0), 12)) == []


def test_a_script_that_failed_after_the_end_is_told():  # R-E07
    outcome = Outcome(
        "go",
        result=result(),
        failed=(Fault(Place("s", 3), Reason.plain("expected one, found two"), Reason.plain("no")),),
    )
    assert outcome.exit_code == 1
    assert "script: s:3: expected one, found two; instead: no" in english(outcome, NOTHING)


def test_what_went_wrong_after_the_last_action_stands_at_the_end_of_a_completed_run():  # R-E14
    outcome = Outcome("go", result=result(remarks=(Reason.plain("rt0 is gone"),)))
    assert [line.tone for line in summary(outcome, NOTHING) if str(line.reason) == "rt0 is gone"] == [SummaryTone.WRONG]
    assert outcome.exit_code == 0
