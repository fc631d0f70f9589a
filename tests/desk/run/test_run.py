import signal

import pytest

from kit.desk.scripted_runtime import After, KeepingWatcher, ScriptedRuntime
from onika.desk.run import run as room
from onika.desk.run.run import run, start
from onika.desk.run.settings import RunSettings
from onika.link.lost import closed
from onika.store.site import open_site
from onika.wire import event, request, steer
from onika.words.condition import Condition
from onika.words.fault import Fault, Place
from onika.words.reason import NOTHING, Reason

SITE = open_site([], {}, None)
GOOD = event.Result(True, NOTHING, 1, 1, 2.0, 0.1, {"LAMP": 1}, (), "abc")
ASKED = event.Asked("flow0", "gauge", NOTHING, (), 0.5)


@pytest.fixture
def runtime(monkeypatch):
    """The class to set up; each run makes a new one."""

    class Fresh(ScriptedRuntime):
        pass

    monkeypatch.setattr(room, "LaunchedRuntime", Fresh)
    return Fresh


def go(watcher=None, **settings):
    watcher = watcher or KeepingWatcher()
    return run(RunSettings("go_home", **settings), SITE, watcher), watcher


def test_a_run_is_prepared_begun_and_followed_to_its_end(runtime):  # R-E03, R-E14
    runtime.script = (event.Done(0, 0, 1.0), GOOD)
    outcome, watcher = go(is_virtual=True, with_fifo=False, settle_s=0.25, seed=3, answers=(("gauge", "level", "1"),))
    assert (outcome.state, outcome.exit_code, outcome.result) == ("completed", 0, GOOD)
    assert [str(note) for note in outcome.notes] == ["a note"]
    assert watcher.seen == [("go_home", 4711), event.Done(0, 0, 1.0), GOOD]
    prepare, begin, closing = runtime.made.requests
    assert isinstance(prepare, request.Prepare)
    assert begin == request.Begin((), 0.25, 3, (("gauge", "level", "1"),), False)
    assert closing == "closed"
    assert runtime.made.given == (("rt0",), True, False)


def test_what_is_expected_is_watched_once_and_judged_at_the_end(runtime):  # R-X07
    runtime.script = (GOOD,)
    expectations = tuple(Condition.parse(text) for text in ("LAMP == 1", "LAMP > 5", "Q_MEZ[9] == 1"))
    outcome, _ = go(expectations=expectations)
    assert runtime.made.requests[1].watch == ("LAMP", "Q_MEZ")
    assert [(value, holds) for _, value, holds in outcome.expectations] == [(1, True), (1, False), (None, False)]
    assert (outcome.state, outcome.exit_code) == ("completed", 1)


def test_an_expectation_of_a_variable_that_nobody_knows_refuses_the_run(runtime):  # R-E01
    outcome, watcher = go(expectations=(Condition.parse("NOBODY == 1"), Condition.parse("flow7/LAMP == 1")))
    assert [fault.reason for fault in outcome.faults] == [
        Reason.of("desk.variable_unknown", address="NOBODY"),
        Reason.of("desk.variable_unknown", address="flow7/LAMP"),
    ]
    assert (outcome.exit_code, watcher.seen) == (2, [])


def test_faults_of_the_runtime_refuse_the_run_and_nothing_begins(runtime):  # R-E01
    runtime.faults = (
        request.FaultText("a.rmod", 3, Reason.plain("expected one, found two"), Reason.plain("left out")),
    )
    outcome, watcher = go()
    assert outcome.faults == [
        Fault(Place("a.rmod", 3), Reason.plain("expected one, found two"), Reason.plain("left out"))
    ]
    assert (outcome.state, outcome.exit_code, watcher.seen) == ("refused", 2, [])
    assert len(runtime.made.requests) == 2


PAUSED = event.Moved("flow0", "paused", 0, 0.5)
STOOD = event.Stood(0.5)


