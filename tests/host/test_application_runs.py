import pytest

from kit.plans.plan_builder import action
from kit.runtime.direct_client import DirectClient
from kit.worlds.rail_world import rail_tasks
from onika.ring.segment import Segment, SharedMemoryRefused
from onika.wire import event, live, request
from onika.wire.request import TargetValues
from onika.words.reason import Reason


@pytest.fixture
def desk():
    return DirectClient()


def plan(*goals, **settings):
    return rail_tasks(**settings).plan([action("mass", "servo", arguments=goal) for goal in goals])


def test_a_faulty_plan_is_not_begun(desk):  # R-E01
    targets = (TargetValues(0, 0, "joint object", (99.0,)),)
    answer = desk.ask(request.Prepare(plan("1.0"), targets))
    assert [str(fault.reason) for fault in answer.faults] == [
        "expected a target within reach, found there: 99 m is beyond the rail"
    ]
    assert str(desk.ask(request.Begin()).reason) == "no plan is prepared, or it has faults"
    assert desk.result is None


def test_without_a_plan_nothing_begins(desk):
    assert isinstance(desk.ask(request.Begin()), request.Refused)


def test_a_plan_with_faults_leaves_nothing_to_run(desk):  # R-E01
    desk.ask(request.Prepare(plan("1.0"), ()))
    assert desk.program.applications.prepared("me") is not None
    desk.ask(request.Prepare(plan("1.0"), (TargetValues(0, 0, "joint object", (99.0,)),)))
    assert desk.program.applications.prepared("me") is None
    assert desk.ask(request.Begin()).reason == Reason.of("host.no_plan")


def test_a_plan_is_for_the_session_that_prepared_it(desk):  # R-X12
    desk.ask(request.Prepare(plan("1.0"), ()), "me")
    desk.ask(request.Prepare(plan("2.0"), ()), "other")
    applications = desk.program.applications
    applications.forget("other")
    assert applications.prepared("other") is None
    assert applications.prepared("me").plan.flows[0].actions[0].arguments == "1.0"
    applications.forget("nobody")


def test_no_run_begins_in_what_another_session_holds_and_one_begins_in_ones_own(desk):  # R-X12
    desk.ask(request.Prepare(plan("1.0"), ()), "me")
    assert desk.ask(live.Take("flow0"), "other") == request.Done()
    assert isinstance(desk.ask(request.Begin(), "me"), request.Refused)
    desk.ask(request.Prepare(plan("1.0"), ()), "other")
    assert desk.ask(request.Begin(), "other") == request.Done()


def test_a_second_run_beside_the_first_is_refused(desk):  # law 4
    desk.ask(request.Prepare(plan("1.0"), ()))
    desk.ask(request.Begin())
    desk.program.advance(0)
    refusal = desk.ask(request.Begin()).reason
    assert str(refusal) == "application test runs in subsystem flow0 already; let it end, or abort it"
    assert desk.to_the_end().completed


def test_runs_follow_one_another_each_with_its_own_time_and_empty_table(desk):  # laws 4, 13
    desk.ask(request.Prepare(plan("1.0"), ()))
    results = []
    for _ in range(2):
        desk.ask(request.Begin(watch=("FORCE",)))
        results.append(desk.to_the_end())
    assert all(result.completed for result in results)
    assert results[1].runtime_s < results[0].runtime_s


def test_after_a_stop_nothing_begins_before_a_deliberate_reset(desk):  # law 27
    desk.ask(request.Prepare(plan("1.0"), ()))
    desk.ask(request.Begin())
    desk.ask(request.Stop(Reason.plain("enough")))
    assert not desk.to_the_end().completed
    assert str(desk.ask(request.Begin()).reason) == "the runtime is stopped; reset it first"
    assert desk.ask(live.Reset()) == request.Done()
    assert [message.is_stopped for message in desk.of(event.Stopped)] == [True, False]
    desk.ask(request.Begin())
    assert desk.to_the_end().completed


def test_a_run_for_which_there_is_no_memory_is_refused_and_begins_when_there_is(desk, monkeypatch, tmp_path):  # R-B07
    def refuse(_name, _size):
        raise SharedMemoryRefused(Reason.of("words.shared_memory", why=Reason.of("words.memory_used")))

    desk.ask(request.Prepare(plan("1.0"), ()))
    begin = request.Begin(record=str(tmp_path / "run.mcap"))
    with monkeypatch.context() as short:
        short.setattr(Segment, "create", refuse)
        assert desk.ask(begin).reason.key == "words.shared_memory"
        assert (
            desk.ask(live.Change("s0", spawn=plan("1.0").flows[0].tasks, code=plan("1.0").code)).reason.key
            == "words.shared_memory"
        )
    assert not desk.program.is_running
    assert desk.ask(begin) == request.Done()
    assert desk.to_the_end().completed
