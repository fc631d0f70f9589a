import pytest
from msgspec import structs

from kit.plans.plan_builder import action
from kit.runtime.direct_client import DirectClient
from kit.worlds.rail_world import rail_tasks
from onika.record.summary import summary
from onika.wire import event, live, request, steer
from onika.words.reason import Reason


@pytest.fixture
def desk():
    return DirectClient()


def plan(*goals, home="flow0", mass="yard:m0", name="left"):
    planned = rail_tasks(mass=mass).plan([action("mass", "servo", arguments=goal) for goal in goals])
    (flow,) = planned.flows
    return structs.replace(planned, application=name, flows=(structs.replace(flow, subsystem=home),))


def begin(desk, planned, session="me", **options):
    assert desk.ask(request.Prepare(planned, ()), session) == request.Prepared(())
    assert desk.ask(request.Begin(**options), session) == request.Done()


@pytest.fixture
def two(desk):
    """Two applications of one session, each with a mass of its own."""
    begin(desk, plan("1.0", "2.0"))
    begin(desk, plan("-1.0", home="flow1", mass="yard:m1", name="right"))
    return desk


def results(desk):
    return {message.run: message for message in desk.of(event.Result)}


def drives(desk):
    return {message.device: message.state for message in desk.of(event.Drive)}


def onwards(desk, steps=50):
    for _ in range(steps):
        desk.program.advance(0)


def test_two_applications_of_one_session_run_side_by_side(two):  # R-C18, R-E12
    homes = {home.name: home.application for home in two.ask(live.Survey()).subsystems}
    assert homes == {"flow0": "left", "flow1": "right"}
    two.to_the_end()
    assert {home: (result.completed, result.done) for home, result in results(two).items()} == {
        "flow0": (True, 2),
        "flow1": (True, 1),
    }


def test_each_tells_whose_its_actions_are(two):  # R-C18, R-E11
    two.to_the_end()
    began = [(message.run, message.flow, message.index) for message in two.of(event.Began)]
    assert sorted(began) == [("flow0", 0, 0), ("flow0", 0, 1), ("flow1", 0, 0)]
    assert sorted(message.run for message in two.of(event.Done)) == ["flow0", "flow0", "flow1"]


def test_who_claims_which_device_is_said(two):  # R-C18
    onwards(two)
    homes = two.ask(live.Survey()).subsystems
    assert {home.name: {task.task.name: task.claims for task in home.tasks} for home in homes} == {
        "flow0": {"mass": "yard:m0", "servo": ""},
        "flow1": {"mass": "yard:m1", "servo": ""},
    }


def test_one_is_ended_and_the_other_goes_on(two):  # R-C18, R-E07
    onwards(two)
    assert two.ask(request.Abort(Reason.plain("enough"), "flow0")) == request.Done()
    two.to_the_end()
    assert not results(two)["flow0"].completed and results(two)["flow1"].completed


def test_one_is_paused_and_the_other_goes_on(two):  # R-C18, R-E07
    onwards(two)
    assert two.ask(steer.Pause("flow0")) == request.Done()
    two.to_the_end()
    assert set(results(two)) == {"flow1"}
    assert two.ask(steer.Resume("flow0")) == request.Done()
    two.to_the_end()
    assert results(two)["flow0"].completed


def test_a_stop_beats_all_of_them(two):  # R-C18, law 27
    onwards(two)
    assert set(drives(two).values()) == {"DRIVEN"}
    two.ask(request.Stop(Reason.plain("a hand")), session="anybody")
    two.to_the_end()
    assert {str(result.cause) for result in results(two).values()} == {"a hand"} and len(results(two)) == 2
    assert set(drives(two).values()) == {"HELD"}
    assert isinstance(two.ask(request.Begin()), request.Refused)


def test_the_loss_of_their_session_ends_both(two):  # R-X12
    onwards(two)
    two.server.gone.append("me")
    two.program.serve()
    two.to_the_end()
    assert [result.completed for result in results(two).values()] == [False, False]
    assert set(drives(two).values()) == {"HELD"}


def test_the_recording_of_one_ends_with_it_and_not_with_the_other(desk, tmp_path):  # R-X05
    file = tmp_path / "right.mcap"
    begin(desk, plan("-1.0", "-2.0", "-3.0", home="flow1", mass="yard:m1", name="right"), record=str(file))
    begin(desk, plan("1.0"))
    while desk.program.advance(0):  # instant by instant, so that each end is told when it comes
        pass
    assert [message.run for message in desk.of(event.Result)] == ["flow0", "flow1"]
    recording = summary(file)
    assert recording.application == "right" and recording.is_whole
    assert recording.took_s == pytest.approx(results(desk)["flow1"].runtime_s, abs=0.1)


def test_one_device_serves_one_of_them(desk):  # R-C18, law 16
    begin(desk, plan("1.0"))
    onwards(desk)
    begin(desk, plan("-1.0", home="flow1", name="right"))
    desk.to_the_end()
    assert results(desk)["flow0"].completed and not results(desk)["flow1"].completed