def test_a_script_steers_the_run(runtime, tmp_path):  # R-E07
    path = tmp_path / "s"
    path.write_text("wait began 1\npause\nwait paused\ncontinue\n")
    runtime.script = (
        event.Began(0, 0, 1, "jmoveC home", 0.1),
        After(steer.Pause("flow0"), PAUSED),
        After(steer.Resume("flow0"), GOOD),
    )
    outcome, watcher = go(script=path, on_error="wait")
    assert outcome.exit_code == 0
    assert [message for message in runtime.made.requests if isinstance(message, steer.Pause | steer.Resume)] == [
        steer.Pause("flow0"),
        steer.Resume("flow0"),
    ]
    lines = [entry[0] for entry in watcher.seen if isinstance(entry, tuple) and len(entry) == 3]
    assert lines == ["wait began 1", "pause", "wait paused", "continue"]
    begin = runtime.made.requests[1]
    assert (begin.on_error, begin.is_held) == ("wait", False)


def test_in_virtual_time_the_clock_waits_for_the_script(runtime, tmp_path):  # R-E07, law 15
    path = tmp_path / "s"
    path.write_text("wait 0.5\npause\n")
    runtime.script = (
        event.Stood(0.0),
        After(steer.Onward(0.5), STOOD),
        After(steer.Pause("flow0"), STOOD),
        After(steer.Onward(None), GOOD),
    )
    go(script=path, is_virtual=True)
    messages = runtime.made.requests[1:-1]
    assert messages[0].is_held
    assert messages[1:] == [
        steer.Onward(0.0), steer.Onward(0.5), steer.Pause("flow0"), steer.Onward(0.5), steer.Onward(None),
    ]  # fmt: skip


def test_all_faults_of_a_script_refuse_the_run(runtime, tmp_path):  # R-E07
    path = tmp_path / "s"
    path.write_text("dance\npause\nskip 9\n")
    outcome, watcher = go(script=path)
    assert [str(fault.place) for fault in outcome.faults] == [f"{path}:1", f"{path}:3"]
    assert (outcome.exit_code, watcher.seen) == (2, [])


def test_a_script_that_fails_aborts_the_run(runtime, tmp_path):  # R-E07
    path = tmp_path / "s"
    path.write_text("pass\nnext\n")
    runtime.refusals = {"Pass": Reason.plain("expected flow 0 to be waiting, found it running")}
    runtime.script = (
        event.Began(0, 0, 1, "jmoveC home", 0.1),
        event.Result(False, Reason.plain("x"), 0, 1, 1.0, 1.0, {}, (), ""),
    )
    outcome, watcher = go(script=path)
    assert [str(fault.reason) for fault in outcome.failed] == ["expected flow 0 to be waiting, found it running"]
    assert request.Abort(Reason.of("desk.script_fails", place=f"{path}:1")) in runtime.made.requests
    assert not any(isinstance(message, steer.Skip) for message in runtime.made.requests)
    assert ("pass", ["expected flow 0 to be waiting, found it running"], ()) in watcher.seen


def test_lines_that_are_left_at_a_good_end_are_a_failure(runtime, tmp_path):  # R-E07
    path = tmp_path / "s"
    path.write_text("wait began 1 within 5\npause\n")
    runtime.script = (GOOD,)
    outcome, _ = go(script=path)
    assert str(outcome.failed[0].reason) == "expected action 1 of flow0 has begun, found the end of the run before"
    assert (outcome.state, outcome.exit_code) == ("completed", 1)


def test_what_keys_want_is_done_at_once_and_told(runtime):  # R-E07
    watcher = KeepingWatcher()
    watcher.can_steer, watcher.looks_now, watcher.wanted = True, True, ("pause", "who", "dance")
    runtime.positions = (steer.Position("flow0", "running", 0),)
    runtime.script = (event.Done(0, 0, 0.1), GOOD)
    go(watcher)
    assert steer.Pause("flow0") in runtime.made.requests
    assert ("pause", [], ()) in watcher.seen
    assert ("who", [], runtime.positions) in watcher.seen
    assert runtime.positions in watcher.seen
    ((sentence,),) = [entry[1] for entry in watcher.seen if isinstance(entry, tuple) and entry[0] == "dance"]
    assert sentence.endswith(", found 'dance'")


