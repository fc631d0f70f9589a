"""Live changes at given virtual times: the same story gives the same events and values, bit for bit (R-X08, law 14)."""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

import pytest

from kit.plans.plan_builder import action
from kit.runtime.live_edits import LiveEdits, live_edits_with_tasks
from kit.worlds.rail_world import MASS, SERVO, rail_tasks
from onika.wire import event, live, request

NOISE = """
from onika.module import Module, OutVar

class Noise(Module):
    SHAKE = OutVar("double", "N", "at random")

    def cycle(self):
        self.SHAKE = self.random.gauss(0.0, 1.0)
"""


def fingerprint() -> str:
    """Two subsystems with an arm each on three units, changed by hand while an application runs in a third."""
    hand = live_edits_with_tasks(("rt0", "rt1", "rt2"), source="rt2", user="rt0", reader="rt1", counter="rt1")
    hand.task("noise", NOISE, rtpu="rt2")
    hand.task("mass", MASS, frequency=500.0, local={"DEVICE": "yard:m0"}, rtpu="rt0")
    hand.task("servo", SERVO, rtpu="rt1")
    _left(hand)
    _right(hand)
    _beside(hand)
    words = [event.encode(news) for news in hand.asker.server.events if not isinstance(news, event.Result)]
    values = [repr(hand.values(subsystem=name)) for name in ("left", "right", "flow0")]
    return hashlib.sha256(b"".join(words) + "".join(values).encode() + hand.driver.digest.encode()).hexdigest()


def _left(hand: LiveEdits) -> None:
    everyone = ["source", "user", "reader", "counter", "noise"]
    assert hand.change(everyone, everyone, subsystem="left") == ""
    assert hand.change(["mass", "servo"], ["mass", live.Turn("servo", "3.0")], subsystem="left") == ""
    hand.let_pass(0.337)
    assert hand.reinit("source", "left", SIZE="3") == ""
    hand.let_pass(0.2101)
    hand.task("counter", "# new\n" + hand.shop.code("counter").source, frequency=50.0, rtpu="rt1")
    assert hand.swap("counter", "left") == ""


def _right(hand: LiveEdits) -> None:
    hand.task("mass", MASS, frequency=500.0, local={"DEVICE": "yard:m1"}, rtpu="rt2")
    assert hand.change(["mass", "servo", "noise"], ["mass", "servo", "noise"], subsystem="right") == ""
    hand.let_pass(0.05)
    hand.asker.ask(request.Reply("right", "servo", "-2.0"))
    hand.let_pass(0.111)
    assert hand.change(subsystem="right", rates=(("noise", 33.0),)) == ""
    assert "9 is too many" in hand.reinit("source", "left", SIZE="9")
    hand.let_pass(1.0)
    assert hand.change(["mass"], ["mass"], subsystem="right", kill=["mass"]) == ""
    hand.let_pass(3.0)


def _beside(hand: LiveEdits) -> None:
    assert hand.change(subsystem="right", kill=["mass"]) == ""
    hand.shop = rail_tasks(rtpu="rt1", mass="yard:m1")
    hand.asker.ask(request.Prepare(hand.shop.plan([action("mass", "servo", arguments="1.0")]), ()))
    hand.asker.ask(request.Begin())
    assert hand.change(subsystem="left", off=["noise"]) == ""
    assert hand.asker.to_the_end() is not None


@pytest.fixture(scope="module")
def here():
    return fingerprint()


def test_the_same_story_is_told_twice_alike(here):  # R-X08
    assert fingerprint() == here


@pytest.mark.parametrize("seed", ["0", "1", "4711"])
def test_the_order_of_sets_changes_nothing(here, seed):  # R-X08, law 14
    code = "from contract.test_live_determinism import fingerprint; print(fingerprint())"
    process = subprocess.run(
        [sys.executable, "-c", code],
        cwd=Path(__file__).parents[1],
        env={**os.environ, "PYTHONHASHSEED": seed},
        capture_output=True,
        text=True,
        check=True,
        timeout=600,
    )
    assert process.stdout.strip() == here


def test_a_millisecond_makes_another_story(here, monkeypatch):  # R-X08
    let_pass = LiveEdits.let_pass
    monkeypatch.setattr(LiveEdits, "let_pass", lambda self, seconds: let_pass(self, seconds + 1e-3))
    assert fingerprint() != here
