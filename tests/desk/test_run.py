import signal

import pytest

from onika.desk import run as room
from onika.desk.outcome import Outcome
from onika.desk.run import run
from onika.desk.settings import RunSettings
from onika.link.lost import closed
from onika.store.site import open_site
from onika.wire import event, request
from onika.words.condition import Condition
from onika.words.fault import Fault, Place

SITE = open_site([], {}, None)
GOOD = event.Result(True, "", 1, 1, 2.0, 0.1, {"LAMP": 1}, (), "abc")
ASKED = event.Asked("flow0", "gauge", "", (), 0.5)


class FakeRuntime:
    """Says what it is told to; keeps what it was asked."""

    script = ()
    faults = ()
    refuses = ""
    begins = request.Done()
    snapshots = request.Worlds({"boxes": b"drawn"})
    made = None

    def __init__(self, rtpus, is_virtual, with_fifo, options=()):
        self.given = (rtpus, is_virtual, with_fifo)
        self.options = options
        self.asked = []
        self.pid = 4711
        self.left = list(self.script)
        type(self).made = self

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.asked.append("closed")

    def ask(self, asked):
        self.asked.append(asked)
        match asked:
            case request.Prepare():
                return request.Refused(self.refuses) if self.refuses else request.Prepared(self.faults, ("a note",))
            case request.Begin():
                return self.begins
            case request.Snapshot():
                return self.snapshots
        return request.Done()

    def events(self, _timeout_s):
        one = self.left.pop(0)
        if isinstance(one, Exception):
            raise one
        if callable(one):
            one()
        else:
            yield one

    def printed(self):
        return "it printed this"


class Watcher:
    def __init__(self):
        self.seen = []

    def begins(self, prepared, runtime_pid):
        self.seen.append((prepared.name, runtime_pid))

    def happens(self, one):
        self.seen.append(one)

    def answer(self, asked):
        return f"an answer for {asked.task}"


@pytest.fixture
def runtime(monkeypatch):
    """The class to set up; each run makes a new one."""

    class Fresh(FakeRuntime):
        pass

    monkeypatch.setattr(room, "Runtime", Fresh)
    return Fresh


def go(**settings):
    watcher = Watcher()
    return run(RunSettings("go_home", **settings), SITE, watcher), watcher


def test_a_run_is_prepared_begun_and_followed_to_its_end(runtime):  # R-E03, R-E14
    runtime.script = (event.Done(0, 0, 1.0), GOOD)
    outcome, watcher = go(is_virtual=True, with_fifo=False, settle_s=0.25, seed=3, answers=(("gauge", "level", "1"),))
    assert (outcome.state, outcome.exit_code, outcome.result, outcome.notes) == ("completed", 0, GOOD, ["a note"])
    assert watcher.seen == [("go_home", 4711), event.Done(0, 0, 1.0), GOOD]
    prepare, begin, closing = runtime.made.asked
    assert isinstance(prepare, request.Prepare)
    assert begin == request.Begin((), 0.25, 3, (("gauge", "level", "1"),), False)
    assert closing == "closed"
    assert runtime.made.given == (("rt0",), True, False)


def test_what_is_expected_is_watched_once_and_judged_at_the_end(runtime):  # R-X07
    runtime.script = (GOOD,)
    expectations = tuple(Condition.parse(text) for text in ("LAMP == 1", "LAMP > 5", "Q_MEZ[9] == 1"))
    outcome, _ = go(expectations=expectations)
    assert runtime.made.asked[1].watch == ("LAMP", "Q_MEZ")
    assert [(value, holds) for _, value, holds in outcome.expectations] == [(1, True), (1, False), (None, False)]
    assert (outcome.state, outcome.exit_code) == ("completed", 1)


def test_an_expectation_of_a_variable_that_nobody_knows_refuses_the_run(runtime):  # R-E01
    outcome, watcher = go(expectations=(Condition.parse("NOBODY == 1"), Condition.parse("flow7/LAMP == 1")))
    assert [one.found for one in outcome.faults] == ["NOBODY", "flow7/LAMP"]
    assert (outcome.exit_code, watcher.seen) == (2, [])


def test_faults_of_the_runtime_refuse_the_run_and_nothing_begins(runtime):  # R-E01
    runtime.faults = (request.FaultText("a.rmod", 3, "one", "two", "left out"),)
    outcome, watcher = go()
    assert outcome.faults == [Fault(Place("a.rmod", 3), "one", "two", "left out")]
    assert (outcome.state, outcome.exit_code, watcher.seen) == ("refused", 2, [])
    assert len(runtime.made.asked) == 2