@pytest.mark.parametrize(("can_steer", "aborts"), [(False, 1), (True, 0)])
def test_where_nobody_could_go_on_a_run_that_stands_still_is_aborted(runtime, can_steer, aborts):  # R-X03
    watcher = KeepingWatcher()
    watcher.can_steer = can_steer
    runtime.positions = (steer.Position("flow0", "paused", 0),)
    runtime.script = (PAUSED, event.Result(False, Reason.plain("x"), 0, 1, 1.0, 1.0, {}, (), ""))
    go(watcher)
    causes = [order.cause for order in runtime.made.requests if isinstance(order, request.Abort)]
    assert list(map(str, causes)) == ["nobody is there to go on: flow0 is paused after action 1"] * aborts


def test_a_run_is_begun_and_steered_from_a_program(runtime):  # R-E07
    runtime.script = (event.Began(0, 0, 1, "jmoveC home", 0.1), PAUSED, After(steer.Resume("flow0"), GOOD))
    with start(RunSettings("go_home"), SITE) as running:
        assert running.steer("pause") == ()
        assert running.wait("paused") == ()
        assert running.steer("continue") == ()
        seen = list(running.events())
        assert seen == [event.Began(0, 0, 1, "jmoveC home", 0.1), PAUSED, GOOD]
        assert running.result() is GOOD
    assert running.outcome.exit_code == 0
    assert not any(isinstance(message, request.Abort) for message in runtime.made.requests)


def test_a_run_that_its_program_leaves_is_aborted(runtime):  # R-E10
    runtime.script = (
        event.Began(0, 0, 1, "jmoveC home", 0.1),
        event.Result(False, Reason.plain("x"), 0, 1, 1.0, 1.0, {}, (), ""),
    )
    with pytest.raises(RuntimeError), start(RunSettings("go_home"), SITE):
        raise RuntimeError("something else")
    assert request.Abort(Reason.of("desk.program_left")) in runtime.made.requests


def test_a_program_is_told_every_fault_of_an_application_that_it_cannot_begin(runtime):  # R-E01
    runtime.faults = (
        request.FaultText("a.rmod", 3, Reason.plain("expected one, found two"), Reason.plain("left out")),
    )
    with pytest.raises(ValueError, match=r"a\.rmod:3: expected one, found two"), start(RunSettings("go_home"), SITE):
        pass


def test_an_application_that_cannot_be_read_starts_no_runtime(runtime):  # R-E01
    outcome = run(RunSettings("nothing_like_it"), SITE, KeepingWatcher())
    assert (outcome.exit_code, runtime.made) == (2, None)


def test_a_question_is_answered_by_the_watcher(runtime):  # law 25
    runtime.script = (ASKED, GOOD)
    outcome, _ = go(may_ask=True)
    assert request.Reply("flow0", "gauge", "an answer for gauge") in runtime.made.requests
    assert outcome.exit_code == 0


def test_where_nobody_answers_the_run_is_aborted(runtime, monkeypatch):  # law 25
    runtime.script = (ASKED, GOOD)
    monkeypatch.setattr(KeepingWatcher, "answer", lambda *_: None)
    go(may_ask=True)
    assert runtime.made.requests[2] == request.Abort(Reason.of("desk.nobody_answers", task="gauge"))


def control_c():
    signal.raise_signal(signal.SIGINT)


def test_control_c_stops_the_run_and_its_end_is_still_heard(runtime):  # R-E07
    aborted = event.Result(False, Reason.plain("stopped"), 0, 1, 0.5, 0.5, {}, (), "")
    runtime.script = (event.Done(0, 0, 0.1), control_c, event.Done(0, 0, 0.2), aborted)
    outcome, watcher = go()
    assert runtime.made.requests[2] == request.Stop(Reason.of("desk.stopped_by_user"))
    assert len(watcher.seen) == 4
    assert (outcome.state, outcome.exit_code, outcome.printed) == ("aborted", 1, "it printed this")


