from time import monotonic_ns

import pytest
from msgspec.structs import replace

from kit.plans.plan_builder import action
from kit.runtime.direct_client import DirectClient
from kit.worlds.rail_world import YardLoading, rail_tasks
from onika.host.loading.loader_client import NotYet
from onika.wire import event, live, request
from onika.wire.plan import Again, Do, Halt
from onika.wire.runtime_standing import Standing
from onika.words.reason import Reason

SECOND = 1_000_000_000


@pytest.fixture
def desk():
    return DirectClient()


def plan(*goals, **settings):
    return rail_tasks(**settings).plan([action("mass", "servo", arguments=goal) for goal in goals])


def test_a_plan_is_prepared_begun_and_its_result_told_last(desk):  # R-E01, R-E03, R-E14
    assert desk.ask(request.Prepare(plan("1.0", "2.0"), ())) == request.Prepared(())
    assert desk.ask(request.Begin(watch=("X",))) == request.Done()
    assert desk.program.is_running
    result = desk.to_the_end()
    assert (result.completed, result.done, result.of) == (True, 2, 2)
    assert result.values["X"][0] == pytest.approx(2.0, abs=0.05)
    assert len(result.hash) == 64
    assert not desk.program.is_running
    assert desk.program.advance(SECOND) is False


def test_the_last_word_of_a_drive_comes_before_the_result(desk):  # law 17
    desk.ask(request.Prepare(plan("1.0"), ()))
    desk.ask(request.Begin())
    desk.to_the_end()
    drives = [number for number, message in enumerate(desk.server.events) if isinstance(message, event.Drive)]
    assert desk.server.events[drives[-1]].state == "HELD"
    assert drives[-1] < len(desk.server.events) - 1


def test_a_world_whose_file_was_changed_is_told_of_and_goes_on(tmp_path, monkeypatch):  # law 21
    path = tmp_path / "yard.py"
    path.write_text("one")
    monkeypatch.setattr("onika.host.units.world_files.source_files", lambda _module: (path,))
    desk = DirectClient()
    desk.ask(request.Prepare(plan("1.0"), ()))
    desk.ask(request.Begin())
    while not desk.of(event.Drive):
        desk.program.advance(0)
    path.write_text("other")
    monkeypatch.setattr("onika.host.program.monotonic_ns", lambda: monotonic_ns() + 2 * SECOND)
    desk.program.advance(0)
    assert [(told.world, told.is_outdated) for told in desk.of(event.Outdated)] == [("yard", True)]
    assert desk.to_the_end().completed
    assert len(desk.of(event.Outdated)) == 1


def test_a_world_is_touched_and_what_is_not_there_refused(desk):  # R-K06
    assert (
        str(desk.ask(live.Touch("yard", "panic", 1.0)).reason) == "expected an open world (none is open), found 'yard'"
    )
    desk.ask(request.Prepare(plan("1.0"), ()))
    desk.ask(request.Begin())
    while "DRIVEN" not in [message.state for message in desk.of(event.Drive)]:
        desk.program.advance(0)
    assert desk.ask(live.Touch("yard", "panic", 1.0)) == request.Done()
    refused = desk.ask(live.Touch("yard", "bell", 1.0))
    assert str(refused.reason) == "expected 1 or 0 for panic, found 1 for 'bell'"
    assert [(told.world, told.part, told.value) for told in desk.of(event.Touched)] == [("yard", "panic", 1.0)]
    desk.program.advance(0)
    assert desk.of(event.Drive)[-1].state == "PRESSED"
    desk.ask(request.Abort(Reason.plain("enough")))
    assert str(desk.to_the_end().cause) == "enough"


@pytest.mark.parametrize("wish", [request.Abort(Reason.plain("enough")), request.Stop(Reason.plain("enough"))])
def test_a_run_is_ended_from_outside_with_the_cause(desk, wish):  # R-E07, law 27
    desk.ask(request.Prepare(plan("1.0"), ()))
    desk.ask(request.Begin())
    for _ in range(50):
        desk.program.advance(0)
    assert desk.ask(wish) == request.Done()
    result = desk.to_the_end()
    assert (result.completed, str(result.cause), result.done) == (False, "enough", 0)
    assert [message.state for message in desk.server.events if isinstance(message, event.Drive)][-1] == "HELD"


def test_an_answer_reaches_the_task_that_asks(desk):  # law 25
    desk.ask(request.Prepare(rail_tasks().plan([action("mass", "servo")]), ()))
    desk.ask(request.Begin(may_ask=True))
    assert desk.to_the_end() is None
    question = desk.server.events[-1]
    assert isinstance(question, event.Asked)
    (home,) = desk.ask(live.Survey()).subsystems
    assert (home.asks, home.on_loss) == ((question,), "stop")  # who comes later can be asked too
    desk.ask(request.Reply("flow0", "servo", "0.5"))
    assert desk.to_the_end().completed


def test_tasks_are_checked_against_their_modules_without_a_run(desk):  # R-B01
    shop = rail_tasks()
    task = shop.task("mass", shop.code("mass").source, frequency=20.0)
    faults = desk.ask(request.Inspect((task,), (shop.code("mass"),))).faults
    assert {fault.reason.key for fault in faults} == {"runtime.hardware_too_slow", "runtime.device_missing"}


