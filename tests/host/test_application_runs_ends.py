"""What begins with a run of an application ends with it: its clock, its repetition, its recording, its black box."""

import pytest

from kit.plans.plan_builder import PlanBuilder, action
from kit.runtime.direct_client import DirectClient
from kit.worlds.rail_world import rail_tasks
from onika.desk.run.run_review import Review
from onika.host.recording.black_box_holder import InProcessHolder
from onika.record.black_box_folder import black_boxes
from onika.record.reader import Reader
from onika.record.run import RunRecord
from onika.runtime import news
from onika.wire import event, live, request, steer
from onika.wire.request import Recorded
from onika.words.reason import Reason

MS = 1_000_000
BELL = """
from onika.module import Module, finish

class Bell(Module):
    trigger = True

    def cycle(self):
        return finish()
"""


@pytest.fixture
def desk():
    return DirectClient()


def plan(*goals, home="flow0", **settings):
    planned = rail_tasks(**settings).plan([action("mass", "servo", arguments=goal) for goal in goals])
    (flow,) = planned.flows
    return type(planned)(planned.application, (type(flow)(home, flow.tasks, flow.actions),), planned.code)


def begin(desk, planned, session="me", **options):
    assert desk.ask(request.Prepare(planned, ()), session) == request.Prepared(())
    assert desk.ask(request.Begin(**options), session) == request.Done()


def repeated(at_ms, message):
    return Recorded(at_ms * MS, 0, request.encode(message))


def test_a_run_that_cannot_be_recorded_does_not_begin(desk, tmp_path):  # R-E01, law 29
    desk.ask(request.Prepare(plan("1.0"), ()))
    answer = desk.ask(request.Begin(record=str(tmp_path / "none" / "run.mcap")))
    assert isinstance(answer, request.Refused)
    assert not desk.program.is_running


def test_the_digest_begins_anew_where_nothing_runs_and_goes_on_where_something_does(desk, monkeypatch):  # law 14
    begun = []
    monkeypatch.setattr(desk.driver, "begin", lambda: begun.append(desk.driver.now))
    begin(desk, plan("1.0"))
    begin(desk, plan("1.0", home="flow1", mass="yard:m1"))
    assert begun == [0]
    desk.to_the_end()
    begin(desk, plan("1.0"))
    assert len(begun) == 2


def test_the_clock_of_a_held_run_stands_until_it_is_let_on_and_is_nobodys_after_its_end(desk):  # R-E07
    begin(desk, plan("1.0"), is_held=True)
    desk.to_the_end()
    assert desk.driver.now == 0
    while desk.result is None:
        desk.ask(steer.Onward())
        desk.to_the_end()
    assert desk.result.completed
    assert isinstance(desk.ask(steer.Onward()), request.Refused)
    begin(desk, plan("2.0"))
    assert desk.to_the_end().completed


def test_who_holds_the_clock_is_told_by_the_first_flow_that_it_stands(desk):  # R-E07
    flows = [[action("mass", "servo", arguments="1.0")], [action("bell")]]
    shop = rail_tasks()
    shop.task("bell", BELL)
    begin(desk, shop.plan(*flows), is_held=True)
    desk.ask(steer.Onward(0.001))
    desk.to_the_end()
    assert {
        (home, session) for home, session, message in desk.server.deliveries if isinstance(message, event.Stood)
    } == {("flow0", "me")}


def test_in_wall_time_no_clock_is_held(desk, monkeypatch):  # R-E07
    desk.ask(request.Prepare(plan("1.0"), ()))
    with monkeypatch.context() as wall:
        wall.setattr(type(desk.driver), "is_virtual", property(lambda _driver: False))
        desk.send(request.Begin(is_held=True))
    assert desk.to_the_end().completed


def test_a_held_run_whose_session_is_gone_comes_to_its_end(desk):  # R-E07, R-E10
    begin(desk, plan("1.0"), is_held=True, on_loss="run")
    desk.ask(request.Prepare(plan("1.0", home="flow1"), ()))
    desk.server.gone.append("me")
    desk.program.serve()
    assert desk.to_the_end().completed
    assert desk.program.applications.prepared("me") is None


def test_what_is_held_and_repeated_stays_so_while_others_leave_and_their_runs_end(desk):  # R-E07, law 29
    begin(desk, plan("1.0"), is_held=True, repeat=(repeated(100, steer.Pause()),), repeat_until_ns=-1)
    begin(desk, plan("1.0", home="flow1", mass="yard:m1"), "other")
    subsystems = desk.program.subsystems
    desk.ask(request.Abort(Reason.plain("enough")), "other")
    for _ in range(100):
        desk.program.advance(0)
    assert [result.run for result in desk.of(event.Result)] == ["flow1"]
    desk.server.gone.append("stranger")
    desk.server.gone.append("other")
    desk.program.serve()
    assert subsystems.repeat.session == "me"
    assert desk.ask(steer.Onward()) == request.Done()


