import pytest

from onika.desk.plan.flow_index import FlowIndex, IndexedFlow
from onika.desk.run.flow_tracker import FlowTracker
from onika.desk.run.pending_wait import PendingWait
from onika.desk.run.steering import SteeringWait
from onika.desk.run.wait_condition import WaitCondition
from onika.wire import event
from onika.words.fault import Place

HERE = Place("s", 3)


class Run:
    """A run at a time."""

    def __init__(self):
        self.flow_tracker = FlowTracker(FlowIndex((IndexedFlow("flow0", ("a", "b")),)))
        self.now_s = 10.0
        self.is_over = False
        self.stuck = False

    def is_stuck(self):
        return self.stuck


@pytest.fixture
def run():
    return Run()


def test_seconds_are_over_when_they_have_passed(run):  # R-E07
    pending_wait = PendingWait(run, SteeringWait(WaitCondition("seconds", seconds=2.0)))
    assert pending_wait.until_s == 12.0
    assert not pending_wait.is_over
    run.now_s, run.stuck = 11.999, True
    assert not pending_wait.is_over
    run.now_s = 12.0
    assert pending_wait.is_over
    assert pending_wait.faults(HERE) == ()


def test_a_moment_is_over_when_it_has_come_and_stays_so(run):  # R-E07
    pending_wait = PendingWait(run, SteeringWait(WaitCondition("done", "flow0", 0)))
    assert not pending_wait.is_over
    run.flow_tracker.hear(event.Done(0, 0, 10.5))
    run.is_over = True
    assert pending_wait.is_over
    assert pending_wait.is_over
    assert pending_wait.faults(HERE) == ()


@pytest.mark.parametrize(
    ("change", "actual"),
    [
        ({"now_s": 15.0}, "it not so within 5 s"),
        ({"is_over": True}, "the end of the run before"),
        ({"stuck": True}, "that nothing goes on: flow0 is paused after action 1"),
    ],
)
def test_a_moment_that_does_not_come_is_a_fault_at_its_line(run, change, actual):  # R-E07, R-X03
    run.flow_tracker.hear(event.Moved("flow0", "paused", 0, 9.0))
    pending_wait = PendingWait(run, SteeringWait(WaitCondition("began", "flow0", 1), 5.0))
    assert not pending_wait.is_over
    for name, value in change.items():
        setattr(run, name, value)
    assert pending_wait.is_over
    (fault,) = pending_wait.faults(HERE)
    assert (fault.place, str(fault.reason)) == (HERE, f"expected action 2 of flow0 has begun, found {actual}")
