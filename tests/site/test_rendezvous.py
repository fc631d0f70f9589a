"""Flows of one application on two runtimes meet at tags: real processes, real datagrams, lines that are cut."""

import signal
import subprocess
import sys
from random import Random
from time import monotonic

import pytest
from msgspec.structs import replace

from kit.plans.plan_builder import PlanBuilder, action
from kit.process.meeting_runtimes import Meeting
from onika.desk.run.run_review import Review
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
BEGINS_APART_S = 0.04
"""By how much the begins of the two runs, one asked for after the other, may be apart; no step is as short."""


HAND = """
from onika.module import InVar, Module, OutVar

class Hand(Module):
    hardware = True
    GRIP = InVar("double", "-", "+1 opens, -1 closes")
    GRIP_MEZ = OutVar("double[3]", "m,m/s,N", "opening, its speed, force on a finger")

    def cycle(self):
        self.GRIP_MEZ = self.device.read()
        self.device.write((self.GRIP,))
"""
GRIP = """
from onika.module import Module, OutVar

class Grip(Module):
    GRIP = OutVar("double", "-", "+1 opens, -1 closes")

    def cycle(self):
        self.GRIP = 1.0
"""


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


def gripping(site):
    """One action that begins at the tag, in which a hand is driven for ten seconds."""
    shop = PlanBuilder()
    shop.task("clock", CLOCK, frequency=100.0)
    shop.task("hand", HAND, frequency=250.0, local={"DEVICE": "boxes:gripper_left"})
    shop.task("grip", GRIP, frequency=250.0)
    whole = shop.plan([action("hand", "grip", "clock", arguments="1000")])
    flow = replace(whole.flows[0], subsystem=f"flow{site}", program=(Meet("x"), Do(0), Halt()))
    return replace(whole, flows=(flow,))


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


def cut_at_random(meeting, random, count):
    """Cut the line at random moments, one or both directions, and clear whatever is held; how often that was done."""
    cuts = 0
    while cuts < count and len(completed(meeting)) < 2:
        meeting.listen(random.uniform(0.02, 0.4))
        lines = random.choice(([0], [1], [0, 1]))
        for line in lines:
            meeting.lines[line].is_cut = True
        meeting.listen(random.choice((0.03, 0.1, 0.3)))
        for line in lines:
            meeting.lines[line].is_cut = False
        cuts += 1
        for number, runtime in enumerate(meeting.runtimes):
            runtime.ask(steer.Recover(f"flow{number}"))
    return cuts


def alone_for(meeting):
    """How long each flow that was held had been begun, in s."""
    began, alone = {}, []
    for number, message in meeting.events:
        if isinstance(message, event.Began):
            began[number] = message.at_s
        if isinstance(message, event.Moved) and message.state == "stopped":
            alone.append(message.at_s - began[number])
    return alone


def nobody_is_ahead(meeting):
    """Whether no flow has begun a step before the other one has begun that before it; in seconds of each run."""
    first = {0: {}, 1: {}}
    for number, message in meeting.of(event.Began):
        first[number].setdefault(message.index, message.at_s)
    pairs = [(first[site], first[1 - site]) for site in range(2)]
    return all(
        step - 1 in other and at_s > other[step - 1] - BEGINS_APART_S
        for own, other in pairs
        for step, at_s in own.items()
        if step
    )


def cuts(meeting, seed, count):
    """Meet while the line is cut so often; how long those were alone who began alone."""
    random, done, alone = Random(seed), 0, []
    while done < count:
        meeting.link(plan(0, 40), plan(1, 40))
        meeting.begin()
        done += cut_at_random(meeting, random, min(25, count - done))
        for runtime in meeting.runtimes:
            runtime.ask(request.Abort(Reason.plain("enough")))
        meeting.listen(PATIENCE_S)
        assert nobody_is_ahead(meeting)
        alone += alone_for(meeting)
    return alone


def test_whoever_begins_alone_is_held_in_time_whenever_the_line_is_cut(meeting):  # R-F02, decision 56
    alone = cuts(meeting, 1, 8)
    assert all(seconds <= meeting.alone_s + 0.05 for seconds in alone)  # told by a program that others keep waiting


@pytest.mark.slow
def test_whoever_begins_alone_is_held_in_time_in_two_hundred_cuts(meeting):  # R-F02, decision 56
    alone = cuts(meeting, 2, 200)
    assert alone
    assert max(alone) <= meeting.alone_s + 0.01


def test_the_flows_of_an_application_are_given_to_two_runtimes_by_one_command(meeting, tmp_path):  # R-E12, R-F02
    token = tmp_path / "token"
    token.write_text(meeting.token)
    token.chmod(0o600)
    places = [f"--at=flow{number}={runtime.url}" for number, runtime in enumerate(meeting.runtimes)]
    file = tmp_path / "both.mcap"
    words = [sys.executable, "-c", "from onika.cli import main; main()", "run", "both_wave", *places]
    words += ["--token-file", str(token), "--record", str(file)]
    done = subprocess.run(words, capture_output=True, text=True, timeout=90, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "both_wave: completed" in done.stdout
    assert "whoever begins alone is held after" in done.stdout
    with Review(file) as review:  # R-X05
        assert review.is_whole and review.ending["completed"] == "yes"
        assert review.run.stations == {f"flow{number}": runtime.url for number, runtime in enumerate(meeting.runtimes)}
        assert all(flow.intervals and flow.intervals[-1].end_s is not None for flow in review.flows)
        written = {series.subsystem for series in review.series.values() if len(list(series.values())) > 1}
        assert written == {"flow0", "flow1"}  # values of both runtimes


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


def test_a_frozen_program_keeps_no_lone_arm_moving(tmp_path):  # law 34, R-F02
    meeting = Meeting(tmp_path, way=lambda: 0.06)
    try:
        meeting.link(gripping(0), gripping(1))
        meeting.begin()
        frozen, other = meeting.runtimes
        while not meeting.of(event.Began):
            meeting.events += [(0, message) for message in frozen.client.events(0.001)]
        frozen.process.send_signal(signal.SIGSTOP)  # before anything of the other can have come
        until = monotonic() + 4 * meeting.alone_s
        while monotonic() < until:
            other.client.events(0.05)
        frozen.process.send_signal(signal.SIGCONT)
        meeting.listen(1.0)
        drives = {message.state: message for number, message in meeting.of(event.Drive) if number == 0}
        driven_s = (drives["HELD"].at_ns - drives["DRIVEN"].at_ns) * 1e-9
        assert driven_s <= meeting.alone_s + 0.02  # of the world's time, in steps of its own
        assert "nobody said in time" in " ".join(str(message.text) for _, message in meeting.of(event.Failed))
    finally:
        meeting.close()
