import pytest

from kit.plans.plan_builder import action
from kit.runtime.direct_client import DirectClient
from kit.worlds.rail_world import rail_tasks
from onika.host.sessions.request_server import SessionRequest
from onika.link.caller import Role
from onika.wire import live, request
from onika.wire.runtime_standing import Standing


@pytest.fixture
def desk():
    return DirectClient()


def run(desk, goal):
    desk.ask(request.Prepare(rail_tasks().plan([action("mass", "servo", arguments=goal)]), ()))
    desk.ask(request.Begin())
    return desk.to_the_end()


def call(number, message):
    return SessionRequest(number, "me", Role.OWNER, message)


def test_a_renewed_runtime_does_the_same_run_as_a_new_one(desk):  # R-X23, R-X08
    first = run(desk, "1.0")
    assert run(desk, "1.0").hash != first.hash  # the world goes on from where it was
    desk.send(live.Renew())
    desk.go_on_renewed()
    again = run(desk, "1.0")
    assert (again.hash, again.runtime_s) == (first.hash, first.runtime_s)


def test_what_was_asked_after_it_is_carried_out_by_the_program_that_is_new(desk):  # R-X23
    run(desk, "1.0")
    desk.server.waiting += [call(100, live.Renew()), call(101, live.Survey())]
    desk.program.serve()
    assert 100 not in desk.server.replies
    assert 101 not in desk.server.replies
    desk.go_on_renewed()
    assert desk.server.replies[100] == request.Done()
    standing = desk.server.replies[101]
    assert isinstance(standing, Standing)
    assert (standing.worlds, standing.now_s) == ((), 0.0)


def test_who_left_hears_nothing_more_and_its_tables_are_closed(desk):  # R-X23, R-X24
    run(desk, "1.0")
    ears = len(desk.server.ears)
    desk.send(live.Renew())
    old = desk.program
    desk.go_on_renewed()
    assert len(desk.server.ears) == ears
    assert old.subsystems.tables == {}


def test_a_runtime_in_which_something_runs_is_not_renewed_and_goes_on(desk):  # R-X23
    desk.ask(request.Prepare(rail_tasks().plan([action("mass", "servo", arguments="1.0")]), ()))
    desk.ask(request.Begin())
    answer = desk.ask(live.Renew())
    assert isinstance(answer, request.Refused)
    assert desk.program.renewal is None
    assert desk.to_the_end().completed


@pytest.mark.parametrize("seconds", [-1.0, 2e6])
def test_no_time_passes_where_it_is_out_of_range(desk, seconds):  # R-X08
    assert isinstance(desk.ask(live.Advance(seconds)), request.Refused)
    assert desk.driver.now == 0
    assert desk.ask(live.Advance(0.0)) == request.Done()
