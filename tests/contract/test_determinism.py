"""Virtual time is bit for bit the same on every run, in every process, whatever Python's hashes are (law 14)."""

import json
import os
import subprocess
import sys

import pytest

from kit.runtime.executive_rig import ExecutiveRig
from kit.worlds.mass_world import MassWorld

WALL = ("wall_s", "tasks", "switches_us", "runtime_pid")  # of the wall's clock, and of the process
MS = 1_000_000
SHAKY = """
from onika.module import Module, OutVar

class Shaky(Module):
    hardware = True
    X = OutVar("double", "m", "place")

    def cycle(self):
        self.X = self.device.read()[0]
        self.device.write((self.random.gauss(0.0, 1.0) + len({"a", "b"}),))
"""


def story_of(application, hash_seed):
    """Everything a run in a process of its own tells, but for what the wall's clock measured."""
    code = "import sys; from onika.cli import main; sys.exit(main())"
    words = [sys.executable, "-c", code, "run", application, "--virtual", "--json"]
    environment = os.environ | {"PYTHONHASHSEED": hash_seed}
    done = subprocess.run(words, env=environment, capture_output=True, text=True, check=False, timeout=600)
    assert done.returncode == 0, done.stdout + done.stderr
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    return [{key: value for key, value in line.items() if key not in WALL} for line in lines]


@pytest.fixture(scope="module")
def story():
    return story_of("assemble", "0")


def test_a_run_tells_the_same_story_under_other_hashes(story):  # law 14, R-X08
    assert story_of("assemble", "4242") == story


def test_the_story_has_a_hash_of_every_step_of_the_worlds_and_every_word(story):  # R-X08
    (result,) = [line for line in story if line["event"] == "result"]
    assert len(result["hash"]) == 64
    assert result["state"] == "completed"
    (other,) = [line for line in story_of("go_home", "0") if line["event"] == "result"]
    assert other["hash"] != result["hash"]


def shaken(seed):
    world = MassWorld()
    rig = ExecutiveRig(world, seed=seed)
    rig.spawn("one", SHAKY, aliases={"X": "ONE"}, device="m0").spawn("two", SHAKY, aliases={"X": "TWO"}, device="m1")
    rig.switch(on=["one", "two"]).run(500 * MS)
    assert rig["ONE"] != rig["TWO"]
    return world.fingerprint()


def test_chance_is_the_same_for_the_same_seed_and_another_for_another():  # law 14
    assert shaken(1) == shaken(1) != shaken(2)
