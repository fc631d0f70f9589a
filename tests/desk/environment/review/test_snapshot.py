import pytest
from msgspec import structs

from kit.desk.review_fixture import LAMP
from kit.labs.laboratory import job
from kit.record.recording_builder import RecordingBuilder, run
from onika.wire import act, event


@pytest.fixture
def watched(cinema):
    cinema.doc = cinema.open([job("aC"), job("bC"), job("cC")])
    cinema.look(cinema.film(cinema.doc))
    return cinema


def test_an_instant_is_what_was_shown_then(watched):  # R-X05: canvas, flows, plots, 3-D
    instant = watched.glance(1.5)
    flow = instant.run.flows["flow0"]
    assert (flow.state, flow.step, flow.index, flow.done, flow.began_s) == ("running", 2, 1, 1, 1.0)
    assert {key: (step.state, step.times) for key, step in instant.run.steps.items()} == {
        "1": ("done", 1),
        "2": ("running", 0),
    }
    assert (instant.run.doc, instant.run.state, instant.run.done, instant.run.of) == (watched.doc, "running", 1, 3)
    assert instant.tasks == {"flow0/a": "OFF", "flow0/b": "ON"}
    assert instant.values == {"flow0/A": 1.5, "flow0/WORD": "on"}
    assert instant.poses == {"yard": {"rows": [[0, 0, 0, 1, 0, 0, 0], [1, 0, 0, 1, 0, 0, 0]], "lit": ["lamp"]}}


def test_before_the_beginning_and_after_the_end_it_is_as_it_was_there(watched):
    early, late = watched.glance(-5.0), watched.glance(99.0)
    assert (early.run.steps, early.values, early.tasks) == ({}, {}, {})
    assert (late.run.state, late.run.is_completed, late.run.took_s) == ("over", True, 3.0)
    assert watched.glance(0.5).poses["yard"]["lit"] == []
    assert watched.glance(1e308).run == late.run


def test_a_world_is_not_empty_before_it_was_first_seen(watched):  # R-X05: 3-D from the first instant on
    assert watched.glance(-5.0).poses["yard"]["rows"] == watched.glance(0.0).poses["yard"]["rows"] != []


def test_a_task_for_which_another_one_stood_is_shown_in_the_state_of_that_one(cinema, tmp_path):  # R-X05, R-E09
    recorded = run()
    (flow,) = recorded.prepare.plan.flows
    old = structs.replace(flow.tasks[0], name="puma")
    swapped = structs.replace(flow, replaced=((flow.tasks[0].name, old),))
    prepare = structs.replace(recorded.prepare, plan=structs.replace(recorded.prepare.plan, flows=(swapped,)))
    tape = RecordingBuilder(tmp_path / "swapped.mcap", structs.replace(recorded, prepare=prepare))
    tape.tell(0.0, event.TaskState("flow0", flow.tasks[0].name, "ON", 0.0))
    tape.end()
    view, name = cinema.look(tape.path), flow.tasks[0].name
    assert cinema.glance(1.0).tasks == {f"flow0/{name}": "ON", "flow0/puma": "ON"}
    assert [(redirect.old, redirect.new, redirect.flow, redirect.homes) for redirect in view.redirects] == [
        ("puma", flow.tasks[0].name, "", ("flow0",))
    ]


def test_time_runs_backwards_as_well(watched):  # R-X05: scrubbed
    assert [watched.glance(at).run.done for at in (2.5, 0.5, 1.5, 2.5)] == [2, 0, 1, 2]


def test_tasks_of_an_open_configuration_are_found_in_their_subsystem(watched):  # R-X05: the canvas
    doc = watched.do(act.Open("aC"))
    assert watched.glance(1.0).homes == {doc: "flow0"}


def test_a_world_is_what_was_drawn_live(watched):  # R-X05: 3-D
    (shape,) = watched.do(act.RecordedScene("yard"))["shapes"]
    assert shape == {key: list(value) if isinstance(value, tuple) else value for key, value in LAMP.items()}
    assert "nothing of a world moon" in str(watched.no(act.RecordedScene("moon")).reason)


def test_nothing_is_shown_of_another_one_that_is_not_there(watched):
    assert "no other recording" in str(watched.no(act.Glance(0.0, of_other=True)).reason)
    assert "no other recording" in str(watched.no(act.RecordedScene("yard", of_other=True)).reason)


def test_a_file_that_is_written_over_meanwhile_does_no_harm(watched):  # R-X05: the same name recorded again
    path = watched.environment.model.review_session.subject.path
    with path.open("wb") as other:
        other.write(b"\x89MCAP0\r\n")
    assert "film.mcap cannot be read there" in str(watched.no(act.Glance(1.5)).reason)
    assert "film.mcap cannot be read there" in str(watched.later(act.Course("flow0/A", 0.0, 3.0)).no.reason)
    watched.do(act.CloseRecording())