def test_an_application_that_cannot_be_read_starts_no_runtime(runtime):  # R-E01
    outcome = run(RunSettings("nothing_like_it"), SITE, Watcher())
    assert (outcome.exit_code, runtime.made) == (2, None)


def test_a_question_is_answered_by_the_watcher(runtime):  # law 25
    runtime.script = (ASKED, GOOD)
    outcome, _ = go(may_ask=True)
    assert request.Reply("flow0", "gauge", "an answer for gauge") in runtime.made.asked
    assert outcome.exit_code == 0


def test_where_nobody_answers_the_run_is_aborted(runtime, monkeypatch):  # law 25
    runtime.script = (ASKED, GOOD)
    monkeypatch.setattr(Watcher, "answer", lambda *_: None)
    go(may_ask=True)
    assert runtime.made.asked[2] == request.Abort("task gauge asks for input and nobody answers")


def control_c():
    signal.raise_signal(signal.SIGINT)


def test_control_c_stops_the_run_and_its_end_is_still_heard(runtime):  # R-E07
    aborted = event.Result(False, "stopped", 0, 1, 0.5, 0.5, {}, (), "")
    runtime.script = (event.Done(0, 0, 0.1), control_c, event.Done(0, 0, 0.2), aborted)
    outcome, watcher = go()
    assert runtime.made.asked[2] == request.Stop("stopped by the user (Ctrl-C)")
    assert len(watcher.seen) == 4
    assert (outcome.state, outcome.exit_code, outcome.printed) == ("aborted", 1, "it printed this")


def test_a_second_control_c_ends_everything(runtime):  # R-E07
    runtime.script = (control_c, control_c)
    with pytest.raises(KeyboardInterrupt):
        go()
    assert runtime.made.asked[-1] == "closed"


def test_a_lost_runtime_is_an_aborted_run_that_tells_what_was_done(runtime):  # R-E10
    runtime.script = (event.Done(0, 0, 1.0), closed("the other side is gone"))
    outcome, _ = go()
    assert (outcome.state, outcome.exit_code) == ("aborted", 1)
    assert (outcome.result.done, outcome.result.of) == (1, 1)
    assert "the other side is gone" in outcome.result.cause


@pytest.mark.parametrize("fault", [closed("never came up"), TimeoutError("no greeting")])
def test_a_runtime_that_does_not_come_up_is_an_aborted_run(runtime, monkeypatch, fault):  # R-E10
    def refuse(_self):
        raise fault

    monkeypatch.setattr(runtime, "__enter__", refuse)
    outcome, watcher = go()
    assert (outcome.exit_code, watcher.seen) == (1, [])
    assert str(fault) in outcome.result.cause


def test_a_run_that_the_runtime_will_not_begin_is_aborted(runtime):
    runtime.begins = request.Refused("an application runs already")
    outcome, _ = go()
    assert (outcome.result.cause, outcome.exit_code) == ("an application runs already", 1)


def test_a_picture_is_asked_for_only_where_it_is_wanted(runtime):
    runtime.script = (GOOD,)
    assert go()[0].snapshots == {}
    assert request.Snapshot() not in runtime.made.asked
    runtime.script = (GOOD,)
    assert go(wants_picture=True)[0].snapshots == {"boxes": b"drawn"}


def test_an_outcome_says_how_it_ended():  # R-E14
    assert (Outcome("x").state, Outcome("x").exit_code) == ("refused", 2)
    held = Condition.parse("LAMP == 1")
    assert Outcome("x", result=GOOD, expectations=[(held, 1, True)]).exit_code == 0
    assert Outcome("x", result=GOOD, expectations=[(held, 0, False)]).exit_code == 1


def test_scaled_time_and_other_subsystems_are_the_runtimes_business(runtime):  # R-A06, R-X08
    runtime.script = (GOOD,)
    outcome, _ = go(is_virtual=True, scale=10.0, subsystems=("left",))
    assert outcome.exit_code == 0
    assert runtime.made.options == ("--scale", "10")
    assert runtime.made.asked[0].plan.flows[0].subsystem == "left"


def test_too_many_names_of_subsystems_are_refused_before_anything_runs(runtime):
    outcome, _ = go(subsystems=("left", "right"))
    assert outcome.exit_code == 2
    assert "1 different names" in outcome.faults[0].expected


def test_a_runtime_that_will_not_take_the_plan_refuses_the_run(runtime):  # law 23
    runtime.refuses = "code from another machine is not accepted"
    outcome, _ = go()
    assert outcome.exit_code == 2
    assert outcome.faults[0].found == "code from another machine is not accepted"