def test_a_task_on_a_unit_that_is_not_there_runs_on_the_first():  # reading 12
    desk = DirectClient(("left", "right"))
    desk.ask(request.Prepare(plan("1.0", rtpu="nowhere"), ()))
    desk.ask(request.Begin())
    assert {task.task: task.rtpu for task in desk.to_the_end().tasks} == {"mass": "left", "servo": "left"}


def test_the_worlds_are_shown_as_they_stand(desk):
    assert desk.ask(request.Snapshot()) == request.Worlds({})
    desk.ask(request.Prepare(plan("1.0"), ()))
    desk.ask(request.Begin())
    desk.to_the_end()
    assert desk.ask(request.Snapshot()).snapshots.keys() == {"yard"}


def test_quit_ends_the_program(desk):
    assert not desk.program.is_over
    assert desk.ask(request.Quit()) == request.Done()
    assert desk.program.is_over


def test_to_abort_what_does_not_run_is_harmless(desk):
    assert desk.ask(request.Abort(Reason.plain("x"))) == request.Done()
    assert isinstance(desk.ask(request.Reply("flow0", "servo", "1")), request.Refused)


def test_a_run_that_goes_on_without_its_session_can_be_ended_by_others(desk):  # R-X12
    desk.ask(request.Prepare(plan("1.0"), ()), "gone")
    desk.ask(request.Begin(on_loss="run"), "gone")
    desk.server.gone.append("gone")
    desk.program.serve()
    assert desk.ask(request.Abort(Reason.plain("enough")), "another") == request.Done()
    assert str(desk.to_the_end().cause) == "enough"


class SlowLoading(YardLoading):
    """Answers from the second time on, as a loader that is asked without waiting does."""

    def __init__(self):
        super().__init__()
        self.is_patient = False

    def sheet(self, code):
        if not self.is_patient:
            raise NotYet
        return super().sheet(code)


def test_who_may_change_a_subsystem_is_judged_when_the_change_is_carried_out(monkeypatch):  # law 27
    desk = DirectClient()
    loading = SlowLoading()
    monkeypatch.setattr(desk.program, "_loading", loading)
    monkeypatch.setattr(desk.program._editor, "_loading", loading)
    shop = rail_tasks()
    change = live.Change("s0", spawn=(shop.planned("servo"),), code=(shop.code("servo"),))
    first, second = desk.send(change, "first"), desk.send(change, "second")
    assert desk.server.replies == {}
    loading.is_patient = True
    for call, answer in desk.program._backlog.take():
        desk.program._try(call, answer)
    assert isinstance(desk.server.replies[first], live.Accepted)
    assert "held by first" in str(desk.server.replies[second].reason)


def test_nobody_waits_behind_a_description(monkeypatch):  # law 21
    desk = DirectClient()
    loading = SlowLoading()
    monkeypatch.setattr(desk.program, "_loading", loading)
    shop = rail_tasks()
    described = desk.send(live.Describe((shop.code("servo"),)), "first")
    changed = desk.send(live.Change("s0", spawn=(shop.planned("servo"),), code=(shop.code("servo"),)), "first")
    assert described not in desk.server.replies and isinstance(desk.server.replies[changed], live.Accepted)
    loading.is_patient = True
    for call, answer in desk.program._backlog.take():
        desk.program._try(call, answer)
    assert set(desk.server.replies[described].sheets) == {shop.code("servo").digest}


def test_motion_is_allowed_again_whatever_waits_for_the_loader(monkeypatch):  # law 27
    desk = DirectClient()
    monkeypatch.setattr(desk.program, "_loading", SlowLoading())
    monkeypatch.setattr(desk.program._editor, "_loading", desk.program._loading)
    shop = rail_tasks()
    desk.send(live.Change("s0", spawn=(shop.planned("servo"),), code=(shop.code("servo"),)), "first")
    assert desk.ask(request.Stop(Reason.plain("now")), "first") == request.Done() and desk.program.motion.is_stopped
    assert desk.ask(live.Reset(), "first") == request.Done() and not desk.program.motion.is_stopped


def test_a_loop_that_takes_no_time_can_be_ended(desk):  # R-E07, R-D13
    straight = plan("0.0")
    endless = (Do(0), Again("again", 0, "X[0] < 3"), Halt())
    flow = replace(straight.flows[0], program=endless)
    desk.ask(request.Prepare(replace(straight, flows=(flow,)), ()))
    assert desk.ask(request.Begin()) == request.Done()
    for _ in range(3):
        desk.program.advance(1_000_000)
    assert desk.ask(request.Abort(Reason.plain("enough"))) == request.Done()
    assert str(desk.to_the_end().cause) == "enough"


def test_a_long_way_without_anything_to_do_is_gone_in_parts_and_others_are_heard(desk):  # R-F01
    desk.ask(request.Prepare(plan("1.0"), ()))
    desk.ask(request.Begin())
    desk.to_the_end()  # its world is open from now on
    at_ns = desk.program._driver.now
    desk.send(live.Advance(3600.0))
    desk.program.advance(0)
    assert at_ns < desk.program._driver.now < at_ns + 10 * SECOND
    assert isinstance(desk.ask(live.Survey(), "somebody"), Standing)
