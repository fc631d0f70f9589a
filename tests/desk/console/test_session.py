import pytest

from kit.live_runtime import LiveRuntime
from onika.desk.console.session import Session
from onika.wire import event, live, request
from onika.wire.plan import Plan


def test_a_console_listens_to_all_and_chooses_the_only_subsystem(sit):  # R-A06
    one = sit()
    assert one.asked(live.Attend)[0].subsystems == ("*",)
    one.does("spawn left/puma")
    other = Session(one.runtime, one.session.site, one, one.clock)
    other.begin()
    assert (one.session.subsystem, other.subsystem) == ("main", "left")


def test_a_runtime_that_cannot_be_operated_by_hand_says_so(sit):
    one = sit()
    one.runtime.refusals["Attend"] = "an older runtime"
    (fault,) = one.session.begin()
    assert fault.found == "an older runtime"
    one.runtime.refusals["Survey"] = "an older runtime"
    with pytest.raises(ValueError, match="an older runtime"):
        one.session.look_again()


def test_what_there_is_is_asked_once_until_something_happens(sit):
    one = sit()
    one.does("spawn puma")
    one.session.standing()
    asked = len(one.asked(live.Survey))
    one.session.tasks()
    assert len(one.asked(live.Survey)) == asked
    one.runtime.tell(event.Held("main", "ada"))
    one.session.hear()
    one.session.tasks()
    assert len(one.asked(live.Survey)) == asked + 1


def test_an_outcome_that_does_not_come_is_not_waited_for_for_ever(sit, monkeypatch):
    one = sit()
    monkeypatch.setattr(one.runtime, "_edit", lambda asked: live.Accepted(99))
    fault = one.fails("spawn puma")
    assert (fault.expected, fault.found) == ("the change to be done", "not so within 30 s")


def test_outcomes_of_others_are_not_kept_for_ever(sit):
    one = sit()
    for number in range(1000):
        one.runtime.tell(event.Edited("other", number, "", 0.0))
    one.session.hear()
    assert len(one.session._edits) <= 64
    one.does("spawn puma")


def test_tasks_that_an_application_moves_are_told_by_its_actions_only(sit):
    one = sit()
    one.console.carry_out("run go_home")
    one.runtime.tell(event.TaskState("flow0", "puma", "ON", 0.0))
    one.runtime.tell(event.TaskState("main", "diff", "ON", 0.0))
    one.session.hear()
    assert not any("flow0/puma" in line for line in one.lines)
    assert any("main/diff ON" in line for line in one.lines)


def test_a_question_is_over_when_its_task_goes_another_way(asking):
    asking.does("spawn jtraj", "on jtraj", "off jtraj")
    assert asking.session.questions == {}


def test_notes_are_said_and_faults_of_files_keep_their_places(sit):
    one = sit()
    runtime = one.runtime
    fault = request.FaultText("a.rmod", 3, "x", "y", "z")
    runtime_ask = runtime.ask
    runtime.ask = lambda asked: (
        request.Prepared((fault,), ("worth knowing",)) if isinstance(asked, request.Prepare) else runtime_ask(asked)
    )
    (found,) = one.session.order(request.Prepare(Plan("x", (), ()), ()))
    assert str(found) == "a.rmod:3: expected x, found y; instead: z"
    assert "note: worth knowing" in one.lines


def test_what_is_looked_at_in_between_is_not_begun_anew_by_itself(sit):
    one = sit()
    calls = []

    def tick():
        calls.append(len(calls))
        one.session.hear()

    one.session.ticks.append(tick)
    one.session.hear()
    assert calls == [0]


def test_a_played_runtime_and_a_real_one_are_alike_to_a_session():
    from onika.desk.run.runtime import Runtime

    assert {"ask", "events"} <= set(dir(LiveRuntime)) & set(dir(Runtime))
