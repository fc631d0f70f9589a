from types import SimpleNamespace

import pytest

from kit.labs.laboratory import job
from onika.desk.environment.run_state import recorded_run as room
from onika.wire import act, event
from onika.wire.view import FlowRunView
from onika.words.reason import Reason


@pytest.fixture
def tape(cinema):
    return cinema.tape(cinema.open([job("aC"), job("bC")]))


def test_the_last_action_of_a_run_cut_short_has_no_end_and_one_that_was_left_has(cinema, tape):  # R-X05
    tape.tell(0.0, event.Began(0, 0, 2, "aC", 0.0))
    tape.tell(1.0, event.Began(0, 1, 2, "bC", 1.0))
    tape.cut()
    passages = cinema.look(tape.path).flows["flow0"].passages
    assert [(passage.begin_s, passage.end_s) for passage in passages] == [(0.0, 1.0), (1.0, None)]


def test_what_was_lost_is_told(cinema, tape):  # R-X05
    tape.tell(1.0, event.Result(False, Reason.plain("aborted by the user"), 0, 2, 1.0, 0.0, {}, (), ""), "")
    tape.end(missed="3", untold="2", cause="aborted by the user", completed="no")
    view = cinema.look(tape.path)
    assert [(note.key, note.args["count"]) for note in view.notes[:2]] == [
        ("run.lost_values", 3),
        ("run.lost_events", 2),
    ]
    assert (view.is_completed, str(view.cause)) == (False, "aborted by the user")


def test_why_it_cannot_be_gone_on_from_is_told(cinema, tape):  # R-X05
    tape.tell(0.0, event.Began(0, 0, 2, "aC", 0.0))
    tape.end(outside="flow0/gauge")
    assert str(cinema.look(tape.path).cannot_continue).endswith(
        "found tasks that had to do with the outside: flow0/gauge"
    )


def test_what_lived_for_it_is_told_once_and_not_at_every_instant(cinema, tape):  # R-C27, R-E11, R-X05
    tape.tell(0.0, event.Began(0, 0, 2, "aC", 0.0))
    tape.end()
    view = cinema.look(tape.path)
    inside = view.inside["flow0"]
    assert {name: task.state for name, task in inside.tasks.items()} == {"a": "", "b": ""}
    assert {name: variable.writers for name, variable in inside.variables.items()} == {"A": ("a",), "B": ("b",)}
    assert set(view.steps_by_task) == {"flow0/a", "flow0/b"}
    assert cinema.do(act.Glance(0.0)).run.steps_by_task == {}


def test_a_black_box_without_a_workcell_says_that_none_is_kept(cinema):  # R-X05, R-X21
    told = {}
    for name, held_s in (("box", (0.0, 1.0)), ("whole", None)):
        tape = cinema.tape(cinema.open([job("aC")]), name, held_s)
        tape.tell(0.0, event.Began(0, 0, 1, "aC", 0.0))
        tape.end()
        told[name] = "desk.digest_black_box_workcell" in [note.key for note in cinema.look(tape.path).notes]
    told["drawn"] = "desk.digest_black_box_workcell" in [
        note.key for note in cinema.look(cinema.film(cinema.open([job("aC")]), "drawn", held_s=(0.4, 1.0))).notes
    ]
    assert told == {"box": True, "whole": False, "drawn": False}


def test_each_flow_says_at_which_station_it_was():  # R-X05, R-E12
    flows = {"flow0": FlowRunView(0), "flow1": FlowRunView(1), "flow2": FlowRunView(2)}
    run = SimpleNamespace(view=SimpleNamespace(flows=flows))
    shown = room._flows(run, {"flow0": "here", "flow1": "cmu"})
    assert {home: flow.station for home, flow in shown.items()} == {"flow0": "", "flow1": "cmu", "flow2": ""}