def test_control_c_while_a_run_that_is_over_is_being_ended_loses_no_result(runtime, monkeypatch):  # R-E07
    former, leave = signal.getsignal(signal.SIGINT), runtime.__exit__

    def struck_leave(self, *wrong):
        control_c()
        return leave(self, *wrong)

    monkeypatch.setattr(runtime, "__exit__", struck_leave)
    runtime.script = (GOOD,)
    outcome, _ = go()
    assert (outcome.state, outcome.exit_code, runtime.made.requests[-1]) == ("completed", 0, "closed")
    assert signal.getsignal(signal.SIGINT) is former


def test_a_second_control_c_ends_everything(runtime):  # R-E07
    runtime.script = (control_c, control_c)
    with pytest.raises(KeyboardInterrupt):
        go()
    assert runtime.made.requests[-1] == "closed"


def test_a_lost_runtime_is_an_aborted_run_that_tells_what_was_done(runtime):  # R-E10
    runtime.script = (event.Done(0, 0, 1.0), closed("the other side is gone"))
    outcome, _ = go()
    assert (outcome.state, outcome.exit_code) == ("aborted", 1)
    assert (outcome.result.done, outcome.result.of) == (1, 1)
    assert "the other side is gone" in str(outcome.result.cause)


@pytest.mark.parametrize("fault", [closed("never came up"), TimeoutError("no greeting")])
def test_a_runtime_that_does_not_come_up_is_an_aborted_run(runtime, monkeypatch, fault):  # R-E10
    def refuse(_self):
        raise fault

    monkeypatch.setattr(runtime, "__enter__", refuse)
    outcome, watcher = go()
    assert (outcome.exit_code, watcher.seen) == (1, [])
    assert str(fault) in str(outcome.result.cause)


def test_a_run_that_the_runtime_will_not_begin_is_aborted(runtime):
    runtime.begins = request.Refused(Reason.plain("an application runs already"))
    outcome, _ = go()
    assert (str(outcome.result.cause), outcome.exit_code) == ("an application runs already", 1)


def test_a_picture_is_asked_for_only_where_it_is_wanted(runtime):
    runtime.script = (GOOD,)
    assert go()[0].snapshots == {}
    assert request.Snapshot() not in runtime.made.requests
    runtime.script = (GOOD,)
    assert go(wants_picture=True)[0].snapshots == {"boxes": b"drawn"}


def test_scaled_time_and_other_subsystems_are_the_runtimes_business(runtime):  # R-A06, R-X08
    runtime.script = (GOOD,)
    outcome, _ = go(is_virtual=True, scale=10.0, subsystems=("left",))
    assert outcome.exit_code == 0
    assert runtime.made.options == ("--scale", "10")
    assert runtime.made.requests[0].plan.flows[0].subsystem == "left"


def test_too_many_names_of_subsystems_are_refused_before_anything_runs(runtime):
    outcome, _ = go(subsystems=("left", "right"))
    assert outcome.exit_code == 2
    assert outcome.faults[0].reason == Reason.of("desk.flows_by_name", count=1, names="left right")


def test_the_seed_of_shaken_worlds_is_the_runtimes_business(runtime):  # R-X07
    runtime.script = (GOOD,)
    go(is_virtual=True, shake=7)
    assert runtime.made.options == ("--shake", "7")


def test_a_runtime_that_will_not_take_the_plan_refuses_the_run(runtime):  # law 23
    runtime.refuses = "code from another machine is not accepted"
    outcome, _ = go()
    assert outcome.exit_code == 2
    assert (
        str(outcome.faults[0].reason) == "it does not take the application: code from another machine is not accepted"
    )
