import pytest

from onika.desk.run.steering import SteeringOrder
from onika.wire import event, live, request, steer
from onika.words.condition import Condition
from onika.words.fault import Place
from onika.words.reason import NOTHING, Reason

BEGAN = event.Began(0, 0, 2, "jmoveC aside", 1.0)
PAUSED = event.Moved("flow0", "paused", 0, 2.0)
GOOD = event.Result(True, NOTHING, 4, 4, 9.0, 0.1, {"LAMP": 1}, (), "abc")


def test_a_run_begins_as_its_settings_say(running):  # R-E01, R-E08, R-E10
    _, runtime = running(settle_s=0.25, seed=3, on_error="wait", on_loss="finish", may_ask=True)
    assert runtime.requests[0] == request.Begin((), 0.25, 3, (), True, on_loss="finish", on_error="wait", is_held=True)


def test_a_run_that_the_runtime_will_not_begin_is_over(running, monkeypatch):
    run, _ = running()
    sought = []
    monkeypatch.setattr(run._runtime, "refusals", {"Begin": "an application runs already"})
    monkeypatch.setattr(run._runtime, "black_box", lambda: sought.append("black box"))
    run.begin()
    assert (run.is_over, run.is_aborted, run.outcome.result.cause) == (True, True, "an application runs already")
    assert not sought  # to look for one that nobody writes took a second


def test_the_clock_of_a_held_run_goes_on_only_while_somebody_listens(running):  # R-E07, law 15
    run, runtime = running(BEGAN, PAUSED, GOOD)
    list(run.hear())
    assert (run.stands, run.now_s, runtime.now_s) == (True, 0.0, 0.0)
    assert run.wait("1.5") == ()
    assert run.now_s == runtime.now_s == 1.5
    assert list(run.events()) == [BEGAN, PAUSED, GOOD]


def test_what_is_steered_in_a_held_run_is_done_before_time_passes(running):  # R-E07
    run, runtime = running(BEGAN, GOOD)
    assert run.wait("began flow0 1") == ()
    assert run.steer("pause flow0") == ()
    assert runtime.requests[-2:] == [steer.Pause("flow0"), steer.Onward(1.0)]
    assert (run.now_s, run.stands) == (1.0, True)


def test_a_wait_is_over_when_the_time_of_its_moment_is_known_too(running, monkeypatch):  # R-E07, law 14
    run, runtime = running(BEGAN, PAUSED, GOOD)

    def one_by_one(*_args, **_named):
        if runtime.pending:
            yield runtime.pending.pop(0)

    monkeypatch.setattr(runtime, "events", one_by_one)
    assert run.wait("paused flow0") == ()
    assert (run.stands, run.now_s) == (True, 2.0)


def test_in_wall_time_nothing_is_held(running):  # R-E07
    run, runtime = running(BEGAN, PAUSED, GOOD, is_held=False)
    assert run.wait("began flow0 1") == ()
    assert run.steer("pause flow0") == ()
    assert run.wait("paused flow0") == ()
    assert runtime.of(steer.Onward) == []
    assert run.result() is GOOD


def test_a_wait_in_vain_is_a_fault_with_what_was_found(running):  # R-E07
    run, _ = running(BEGAN)
    (late,) = run.wait("began flow1 1", 0.5)
    assert str(late.reason) == "expected action 1 of flow1 has begun, found it not so within 0.5 s"
    assert run.now_s == 0.5
    run, _ = running(BEGAN, GOOD)
    (ended,) = run.wait("began flow1 1")
    assert str(ended.reason) == "expected action 1 of flow1 has begun, found the end of the run before"


def test_a_wait_while_a_task_asks_is_given_up(running):  # law 25
    question = event.Asked("flow0", "gauge", NOTHING, (), 0.5)
    run, runtime = running(question, BEGAN, GOOD, may_ask=True)
    (fault,) = run.wait("began flow0 1")
    assert str(fault.reason) == (
        "expected WaitCondition(kind='began', subsystem='flow0', action=0, seconds=0.0), found a task that asks"
    )
    run.answer(question, "0.5")
    runtime.pending.append(event.TaskState("flow0", "gauge", "ON", 0.5))
    assert run.wait("began flow0 1") == ()
    run.answer(question, None)
    assert runtime.of(request.Reply, request.Abort) == [
        request.Reply("flow0", "gauge", "0.5"),
        request.Abort(Reason.of("desk.nobody_answers", task="gauge")),
    ]


def test_a_variable_is_read_as_it_is_now(running):  # R-X07
    run, runtime = running()
    assert run.read("LAMP") == 1
    assert runtime.of(live.Read) == [live.Read("flow0", ("LAMP",))]
    assert run.steer("expect LAMP == 1") == ()
    (fault,) = run.steer("expect LAMP == 0")
    assert str(fault.reason) == "expected LAMP == 0, found 1"
    with pytest.raises(ValueError, match="found NOBODY"):
        run.read("NOBODY")
    runtime.refusals["Read"] = "no"
    with pytest.raises(ValueError, match="expected a value of LAMP"):
        run.read("LAMP")


