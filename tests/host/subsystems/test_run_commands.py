"""Steering of applications through the runtime program, in virtual time."""

import pytest

from kit.plans.plan_builder import action
from kit.runtime.live_edits import LiveEdits
from kit.worlds.rail_world import rail_tasks
from onika.wire import event, live, request, steer


class Bridge:
    """A run of one flow with these goals, begun by `me`; the clock goes on only as far as `until` lets it."""

    def __init__(self, *goals, **begin):
        self.hand = LiveEdits()
        self.hand.shop = rail_tasks()
        self.asker = self.hand.asker
        plan = self.hand.shop.plan([action("mass", "servo", arguments=goal) for goal in goals])
        self.asker.ask(request.Prepare(plan, ()))
        assert self.asker.ask(request.Begin(is_held=True, **begin)) == request.Done()

    def ask(self, message, session="me"):
        return self.asker.ask(message, session)

    def until(self, seconds):
        while self.asker.driver.now < round(seconds * 1e9):  # it stands at whatever happens before
            if self.position()[0] in ("paused", "stopped"):
                break  # and while it waits for its user
            self.ask(steer.Onward(seconds))
            self.asker.program.advance(10_000_000_000)
        return self

    def positions(self):
        return self.ask(steer.Who()).flows

    def position(self):
        (position,) = self.positions()
        return position.state, position.action

    def end(self):
        for _ in range(1000):
            if self.asker.of(event.Result):
                return self.asker.of(event.Result)[0]
            self.ask(steer.Onward())
            self.asker.program.advance(10_000_000_000)
        raise TimeoutError("the run does not end")


def refused(answer):
    assert isinstance(answer, request.Refused)
    return str(answer.reason)


def test_a_flow_pauses_after_its_action_and_goes_on():  # R-E07
    bridge = Bridge("1", "2").until(0.1)
    assert bridge.ask(steer.Pause()) == request.Done()
    assert bridge.positions()[0].is_pausing
    bridge.until(20.0)
    assert bridge.position() == ("paused", 0)
    assert bridge.ask(steer.Resume("flow0")) == request.Done()
    assert bridge.position() == ("running", 1)
    assert bridge.end().completed


def test_a_step_is_one_action():  # R-E07
    bridge = Bridge("1", "2", "3")
    assert bridge.ask(steer.Pause()) == request.Done()
    bridge.until(5.0)
    paused = bridge.position()
    assert paused[0] == "paused"
    bridge.ask(steer.Step())
    bridge.until(40.0)
    assert bridge.position() == ("paused", paused[1] + 1)


def test_a_flow_can_be_sent_to_any_action():  # R-E13
    bridge = Bridge("1", "2", "3").until(0.1)
    assert bridge.ask(steer.Skip("flow0", 2)) == request.Done()
    assert bridge.position() == ("running", 2)
    assert "expected an action from 1 to 3 of flow 0, found 8" in refused(bridge.ask(steer.Skip("flow0", 7)))
    assert bridge.ask(steer.Skip("flow0", 0)) == request.Done()
    result = bridge.end()
    assert (result.completed, result.done) == (True, 3)  # 1, 2 and 3 after it was sent back


def test_a_breakpoint_is_set_and_removed_while_it_runs():  # R-E07
    bridge = Bridge("1", "2", "3").until(0.1)
    bridge.ask(steer.Mark("flow0", 1))
    assert bridge.positions()[0].breakpoints == (1,)
    bridge.until(30.0)
    assert bridge.position() == ("paused", 1)
    bridge.ask(steer.Mark("flow0", 1, is_set=False))
    assert bridge.positions()[0].breakpoints == ()


def test_a_conditional_breakpoint_holds_only_where_its_condition_does():  # R-E07
    bridge = Bridge("1", "2", "3").until(0.1)
    assert "expected an address" in refused(bridge.ask(steer.Mark("flow0", 0, condition="later")))
    bridge.ask(steer.Mark("flow0", 0, condition="X[0] > 1.5"))
    bridge.ask(steer.Mark("flow0", 1, condition="X[0] > 1.5"))
    bridge.until(30.0)
    assert bridge.position() == ("paused", 1)


