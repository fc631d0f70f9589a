from contextlib import contextmanager
from types import SimpleNamespace

import pytest

from onika.desk.run.run import NotRun
from onika.desk.run.settings import RunSettings
from onika.desk.sweep import warm_runtime as room
from onika.desk.sweep.case import Case
from onika.desk.sweep.warm_runtime import WarmRuntime
from onika.link.lost import LinkLost, LossCause
from onika.wire import event, live, request
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import NOTHING, Reason

SETTINGS = RunSettings("stack", is_virtual=True, seed=3, shake=3)
GOOD = event.Result(True, NOTHING, 4, 4, 9.0, 0.1, {}, (), "abc")
BAD = event.Result(False, Reason.plain("it fell"), 2, 4, 5.0, 0.1, {}, (), "abd")
GONE = LinkLost(LossCause.CLOSED, Reason.plain("killed"))


class Machine:
    """Runtimes that are launched, what they are asked, and how the runs on them end, in turn."""

    def __init__(self):
        self.ends = []
        self.asked = []
        self.launched = self.closed = 0
        self.answer = request.Done()

    def launch(self, *_args, **_named):
        self.launched += 1
        return self

    def __enter__(self):
        return self

    def __exit__(self, *_ending):
        self.closed += 1

    def ask(self, message):
        self.asked.append(message)
        return self.answer

    def events(self, _timeout_s):
        return iter(())

    @contextmanager
    def start_on(self, runtime_for, settings, site, prepared):
        assert runtime_for(SimpleNamespace(flows=(), code=()), {"yard": {"mass": 2.0}}) is self
        end = self.ends.pop(0)
        if isinstance(end, Exception):
            raise end
        result, *unmet = end
        conditions = [(SimpleNamespace(text=text), 0, False) for text in unmet]
        outcome = SimpleNamespace(expectations=[(SimpleNamespace(text="X == 1"), 1, True), *conditions])
        yield SimpleNamespace(result=lambda: result, close=lambda: None, outcome=outcome)


@pytest.fixture
def machine(monkeypatch):
    machine = Machine()
    monkeypatch.setattr(room, "LaunchedRuntime", machine.launch)
    monkeypatch.setattr(room, "rtpus_of", lambda plan: ("rt0",))
    monkeypatch.setattr(room, "start_on", machine.start_on)
    monkeypatch.setattr(room, "timed_events", lambda running, limit_s: iter(()))
    return machine


def done(machine, *ends):
    machine.ends += ends
    with WarmRuntime(None, None) as runtime:
        results = []
        while machine.ends:
            results.append(runtime.do(Case(3), SETTINGS, 60.0))
    return results


def test_one_runtime_does_all_runs_and_is_renewed_before_each(machine):  # R-X23
    results = done(machine, (GOOD,), (BAD,), (GOOD, "LAMP == 1"))
    assert (machine.launched, machine.closed) == (1, 1)
    assert machine.asked == [live.Renew(3, {"yard": {"mass": 2.0}})] * 3
    assert [(result.state, result.unmet, result.is_good) for result in results] == [
        ("completed", (), True),
        ("aborted", (), False),
        ("completed", ("LAMP == 1",), False),
    ]
    assert (results[0].lasted_s, results[0].hash, str(results[1].cause)) == (9.0, "abc", "it fell")


def test_a_run_whose_runtime_died_is_done_once_more_on_a_new_one(machine):  # R-X23
    (result,) = done(machine, GONE, (GOOD,))
    assert result.is_good
    assert (machine.launched, machine.closed) == (2, 2)


def test_one_that_dies_twice_is_told_and_the_next_one_has_a_new_runtime(machine):  # R-X23
    lost, good = done(machine, GONE, GONE, (GOOD,))
    assert (lost.state, str(lost.cause), good.is_good) == ("lost", "killed", True)
    assert machine.launched == 3


def test_one_that_is_refused_is_told_with_its_first_reason(machine):  # R-X23
    fault = Fault(Place("stack.appl", 3), Reason.plain("no such job"), NOT_RUN)
    refused, good = done(machine, NotRun([fault]), (GOOD,))
    assert (refused.state, str(refused.cause), good.is_good) == ("refused", "no such job", True)
    assert machine.launched == 1


def test_a_runtime_that_will_not_be_renewed_is_replaced(machine):  # R-X23
    machine.answer = request.Refused(Reason.plain("somebody is connected"))
    machine.ends.append((GOOD,))
    with WarmRuntime(None, None) as runtime:
        result = runtime.do(Case(3), SETTINGS, 60.0)
    assert (result.state, str(result.cause)) == ("lost", "somebody is connected")
    assert (machine.launched, machine.closed) == (2, 2)