def test_what_is_repeated_is_asked_anew_from_the_begin_of_the_run_in_its_session(desk):  # law 29
    begin(desk, plan("1.0"))
    desk.to_the_end()
    began = desk.driver.now
    asked = (repeated(100, steer.Pause()), repeated(9_000, steer.Resume()))
    begin(desk, plan("1.5", "2.0"), repeat=asked, repeat_until_ns=-1)
    while desk.driver.now < began + 150 * MS:
        desk.program.advance(0)
    refused = desk.ask(steer.Pause())
    assert (type(refused), refused.reason.key) == (request.Refused, "host.is_repeated")
    assert desk.to_the_end().completed
    assert desk.driver.now > began + 9_000 * MS
    assert "paused" in [moved.state for moved in desk.of(event.Moved)]
    assert desk.program.subsystems.repeat.session == ""


def test_a_run_that_is_steered_beside_a_repeated_one_leaves_that_alone(desk):  # law 29, R-C18
    asked = (repeated(100, steer.Pause("flow0")), repeated(9_000, steer.Resume("flow0")))
    begin(desk, plan("1.5", "2.0"), repeat=asked)
    begin(desk, plan("1.0", home="flow1", mass="yard:m1"), "other")
    assert desk.ask(steer.Pause("flow1"), "other") == request.Done()
    assert desk.ask(steer.Resume("flow1"), "other") == request.Done()
    while len(desk.of(event.Result)) < 2:
        desk.program.advance(0)
    assert {result.run: result.completed for result in desk.of(event.Result)} == {"flow0": True, "flow1": True}
    assert [moved.subsystem for moved in desk.of(event.Moved) if moved.state == "paused"] == ["flow0"]
    assert desk.driver.now > 9_000 * MS


def test_a_second_run_is_not_repeated_beside_a_first_one(desk):  # law 29
    begin(desk, plan("1.0"), repeat_until_ns=-1)
    planned = plan("1.0", home="flow1", mass="yard:m1")
    assert desk.ask(request.Prepare(planned, ()), "other") == request.Prepared(())
    refused = desk.ask(request.Begin(repeat_until_ns=-1), "other")
    assert (type(refused), refused.reason.key) == (request.Refused, "host.repeats_another")
    assert desk.ask(request.Begin(), "other") == request.Done()
    desk.to_the_end()
    assert desk.ask(request.Abort(Reason.plain("enough")), "other") == request.Done()


def test_a_second_run_is_repeated_when_the_first_one_has_been_as_far_as_it_was_asked(desk):  # law 29
    begin(desk, plan("1.0"), repeat_until_ns=200 * MS)
    planned = plan("1.0", home="flow1", mass="yard:m1")
    assert desk.ask(request.Prepare(planned, ()), "other") == request.Prepared(())
    refused = desk.ask(request.Begin(repeat_until_ns=-1), "other")
    assert refused == request.Refused(Reason.of("host.repeats_another"))
    while desk.driver.now < 200 * MS:
        desk.program.advance(0)
    assert desk.result is None
    assert desk.ask(request.Begin(repeat_until_ns=-1), "other") == request.Done()


def test_a_repetition_ends_with_its_session(desk):  # law 29
    begin(desk, plan("1.0"), repeat=(repeated(100, steer.Pause()),), repeat_until_ns=-1, on_loss="run")
    assert desk.program.subsystems.repeat.session == "me"
    desk.server.gone.append("me")
    desk.program.serve()
    assert desk.program.subsystems.repeat.session == ""


def test_a_run_is_its_sessions_and_nobody_elses(desk):  # R-X12
    begin(desk, plan("1.0"))
    assert isinstance(desk.ask(request.Abort(Reason.plain("not yours")), "other"), request.Refused)
    assert desk.program.is_running
    desk.ask(request.Abort(Reason.plain("enough")))
    assert not desk.to_the_end().completed


def test_who_fell_silent_may_steer_the_run_that_was_begun_since(desk):  # R-X12
    desk.lease(250 * MS)
    assert desk.ask(live.Take("s9")) == request.Done()
    desk.server.silent["me"] = 300 * MS
    desk.program.serve()
    desk.server.silent["me"] = 0
    begin(desk, plan("2.0"))
    assert desk.ask(steer.Pause()) == request.Done()


