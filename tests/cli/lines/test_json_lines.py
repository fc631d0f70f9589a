import json

from onika.cli.lines.json_lines import JsonLines
from onika.desk.plan.preparation import prepare_run
from onika.desk.run.outcome import Outcome
from onika.store.site import open_site
from onika.wire import event
from onika.wire.figures import TaskFigures
from onika.wire.steer import Position
from onika.words.condition import Condition
from onika.words.fault import Fault, Place
from onika.words.reason import NOTHING, Reason

FIGURES = TaskFigures("flow0", "pd", "rt0", 500.0, 1000, 3, 4.5, 20.0)
RESULT = event.Result(True, NOTHING, 1, 1, 2.0, 0.12345, {"Q": [1.5], "NAME": "é"}, (FIGURES,), "abc", (3.5,))

SAID = {"key": "plain", "text": "expected one, found two"}


def lines(capsys):
    return [json.loads(line) for line in capsys.readouterr().out.split("\n") if line]


def test_every_event_is_one_object_on_one_line(capsys):  # R-E11
    with JsonLines() as out:
        out.begins(prepare_run("go_home", open_site([], {}, None)), 4711)
        out.happens(event.Began(0, 1, 2, "jmoveC home", 0.5))
        out.happens(event.Warned("flow0", "", Reason.plain("two\nlines \u2028"), 0.5))
        out.happens(event.Drive("boxes:arm_left", "HELD", 4, 2, -1, Reason.plain("stop")))
        out.happens(RESULT)
    begins, began, warned, drive = lines(capsys)
    assert begins == {"event": "begins", "application": "go_home", "runtime_pid": 4711}
    action = {"flow": 0, "index": 1, "of": 2, "action": "jmoveC home"}
    assert began == {"event": "began", **action, "at_s": 0.5, "run": ""}
    assert warned["text"] == {"key": "plain", "text": "two\nlines \u2028"}
    assert (drive["event"], drive["at_ns"], drive["previous_step_ns"], drive["last_command_ns"]) == ("drive", 4, 2, -1)


def test_the_result_comes_last_with_everything(capsys):  # R-E14, R-X07, R-X08, R-A17
    expectation = Condition.parse("Q[0] > 1")
    outcome = Outcome("go", [], [Reason.plain("by the way")], RESULT, [(expectation, 1.5, True)], printed="it printed")
    JsonLines().ended(outcome, Reason.plain("picture: out.png"))
    (line,) = lines(capsys)
    assert line == {
        "event": "result",
        "application": "go",
        "state": "completed",
        "faults": [],
        "notes": ["by the way"],
        "cause": {"key": "", "text": ""},
        "actions_done": 1,
        "actions": 1,
        "runtime_s": 2.0,
        "wall_s": 0.123,
        "values": {"Q": [1.5], "NAME": "é"},
        "expectations": [{"expect": "Q[0] > 1", "found": 1.5, "holds": True}],
        "missed": {"flow0/pd": 3},
        "tasks": [
            {"subsystem": "flow0", "task": "pd", "rtpu": "rt0", "hz": 500.0, "cycles": 1000, "missed": 3,
             "mean_us": 4.5, "most_us": 20.0}
        ],
        "switches_us": [],
        "skews_us": [3.5],
        "steps": [],
        "failed": [],
        "hash": "abc",
        "outside": [],
        "black_box": "",
        "remarks": [],
        "printed": "it printed",
        "picture": "picture: out.png",
        "exit": 0,
    }  # fmt: skip


def test_a_refused_run_lists_its_faults(capsys):  # R-E01
    JsonLines().ended(
        Outcome("go", [Fault(Place("a.rmod", 3), Reason.plain("expected one, found two"), Reason.plain("left out"))]),
        NOTHING,
    )
    (line,) = lines(capsys)
    assert (line["state"], line["exit"]) == ("refused", 2)
    assert line["faults"] == [
        {"file": "a.rmod", "line": 3, "reason": SAID, "instead": {"key": "plain", "text": "left out"}}
    ]
    assert "cause" not in line
    assert "picture" not in line


def test_values_that_are_no_numbers_are_still_json(capsys):
    values = {"X": float("nan"), "Y": float("inf")}
    JsonLines().ended(Outcome("go", result=event.Result(True, NOTHING, 1, 1, 1.0, 1.0, values, (), "")), NOTHING)
    assert lines(capsys)[0]["values"] == {"X": None, "Y": None}


def test_nobody_is_there_to_answer():  # law 25
    assert JsonLines().answer(event.Asked("flow0", "gauge", NOTHING, (), 0.0)) is None


def test_a_line_of_a_script_is_an_object_too(capsys):  # R-E07, R-X03
    out = JsonLines()
    out.steered("pass", (Fault(Place("s", 2), Reason.plain("expected one, found two"), Reason.plain("no")),), ())
    out.steered("who", (), (Position("flow0", "running", 0),))
    out.placed(())
    refused, who = lines(capsys)
    fault = {"file": "s", "line": 2, "reason": SAID, "instead": {"key": "plain", "text": "no"}}
    assert refused == {"event": "steered", "line": "pass", "faults": [fault]}
    assert (who["faults"], who["flows"][0]["subsystem"], who["flows"][0]["state"]) == ([], "flow0", "running")
    assert (out.can_steer, out.wishes(), out.looks()) == (False, (), False)


def test_what_flows_do_is_carried_whole(capsys):  # R-E11, R-X03, R-X06
    out = JsonLines()
    out.happens(event.Moved("flow1", "waiting", 0, 1.0, "t a", ("flow0",)))
    out.happens(event.Met("t a", ("flow0", "flow1"), 12.0, 3.0))
    out.happens(
        event.Explained(
            "flow0", "pd", "move", 1, "a:3", Reason.plain("broke"), "", 0, (), (), (("clear", Reason.plain("so")),), 4.0
        )
    )
    moved, met, explained = lines(capsys)
    assert (moved["event"], moved["waits_for"], moved["tag"]) == ("moved", ["flow0"], "t a")
    assert (met["event"], met["skew_us"]) == ("met", 12.0)
    assert (explained["event"], explained["choices"]) == ("explained", [["clear", {"key": "plain", "text": "so"}]])
