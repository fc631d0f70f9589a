import pytest

from kit.desk.live_runtime import LiveRuntime
from onika.desk.console.session import ConsoleSession
from onika.wire import event, live, request
from onika.wire.plan import Plan
from onika.words.reason import NOTHING, Reason


def test_a_console_listens_to_all_and_chooses_the_only_subsystem(sit):  # R-A06
    sitting = sit()
    assert sitting.requests_of(live.Attend)[0].subsystems == ("*",)
    sitting.does("spawn left/puma")
    other = ConsoleSession(sitting.runtime, sitting.session.site, sitting, sitting.clock)
    other.begin()
    assert (sitting.session.subsystem, other.subsystem) == ("main", "left")


def test_a_runtime_that_cannot_be_operated_by_hand_says_so(sit):
    sitting = sit()
    sitting.runtime.refusals["Attend"] = "an older runtime"
    (fault,) = sitting.session.begin()
    assert str(fault.reason) == "expected a runtime that can be operated by hand, found an older runtime"
    sitting.runtime.refusals["Survey"] = "an older runtime"
    with pytest.raises(ValueError, match="an older runtime"):
        sitting.session.look_again()


def test_what_there_is_is_asked_once_until_something_happens(sit):
    sitting = sit()
    sitting.does("spawn puma")
    sitting.session.standing()
    count = len(sitting.requests_of(live.Survey))
    sitting.session.tasks()
    assert len(sitting.requests_of(live.Survey)) == count
    sitting.runtime.tell(event.Held("main", "ada"))
    sitting.session.hear()
    sitting.session.tasks()
    assert len(sitting.requests_of(live.Survey)) == count + 1


def test_an_outcome_that_does_not_come_is_not_waited_for_for_ever(sit, monkeypatch):
    sitting = sit()
    monkeypatch.setattr(sitting.runtime, "_edit", lambda message: live.Accepted(99))
    fault = sitting.fails("spawn puma")
    assert str(fault.reason) == "expected the change to be done, found not so within 30 s"


def test_outcomes_of_others_are_not_kept_for_ever(sit):
    sitting = sit()
    for number in range(1000):
        sitting.runtime.tell(event.Edited("other", number, NOTHING, 0.0))
    sitting.session.hear()
    assert len(sitting.session._edits) <= 64
    sitting.does("spawn puma")


def test_tasks_that_an_application_moves_are_told_by_its_actions_only(sit):
    sitting = sit()
    sitting.console.carry_out("run go_home")
    sitting.runtime.tell(event.TaskState("flow0", "puma", "ON", 0.0))
    sitting.runtime.tell(event.TaskState("main", "diff", "ON", 0.0))
    sitting.session.hear()
    assert not any("flow0/puma" in line for line in sitting.lines)
    assert any("main/diff ON" in line for line in sitting.lines)


def test_a_question_is_over_when_its_task_goes_another_way(asking):
    asking.does("spawn jtraj", "on jtraj", "off jtraj")
    assert asking.session.questions == {}


def test_notes_are_said_and_faults_of_files_keep_their_places(sit):
    sitting = sit()
    runtime = sitting.runtime
    fault = request.FaultText("a.rmod", 3, Reason.plain("expected x, found y"), Reason.plain("z"))
    runtime_ask = runtime.ask
    runtime.ask = lambda message: (
        request.Prepared((fault,), (Reason.plain("worth knowing"),))
        if isinstance(message, request.Prepare)
        else runtime_ask(message)
    )
    (refusal,) = sitting.session.order(request.Prepare(Plan("x", (), ()), ()))
    assert str(refusal) == "a.rmod:3: expected x, found y; instead: z"
    assert "note: worth knowing" in sitting.lines


def test_what_is_looked_at_in_between_is_not_begun_anew_by_itself(sit):
    sitting = sit()
    calls = []

    def tick():
        calls.append(len(calls))
        sitting.session.hear()

    sitting.session.ticks.append(tick)
    sitting.session.hear()
    assert calls == [0]


def test_a_played_runtime_and_a_real_one_are_alike_to_a_session():
    from onika.desk.run.launched_runtime import LaunchedRuntime

    assert {"ask", "events"} <= set(dir(LiveRuntime)) & set(dir(LaunchedRuntime))
