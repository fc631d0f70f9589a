"""A flow whose actions a guest carries out, beside a flow of tasks of ours: real programs and runs."""

import json
import sys
from time import monotonic, sleep

import pytest

from kit.labs.laboratory import Laboratory, job
from kit.process.cli_process import CliProcess
from onika.cli import main

pytestmark = pytest.mark.site

PATIENCE_S = 60.0
ORACLE = """
import os, sys
from pathlib import Path
from onika.guest import GuestProgram, GuestError, action

HERE = Path(sys.argv[1])


class Oracle(GuestProgram):
    name = sys.argv[2]

    @action
    def choose(self, errand):
        return 1

    @action
    def nod(self, errand):
        pass

    @action
    def refuse(self, errand):
        raise GuestError("the moon is in the wrong house")

    @action
    def die(self, errand):
        os._exit(3)

    @action
    def ponder(self, errand):
        (HERE / "pondering").touch()
        errand.wait(3600)
        (HERE / "stopped").touch()


Oracle().serve()
"""
COUNT = """
from onika.module import Module, finish

class Count(Module):
    trigger = True

    def cycle(self):
        return finish()
"""
ASKS = """
from onika.module import GuestAction

class {name}(GuestAction):
    action = "{action}"
"""
ACTIONS = ("choose", "nod", "refuse", "die", "ponder")


class House:
    """A laboratory with a guest, a job for each of its actions, and a job of our own."""

    def __init__(self, path, *, name="oracle", patience="30"):
        self.lab = Laboratory(path)
        self.guest = path / "oracle.py"
        path.mkdir()
        self.guest.write_text(ORACLE)
        starts = f"{sys.executable} {self.guest} {path} {name}"
        self._task(
            "oracle", "guest", 10, f"GUEST oracle\nPARTNER unix:@{{runtime}}/oracle\nSTARTS {starts}\n", patience
        )
        for action in ACTIONS:
            name = f"oracle_{action}"
            self.lab.module(name, ASKS.format(name=name.title().replace("_", ""), action=action))
            self._task(name, name, 20, "GUEST oracle\nPARTNER unix:@{runtime}/oracle\n", "60")
            self.lab.configuration(f"{name}C", "oracle 10", f"{name} 20")
        self.lab.module("count", COUNT)
        self.lab.plain_task("count")
        self.lab.configuration("countC", "count 100")

    def _task(self, name, module, hz, local, patience):
        rows = f"MODULE {module}\nDESC a guest\nINCONST none\nOUTCONST none\nINVAR none\nOUTVAR none\n"
        self.lab.task(name, f"{rows}TASKTYPE synchronous\nFREQ {hz}\n\nLOCAL\n{local}PATIENCE {patience}\n")

    def application(self, *actions):
        """Our own flow waits for that of the guest at a tag before its second action, if there are several."""
        tag = "SYNCHTAG    met"
        ours = [job("countC"), job("countC", "Complete job", tag)]
        theirs = [
            job(f"oracle_{name}C", "Complete job", *([tag] if number else [])) for number, name in enumerate(actions)
        ]
        return str(self.lab.application("seance", ours, theirs, parallel=True))


@pytest.fixture
def house(tmp_path):
    return House(tmp_path / "house")


def events(capsys):
    return [json.loads(line) for line in capsys.readouterr().out.splitlines() if line.startswith("{")]


def appears(path):
    """Wait until somebody has written this file."""
    until = monotonic() + PATIENCE_S
    while not path.exists():
        assert monotonic() < until, f"{path.name} never came"
        sleep(0.02)
    return path


def test_the_shipped_expert_and_an_arm_build_the_tower_together(capsys):  # R-A20
    code = main(["run", "stack_by_expert", "--virtual", "--json", "--expect", "LAMP == 1"])
    told = events(capsys)
    assert code == 0, told[-1]
    words = json.dumps(told)
    assert "waves stands, then triangle < square < cross" in words
    assert "waves < triangle < square < cross stands" in words
    begun = [event["action"] for event in told if event["event"] == "began"]
    fetched = [action for action in begun if action.endswith("_bx")]
    assert fetched == ["cmoveC box2_bx", "cmoveC box3_bx", "cmoveC box4_bx"], "in the order that the expert has found"


def test_flows_meet_and_both_are_done(house, capsys):  # R-A20, R-E04
    assert main(["run", house.application("choose", "nod"), "--virtual", "--json"]) == 0
    assert '"met"' in json.dumps(events(capsys))


@pytest.mark.parametrize(
    ("action", "cause"),
    [
        ("refuse", "partner oracle: it says: the moon is in the wrong house"),
        ("die", "partner oracle: it ended the connection before it answered"),
    ],
)
def test_what_a_guest_refuses_and_its_loss_are_told(house, capsys, action, cause):  # R-A20
    assert main(["run", house.application("choose", action), "--virtual", "--json"]) == 1
    assert cause in json.dumps(events(capsys))


def test_who_listens_in_its_place_is_not_believed(tmp_path, capsys):  # R-A20
    house = House(tmp_path / "house", name="stranger")
    assert main(["run", house.application("ponder", "nod"), "--json"]) == 1
    assert "expected the guest oracle, found stranger" in json.dumps(events(capsys))


def test_who_waits_for_a_silent_guest_waits_and_stop_reaches_it(house):  # R-A20, R-E13
    here = house.guest.parent
    with CliProcess("run", house.application("ponder", "choose"), "--json") as run:
        run.until(event="moved", state="waiting")
        appears(here / "pondering")
        run.interrupt()
        appears(here / "stopped")
        assert run.result()["state"] == "aborted"
        assert run.left_over() == []