@pytest.mark.parametrize(
    ("wish", "reason"),
    [
        (steer.Resume(), "expected flow 0 to be paused, found it running"),
        (steer.Pass("flow0"), "expected flow 0 to be waiting for another flow, found it running"),
        (steer.Leave("flow0"), "expected flow 0 in a loop"),
        (steer.Recover(), "expected flow 0 to be stopped at an error, found it running"),
        (steer.Pause("elsewhere"), "no application runs in subsystem elsewhere"),
        (steer.Mark("flow0", 9), "expected an action from 1 to 2"),
    ],
)
def test_what_cannot_be_done_now_is_refused_with_the_reason(wish, reason):  # R-E07
    bridge = Bridge("1", "2").until(0.1)
    assert reason in refused(bridge.ask(wish))
    assert bridge.position() == ("running", 0)


def test_who_steers_is_who_began_it_until_that_session_is_gone():  # law 27, R-E10
    bridge = Bridge("1", "2", on_loss="finish").until(0.1)
    assert "was begun by me" in refused(bridge.ask(steer.Pause("flow0"), session="other"))
    assert [flow.state for flow in bridge.ask(steer.Who(), session="other").flows] == ["running"]
    bridge.asker.server.gone.append("me")
    bridge.asker.program.serve()
    for _ in range(100):  # nobody holds the clock any more
        bridge.asker.program.advance(10_000_000)
    assert bridge.position() == ("paused", 0)  # it has finished its action
    assert bridge.ask(steer.Resume("flow0"), session="other") == request.Done()


def test_where_nothing_runs_nothing_is_steered():
    hand = LiveEdits()
    assert refused(hand.asker.ask(steer.Pause())) == "no application runs"
    assert hand.asker.ask(steer.Who()) == steer.Positions(())


def test_of_several_flows_one_has_to_be_named_where_only_one_can_be_meant():  # R-E13
    hand = LiveEdits()
    shop = rail_tasks()
    shop.task("bell", "from onika.module import Module\nclass Bell(Module):\n    trigger = True\n")
    hand.asker.ask(request.Prepare(shop.plan([action("mass", "servo", arguments="1")], [action("bell")]), ()))
    hand.asker.ask(request.Begin(is_held=True))
    assert "expected one of the flows flow0, flow1, found none" in refused(hand.asker.ask(steer.Skip("", 0)))
    assert hand.asker.ask(steer.Pause()) == request.Done()
    assert [flow.is_pausing for flow in hand.asker.ask(steer.Who()).flows] == [True, True]


def test_who_holds_the_clock_lets_time_pass_while_every_flow_waits_for_its_user():  # R-E07, law 15
    bridge = Bridge("1", "2")
    bridge.ask(steer.Pause())
    bridge.until(20.0)
    assert bridge.position()[0] == "paused"
    now = bridge.asker.driver.now
    bridge.ask(steer.Onward(now * 1e-9 + 0.5))
    bridge.asker.program.advance(10_000_000_000)
    assert bridge.asker.driver.now == now + 500_000_000
    assert bridge.asker.of(event.Stood)[-1].at_s == pytest.approx(now * 1e-9 + 0.5)
    assert bridge.position()[0] == "paused"


def test_the_virtual_clock_stands_while_every_flow_waits_for_its_user():  # law 15
    bridge = Bridge("1", "2")
    bridge.asker.program.subsystems.hold.release()
    bridge.ask(steer.Pause())
    for _ in range(50):
        bridge.asker.program.advance(10_000_000)
    assert bridge.position()[0] == "paused"
    now = bridge.asker.driver.now
    bridge.asker.program.advance(10_000_000)
    assert bridge.asker.driver.now == now
    bridge.ask(live.Advance(1.5))
    assert bridge.asker.driver.now == now + 1_500_000_000
