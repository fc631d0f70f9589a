import numpy as np
import pytest

from kit.record.recording_builder import RecordingBuilder
from onika.desk.run.run_review import Interval, Review
from onika.record import foxglove, topics
from onika.wire import event
from onika.words.reason import NOTHING

EVENTS = (
    event.TaskState("flow0", "servo", "OFF", 0.0),
    event.Moved("flow0", "running", 0, 0.0),
    event.Began(0, 0, 2, "one", 0.0),
    event.TaskState("flow0", "servo", "ON", 0.1),
    event.Drive("yard:m0", "DRIVEN", 0, 0, 0, NOTHING, 0.1),
    event.Done(0, 0, 1.0),
    event.Began(0, 1, 2, "two", 1.0),
    event.Moved("flow0", "paused", 1, 1.5),
)


@pytest.fixture
def tape(tmp_path):
    tape = RecordingBuilder(tmp_path / "run.mcap")
    for each in EVENTS:
        tape.tell(getattr(each, "at_s", 0.1), each)
    tape.variable("X", "double[2]", *((k / 100, [np.sin(k / 10), k]) for k in range(200)), unit="m")
    tape.variable("NAME", "char", (0.0, 65))
    row = np.array([[0, 0, 1, 1, 0, 0, 0]], dtype=np.float32).tobytes()
    tape.show(0.5, topics.frames("yard"), foxglove.FRAMES, foxglove.FRAMES_SCHEMA, foxglove.frames("yard", 0, row))
    tape.show(0.5, topics.scene("yard"), foxglove.SCENE, foxglove.SCENE_SCHEMA, foxglove.scene("yard", 0, []))
    return tape


def test_the_flows_tell_when_each_action_was_carried_out(tape):  # R-X05
    tape.end()
    with Review(tape.path) as review:
        (flow,) = review.flows
        assert [(interval.action, interval.begin_s, interval.end_s) for interval in flow.intervals] == [
            (0, 0.0, 1.0),
            (1, 1.0, None),
        ]
        assert flow.intervals[0] == Interval(0, "one", 0.0, 1.0, is_done=True)
        assert review.span_s == (0.0, 1.99)
        assert len(flow.actions) == 2


def test_an_instant_tells_everything_as_it_was(tape):  # R-X05: canvas, flows, plots, 3-D
    tape.end(completed="yes")
    with Review(tape.path) as review:
        early, late = review.at(0.05), review.at(1.75)
        assert (early.tasks, early.drives, early.poses) == ({"flow0/servo": "OFF"}, {}, {})
        assert early.flows == {"flow0": ("running", 0)}
        assert early.variables["flow0/X"] == [pytest.approx(np.sin(0.5)), 5.0]
        assert (late.tasks, late.drives) == ({"flow0/servo": "ON"}, {"yard:m0": "DRIVEN"})
        assert late.flows == {"flow0": ("paused", 1)}
        assert late.poses == {"yard": [[0, 0, 1, 1, 0, 0, 0]]}
        assert (review.is_whole, review.ending["completed"], review.worlds) == (True, "yes", ("yard",))
        assert review.at(-1.0).flows == {"flow0": ("", -1)}
        assert review.scene("yard", 1.0)["entities"] == []
        assert review.scene("yard", 0.1) is None
        assert (review.shapes("yard"), review.shapes("moon"), review.lit("yard", 1.0)) == ([], None, [])


def test_a_course_keeps_its_peaks_however_few_its_points(tape):  # R-X05: downsampled courses
    tape.end()
    with Review(tape.path) as review:
        sine, count = review.course("flow0/X", 0.0, 2.0, 10)
        assert (sine.label, sine.unit) == ("X[0]", "m")
        assert len(sine.at_s) <= 11
        assert max(sine.most) == pytest.approx(1.0, abs=0.01)
        assert min(sine.least) == pytest.approx(-1.0, abs=0.01)
        assert (count.least[0], count.most[-1]) == (0.0, 199.0)
        assert review.course("flow0/NAME", 0.0, 2.0) == []
        with pytest.raises(KeyError):
            review.course("flow0/NOTHING", 0.0, 1.0)


def test_a_course_begins_with_the_value_that_was_there(tape):
    tape.end()
    with Review(tape.path) as review:
        _, count = review.course("flow0/X", 0.505, 0.506, 10)
        assert count.most == [50.0]


def test_a_recording_that_was_cut_short_is_looked_at_as_far_as_it_goes(tape):  # R-X05
    tape.cut()
    with Review(tape.path) as review:
        assert not review.is_whole
        assert review.at(1.0).variables["flow0/X"][1] == 100.0
        assert review.ending == {}