def test_what_is_written_wrongly_or_refused_changes_nothing(running):  # R-E07
    run, runtime = running()
    (fault,) = run.steer("dance")
    assert (fault.place, fault.reason, str(fault.instead)) == (
        Place("line"),
        Reason.of(
            "desk.steering_word",
            words=(
                "pause",
                "continue",
                "step",
                "next",
                "skip",
                "pass",
                "leave",
                "break",
                "unbreak",
                "clear",
                "abort",
                "who",
                "touch",
                "pad",
                "wait",
                "expect",
            ),
            name="dance",
        ),
        "the run goes on as it was",
    )
    runtime.refusals["Pass"] = Reason.plain("expected flow 0 to be waiting, found it running")
    (fault,) = run.steer("pass flow0")
    assert str(fault.reason) == "expected flow 0 to be waiting, found it running"


def test_after_its_end_there_is_nothing_to_steer(running):  # R-E07
    run, runtime = running(GOOD)
    run.result()
    count = len(runtime.requests)
    (fault,) = run.do(SteeringOrder(steer.Pause("")), Place("s", 4))
    assert (fault.place, fault.reason) == (Place("s", 4), Reason.of("desk.run_over"))
    assert len(runtime.requests) == count


def test_a_key_does_not_wait_until_the_clock_stands(running):  # R-E07
    run, runtime = running(BEGAN)
    list(run.hear())
    run.go_on(50.0)
    runtime.pending.clear()
    assert run.steer("pause", at_once=True) == ()
    assert runtime.requests[-1] == steer.Pause("")


def test_where_every_flow_is_can_be_asked_at_any_time(running):  # R-X03
    run, runtime = running()
    runtime.positions = (steer.Position("flow0", "waiting", 0, "a", ("flow1",)),)
    assert run.who() == runtime.positions
    assert run.steer("who") == ()
    assert run.flow_tracker.statuses["flow0"].tag == "a"
    runtime.refusals["Who"] = "no"
    assert run.who() == ()


def test_it_stands_still_only_if_the_runtime_says_so_too(running):  # R-X03
    run, runtime = running(is_held=False)
    for flow in ("flow0", "flow1"):
        run.flow_tracker.hear(event.Moved(flow, "paused", 0, 0.5))
    runtime.positions = (steer.Position("flow0", "running", 1), steer.Position("flow1", "paused", 0))
    assert not run.is_stuck()
    run.flow_tracker.hear(event.Moved("flow0", "paused", 1, 0.5))
    runtime.positions = (steer.Position("flow0", "paused", 1), steer.Position("flow1", "paused", 0))
    assert run.is_stuck()
    run.flow_tracker.hear(event.Asked("flow0", "gauge", NOTHING, (), 0.5))
    assert not run.is_stuck()


def test_a_run_that_is_left_is_aborted_and_judged(running):  # R-E07, R-E14
    run, runtime = running(BEGAN, expectations=(Condition.parse("LAMP == 1"),))
    run.close()
    assert runtime.of(request.Abort) == [request.Abort(Reason.of("desk.program_left"))]
    assert (run.is_aborted, run.outcome.printed) == (True, "it printed this")
    assert [holds for _, _, holds in run.outcome.expectations] == [False]


def test_a_picture_is_taken_where_it_is_wanted(running):
    run, _ = running(GOOD, wants_picture=True)
    run.result()
    run.close()
    assert run.outcome.snapshots == {"boxes": b"drawn"}
    assert run.outcome.exit_code == 0


def test_a_runtime_that_is_lost_ends_the_run_with_the_cause(running):  # R-E10
    run, runtime = running(BEGAN)
    run.wait("began flow0 1")
    runtime.is_lost = True
    run.close()
    assert (run.is_aborted, "it is gone" in str(run.outcome.result.cause)) == (True, True)


def test_to_stop_is_the_runtimes_business(running):  # law 27
    run, runtime = running()
    run.stop(Reason.plain("enough"))
    assert runtime.requests[-1] == request.Stop(Reason.plain("enough"))
    assert run.pid == 4711


def test_what_modules_declare_is_told_by_the_runtime(running, monkeypatch):  # R-X07, law 24
    run, runtime = running()
    assert run.sheets() == {}
    monkeypatch.setattr(run._runtime, "ask", lambda message: live.Described({message.code[0].digest: "sheet"}))
    assert run.sheets() == {run.plan.code[0].digest: "sheet"}
    assert runtime.of(live.Describe)[0].code == run.plan.code
