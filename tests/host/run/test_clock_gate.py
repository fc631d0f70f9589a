import pytest

from kit.plans.plan_builder import action
from kit.runtime.direct_client import DirectClient
from kit.worlds.rail_world import rail_tasks
from onika.host.run.clock_gate import ClockGate
from onika.wire import event, request, steer

SECOND = 1_000_000_000
BEGAN = event.Began(0, 0, 1, "lift", 0.0)


@pytest.fixture
def messages():
    return []


@pytest.fixture
def hold(messages):
    return ClockGate(lambda message, subsystem, session: messages.append((message, subsystem, session)))


def test_where_no_run_is_held_the_clock_goes_on(hold, messages):  # R-E07
    hold.say(5)
    assert (hold.stands(0), hold.wake_at(), messages) == (False, None, [])
    assert isinstance(hold.onward("", steer.Onward()), request.Refused)


def test_a_held_run_stands_until_it_is_let_go_on(hold, messages):  # R-E07
    hold.begin("me", "flow0", 0)
    hold.say(0)
    assert hold.stands(0)
    assert messages == []
    assert hold.onward("me", steer.Onward()) == request.Done()
    assert not hold.stands(10**12)


def test_only_the_session_that_began_it_lets_it_go_on(hold):  # law 27
    hold.begin("me", "flow0", 0)
    assert isinstance(hold.onward("you", steer.Onward()), request.Refused)
    assert hold.stands(0)


def test_it_stands_at_the_time_that_was_asked_for_counted_from_its_start(hold, messages):  # R-E07
    hold.begin("me", "flow0", 2 * SECOND)
    hold.onward("me", steer.Onward(0.5))
    assert hold.wake_at() == 2_500_000_000
    assert not hold.stands(2_499_999_999)
    assert hold.stands(2_500_000_000)
    hold.say(2_500_000_000)
    assert messages == [(event.Stood(0.5), "flow0", "me")]
    assert hold.wake_at() is None


def test_it_stands_after_everything_that_can_be_waited_for_and_says_so_once(hold, messages):  # R-E07
    tell = hold.begin("me", "flow0", 0)
    hold.onward("me", steer.Onward())
    tell(event.TaskState("flow0", "pd", "ON", 0.0), "flow0", "me")
    assert not hold.stands(1)
    tell(BEGAN, "flow0", "me")
    assert hold.stands(1)
    hold.say(SECOND)
    hold.say(SECOND)
    assert [message for message, _, _ in messages[1:]] == [BEGAN, event.Stood(1.0)]


def test_what_happened_while_it_stood_is_not_passed_over(hold, messages):  # R-E07
    tell = hold.begin("me", "flow0", 0)
    tell(BEGAN, "flow0", "me")
    hold.onward("me", steer.Onward())
    assert hold.stands(0)
    hold.say(0)
    assert messages[-1][0] == event.Stood(0.0)


def test_a_session_that_is_lost_holds_nothing(hold):  # R-E10
    hold.begin("me", "flow0", 0)
    hold.release("you")
    assert hold.stands(0)
    hold.release("me")
    assert not hold.stands(0)


def plan():
    return rail_tasks().plan([action("mass", "servo", arguments=goal) for goal in ("1.0", "2.0")])


def begun(asker, **settings):
    asker.ask(request.Prepare(plan(), ()))
    assert asker.ask(request.Begin(**settings)) == request.Done()


def test_a_held_run_stops_at_each_event_and_is_the_same_run(messages):  # R-E07, law 14
    plain, held = DirectClient(), DirectClient()
    begun(plain)
    begun(held, is_held=True)
    held.to_the_end()
    assert held.driver.now == 0
    stops = []
    while held.program.is_running:
        assert held.ask(steer.Onward()) == request.Done()
        held.to_the_end()
        if held.result is None:
            stops.append(held.of(event.Stood)[-1].at_s)
    assert held.result.hash == plain.to_the_end().hash
    assert stops == sorted(stops)
    assert len(set(stops)) >= 3


def test_virtual_time_does_not_run_past_the_moment_that_was_named():  # R-E07
    asker = DirectClient()
    begun(asker, is_held=True)
    while not asker.of(event.Stood) or asker.of(event.Stood)[-1].at_s < 0.123:
        asker.ask(steer.Onward(0.123))
        asker.to_the_end()
    assert asker.driver.now == 123_000_000
