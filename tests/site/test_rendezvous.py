"""Flows of one application on two runtimes meet at tags: real processes, real datagrams, lines that are cut."""

import pytest
from msgspec.structs import replace

from kit.plans.plan_builder import PlanBuilder, action
from kit.process.meeting_runtimes import Meeting
from onika.wire import event, live, request, steer
from onika.wire.plan import Do, Halt, Meet
from onika.words.reason import Reason

pytestmark = pytest.mark.site

CLOCK = """
from onika.module import Input, Module, finish

class Clock(Module):
    trigger = True
    count = Input("int", "-", "how many cycles", low=1, high=1000)

    def on(self, inputs):
        self._left = inputs.count

    def cycle(self):
        self._left -= 1
        return finish() if self._left <= 0 else None
"""
PATIENCE_S = 30.0


def plan(site, actions):
    """One flow of so many actions of a twentieth of a second; each begins at the tag."""
    shop = PlanBuilder()
    shop.task("clock", CLOCK, frequency=100.0)
    whole = shop.plan([action("clock", arguments="5")] * actions)
    program = [instruction for number in range(actions) for instruction in (Meet("x"), Do(number))]
    flow = replace(whole.flows[0], subsystem=f"flow{site}", program=(*program, Halt()))
    return replace(whole, flows=(flow,))


@pytest.fixture(scope="module")
def meeting(tmp_path_factory):
    """Two runtimes, in which nothing is left of the test before."""
    running = Meeting(tmp_path_factory.mktemp("meeting"))
    yield running
    assert "Traceback" not in running.close()


def begun(meeting):
    """When each began its actions, by runtime."""
    return {site: [message.index for number, message in meeting.of(event.Began) if number == site] for site in range(2)}


def completed(meeting):
    return [message.completed for _, message in meeting.of(event.Result)]


def recover_all(meeting):
    """Users clear what was held, as long as anything is."""
    for _ in range(60):
        meeting.listen(0.5)
        if len(completed(meeting)) == 2:
            return
        for number, runtime in enumerate(meeting.runtimes):
            runtime.ask(steer.Recover(f"flow{number}"))


def test_two_runtimes_meet_at_every_tag(meeting):  # R-E04, R-F02
    linked = meeting.link(plan(0, 3), plan(1, 3))
    assert not any(answer.refusal for answer in linked)
    meeting.begin()
    recover_all(meeting)
    assert completed(meeting) == [True, True]
    assert {site: sorted(set(indexes)) for site, indexes in begun(meeting).items()} == {0: [0, 1, 2], 1: [0, 1, 2]}


def test_while_the_line_is_cut_flows_wait_and_then_they_meet(meeting):  # R-F02
    meeting.link(plan(0, 1), plan(1, 1))
    for line in meeting.lines:
        line.is_cut = True
    meeting.begin()
    meeting.listen(1.0)
    assert begun(meeting) == {0: [], 1: []}
    for line in meeting.lines:
        line.is_cut = False
    recover_all(meeting)
    assert completed(meeting) == [True, True]


def test_who_is_let_pass_goes_on_and_has_been_there(meeting):  # R-E13
    meeting.link(plan(0, 1), plan(1, 1))
    for line in meeting.lines:
        line.is_cut = True
    meeting.begin()
    meeting.listen(0.3)
    assert meeting.runtimes[0].ask(steer.Pass("flow0")) == request.Done()
    meeting.listen(0.5)
    assert begun(meeting) == {0: [0], 1: []}
    for line in meeting.lines:
        line.is_cut = False
    meeting.listen(PATIENCE_S)
    assert completed(meeting) == [True, True]


def test_a_stop_of_one_runtime_stops_the_other(meeting):  # law 27
    meeting.link(plan(0, 1), plan(1, 1))
    meeting.lines[0].is_cut = True
    meeting.begin()
    meeting.listen(0.3)
    meeting.runtimes[0].ask(request.Stop(Reason.plain("enough")))
    meeting.listen(PATIENCE_S)
    assert completed(meeting) == [False, False]
    for runtime in meeting.runtimes:
        runtime.ask(live.Reset())