def test_tasks_live_on_the_units_that_their_plan_names(tmp_path):  # R-A06
    desk = DirectClient(("rt0", "rt1"))
    begin(desk, plan("1.0", rtpu="rt1"))
    units = {name: member.rtpu for name, member in desk.program.subsystems.members("flow0").items()}
    assert units == {"mass": "rt0", "servo": "rt1"}


def test_a_lost_unit_ends_the_run_that_has_tasks_there():  # R-E10
    desk = DirectClient(("rt0", "rt1"))
    begin(desk, plan("1.0", rtpu="rt1"))
    desk.program.advance(0)
    desk.program.subsystems.lost("rt1", Reason.plain("rt1 was killed"), desk.driver.now)
    result = desk.to_the_end()
    assert not result.completed
    assert "rt1 was killed" in str(result.cause)


def test_the_last_words_of_a_lost_unit_change_nothing():  # R-E10
    desk = DirectClient(("rt0", "rt1"))
    begin(desk, plan("1.0", rtpu="rt1"))
    desk.program.advance(0)
    desk.program.subsystems.lost("rt1", Reason.plain("rt1 was killed"), desk.driver.now)
    events = len(desk.of(event.TaskState))
    desk.program.subsystems.hear("rt1", news.Changed("flow0", "servo", "ON", desk.driver.now), desk.driver.now)
    assert len(desk.of(event.TaskState)) == events


def boxed(desk, folder):
    desk.program.recordings.keep_last_seconds(folder, InProcessHolder(), InProcessHolder)
    return desk


def trip(desk):
    while desk.driver.now < 300 * MS:
        desk.program.advance(0)
    for value in (1.0, 0.0):
        desk.ask(live.Touch("yard", "panic", value))
    return desk.to_the_end()


def test_a_run_that_goes_badly_has_a_black_box_with_its_plan_and_the_result_names_it(desk, tmp_path):  # R-X05
    planned = plan("1.0")
    begin(boxed(desk, tmp_path / "boxes"), planned)
    result = trip(desk)
    (path,) = black_boxes(tmp_path / "boxes")
    assert result.black_box == str(path)
    with Review(path) as review:
        assert review.run.prepare.plan == planned


def test_without_a_black_box_none_is_named(desk):  # R-X05
    begin(desk, plan("1.0"))
    assert trip(desk).black_box == ""


def test_a_run_whose_plan_nobody_can_describe_any_more_goes_on_without_a_black_box(desk, tmp_path):  # R-X05
    desk.ask(request.Prepare(plan("1.0"), ()))
    boxed(desk, tmp_path / "boxes").program.recordings.descriptions.lost("me")
    assert desk.ask(request.Begin()) == request.Done()
    assert trip(desk).black_box == ""
    assert not (tmp_path / "boxes").exists()


def test_the_result_waits_for_the_recording_and_for_the_black_box(desk, tmp_path, monkeypatch):  # R-X05, law 29
    begin(boxed(desk, tmp_path / "boxes"), plan("1.0"))
    waits = {"recording": True, "black box": True}
    may_end, end = desk.program.recordings.recorder.may_end, desk.program.recordings.black_box.end
    asked = []

    def box(run, result):
        asked.append("black box")
        return None if waits["black box"] else end(run, result)

    monkeypatch.setattr(
        desk.program.recordings.recorder, "may_end", lambda run, result: not waits["recording"] and may_end(run, result)
    )
    monkeypatch.setattr(desk.program.recordings.black_box, "end", box)
    desk.to_the_end()
    assert (desk.result, desk.program.is_running, asked) == (None, True, [])
    waits["recording"] = False
    desk.program.advance(0)
    assert (desk.result, desk.program.is_running, asked) == (None, True, ["black box"])
    waits["black box"] = False
    desk.program.advance(0)
    assert desk.result.completed
    assert not desk.program.is_running


def test_a_run_that_ended_before_anything_moved_was_a_run_all_the_same(desk, tmp_path):  # law 29
    shop = PlanBuilder()
    shop.task("bell", BELL)
    path = tmp_path / "second.mcap"
    planned = shop.plan([action("bell")])
    for record in ("", str(path)):
        desk.ask(request.Prepare(planned, ()))
        assert desk.ask(request.Begin(record=record)) == request.Done()
        if not record:
            desk.ask(request.Abort(Reason.plain("enough")))
            assert not desk.to_the_end().completed
            assert desk.driver.now == 0
    desk.to_the_end()
    assert not RunRecord.read(Reader(path)).is_fresh
