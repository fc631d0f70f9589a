"""Faults planted in real programs: the cause that `onika run` names is the planted one (requirement X06).

Virtual time where a fault can be planted there, wall time and real processes where it takes a process.
"""

import os
import signal
from dataclasses import dataclass

import pytest

from kit.labs.laboratory import Laboratory, job, joints
from kit.process.cli_process import CliProcess

pytestmark = pytest.mark.site

TICKER = """
import os
from onika.module import Module, OutVar, finish, illegal, shutdown

class Ticker(Module):
    trigger = {trigger}
    SEEN = OutVar("double", "s", "how long it lives")

    def on(self, inputs):
        self._count = 0

    def cycle(self):
        self._count += 1
        self.SEEN = 0.01 * self._count
        if self._count == 30:
            {act}
"""
POISON = """
import numpy as np
from onika.module import InConst, InVar, Module, OutVar

class Poison(Module):
    NDOF = InConst("int", "-", "number of joints")
    TAU_PD = InVar("double[NDOF]", "N m", "torque of the servo")
    TAU_REF = OutVar("double[NDOF]", "N m", "wanted torque")

    def init(self):
        self._count = 0

    def cycle(self):
        self._count += 1
        self.TAU_REF = self.TAU_PD * (1.0 if self._count < 100 else np.nan)
"""
SILENT = """
from onika.module import InVar, Module, OutVar

class Silent(Module):
    hardware = True
    GRIP = InVar("double", "-", "+1 opens, -1 closes, 0 changes nothing")
    GRIP_MEZ = OutVar("double[3]", "m,m/s,N", "opening, its speed, force on a finger")

    def init(self):
        self._count = 0

    def cycle(self):
        self._count += 1
        self.GRIP_MEZ = self.device.read()
        self.check_drive()
        if self._count < 50:
            self.device.write((1.0,))
"""
GAUGE = """
from onika.module import Input, Module, OutVar, finish

class Gauge(Module):
    trigger = True
    LEVEL = OutVar("double", "m", "what was said")
    level = Input("double", "m", "how high", low=0.0, high=1.0)

    def on(self, inputs):
        self.LEVEL = inputs.level

    def cycle(self):
        return finish()
"""


@dataclass
class Planted:
    """A program with a fault in it, how it is run, and what must be named."""

    path: str
    kind: str
    task: str
    suspect: str = ""
    text: str = ""
    words: tuple[str, ...] = ("--virtual",)
    kills: str = ""


def ticking(tmp_path, act, trigger=True):
    laboratory = Laboratory(tmp_path)
    laboratory.module("ticker", TICKER.format(act=act, trigger=trigger))
    laboratory.plain_task("ticker", writes="SEEN", hz=100)
    laboratory.configuration("tickC", "ticker 100")
    return laboratory


def raises(tmp_path):
    path = ticking(tmp_path, 'raise ValueError("bang")').application("tick", [job("tickC")])
    return Planted(str(path), "error", "ticker", text="ValueError: bang")


def may_not_go_on(tmp_path):
    path = ticking(tmp_path, 'return illegal("too hot")').application("tick", [job("tickC")])
    return Planted(str(path), "illegal", "ticker", text="too hot")


def demands_the_end(tmp_path):
    path = ticking(tmp_path, 'return shutdown("smoke")').application("tick", [job("tickC")])
    return Planted(str(path), "shutdown", "ticker", text="smoke")


def poisons_a_variable(tmp_path):
    laboratory = Laboratory(tmp_path)
    laboratory.module("poison", POISON)
    laboratory.task(
        "poison",
        "MODULE poison\nDESC bad\nINCONST NDOF\nOUTCONST none\n"
        "INVAR TAU_PD\nOUTVAR TAU_REF\nTASKTYPE periodic\nFREQ 500",
    )
    laboratory.configuration("poisonC", "puma 500", "diff 500", "pd 500", "poison 500", "jtraj 250")
    steps = [job("poisonC", "Joint job"), joints("up", 0.0, -1.57, 1.57, 0.0, 0.0, 0.0)]
    return Planted(str(laboratory.application("poison", steps)), "error", "puma", suspect="poison", text="TAU_REF")


def lets_a_drive_trip(tmp_path):
    laboratory = Laboratory(tmp_path)
    laboratory.module("silent", SILENT)
    laboratory.plain_task("silent", reads="GRIP", writes="GRIP_MEZ", hz=250, local="DEVICE boxes:gripper_left\n")
    laboratory.plain_task("opengrip", reads="GRIP_MEZ", writes="GRIP", hz=50, local="LEAST 9\nMOST 9\n")
    laboratory.configuration("silentC", "silent 250", "opengrip 50")
    path = laboratory.application("silent", [job("silentC")])
    return Planted(str(path), "tripped", "silent", text="tripped")


def is_answered_beyond_its_bounds(tmp_path):
    laboratory = Laboratory(tmp_path)
    laboratory.module("gauge", GAUGE)
    laboratory.plain_task("gauge", writes="LEVEL")
    laboratory.configuration("gaugeC", "gauge 50")
    path = laboratory.application("measure", [job("gaugeC")])
    words = ("--virtual", "--answer", "gauge.level=7")
    return Planted(str(path), "asking", "gauge", text="expected 0..1 m, found 7", words=words)


def ends_its_process(tmp_path):
    path = ticking(tmp_path, "os._exit(3)").application("tick", [job("tickC")])
    return Planted(str(path), "lost", "ticker", text="ended with code 3", words=("--no-fifo",))


def loses_a_processing_unit(tmp_path):
    path = ticking(tmp_path, "self.warn('it begins')").application("tick", [job("tickC")])
    return Planted(
        str(path), "lost", "", text="was killed by signal 9", words=("--no-fifo",), kills="onika.host.units.rtpu"
    )


@pytest.mark.parametrize(
    "plant",
    [
        raises,
        may_not_go_on,
        demands_the_end,
        poisons_a_variable,
        lets_a_drive_trip,
        is_answered_beyond_its_bounds,
        ends_its_process,
        loses_a_processing_unit,
    ],
)
def test_the_cause_that_is_named_is_the_planted_one(tmp_path, plant):  # R-X06
    planted = plant(tmp_path)
    with CliProcess("run", planted.path, "--json", *planted.words) as console:
        if planted.kills:
            console.until(event="warned", text="it begins")
            os.kill(console.process(planted.kills), signal.SIGKILL)
        result = console.result()
    assert result["state"] == "aborted"
    (explanation,) = [event for event in console.events if event["event"] == "explained"]
    assert (explanation["kind"], explanation["suspect"]) == (planted.kind, planted.suspect)
    assert explanation["task"] == planted.task or planted.kills  # the blow may meet the task in its call
    assert planted.text in explanation["text"]
    if planted.task:
        assert explanation["action"]
        assert explanation["place"].startswith(planted.path)
        assert explanation["subsystem"] == "flow0"
    assert explanation["choices"] == []  # nobody is there to decide


def test_the_last_seconds_are_those_before_the_fault_and_end_with_it(tmp_path):  # R-X06
    planted = raises(tmp_path)
    with CliProcess("run", planted.path, "--json", "--virtual") as console:
        console.result()
    (explanation,) = [event for event in console.events if event["event"] == "explained"]
    (course,) = explanation["courses"]
    assert (course["variable"], course["unit"]) == ("SEEN", "s")
    assert course["at_s"][-1] == explanation["at_s"]
    assert course["values"] == sorted(course["values"])
    assert course["values"][-1] == pytest.approx(0.29)  # its last cycle that was whole
    assert len(course["values"]) >= 6


def test_a_run_that_is_explained_repeats_bit_for_bit(tmp_path):  # R-X06, R-X08
    path = poisons_a_variable(tmp_path).path
    messages = []
    for seed in ("1", "2"):
        with CliProcess("run", path, "--json", "--virtual", environment={"PYTHONHASHSEED": seed}) as console:
            digest = console.result()["hash"]
        messages.append((digest, [event for event in console.events if event["event"] == "explained"]))
    assert messages[0] == messages[1]
    assert messages[0][0]


def test_a_stop_is_told_to_people_in_a_block(tmp_path):  # R-X06, R-E11
    with CliProcess("run", poisons_a_variable(tmp_path).path, "--virtual", environment={"COLUMNS": "100"}) as console:
        text = console.text()
    assert "END flow0/puma: " in text
    assert " suspect     poison" in text
    assert " chain       puma > action 1, poisonC up > flow0" in text
    assert any("TAU_REF[" in line and "×" in line for line in text.splitlines())


def steered(tmp_path, path, *script):
    """The explanations of a run that is steered by these lines, and its result."""
    lines = tmp_path / "steering"
    lines.write_text("\n".join(script) + "\n")
    with CliProcess("run", str(path), "--json", "--virtual", "--script", str(lines)) as console:
        result = console.result()
    return [event for event in console.events if event["event"] == "explained"], result


def test_a_pressed_button_is_named_and_what_is_offered_brings_the_run_to_its_end(tmp_path):  # R-X06, R-K06, R-E08
    steps = [job("jmoveC", "Joint job"), joints("aside", 0.3, -1.5, 1.5, 0.0, 0.0, 0.0, duration=2.0)]
    path = Laboratory(tmp_path).application("aside", steps)
    script = (
        "wait 1", "touch boxes panic_left 1", "wait stopped", "clear", "wait stopped",
        "touch boxes panic_left 0", "clear",
    )  # fmt: skip
    (pressed, again), result = steered(tmp_path, path, *script)
    assert (pressed["kind"], pressed["task"]) == ("pressed", "puma")
    assert 1.0 <= pressed["at_s"] < 1.01
    assert (again["kind"], again["task"]) == ("pressed", "puma")
    commands = dict(pressed["choices"])
    assert list(commands) == ["clear", "next", "abort"]
    assert commands["clear"]["text"].startswith("once the panic button is let go: clears puma and repeats jmoveC aside")
    assert (result["state"], result["actions_done"]) == ("completed", 1)


def test_who_waits_for_a_flow_that_stands_is_named_with_the_tag(tmp_path):  # R-X06, R-E04
    laboratory = ticking(tmp_path, 'raise ValueError("bang")')
    laboratory.module("quick", TICKER.format(act="return finish()", trigger=True).replace("30", "5"))
    laboratory.plain_task("quick", writes="SEEN", hz=100)
    laboratory.configuration("quickC", "quick 100")
    tagged = "SYNCHTAG meet"
    flows = [[job(name), job(name, "Complete job", tagged)] for name in ("tickC", "quickC")]
    path = laboratory.application("both", *flows, parallel=True)
    (explanation, end), result = steered(tmp_path, path, "wait stopped flow0", "abort")
    assert (explanation["kind"], explanation["subsystem"], explanation["task"]) == ("error", "flow0", "ticker")
    assert explanation["waiting"] == [["flow1", "meet"]]
    assert [command for command, _ in explanation["choices"]] == [
        "clear flow0", "next flow0", "skip flow0 N", "pass flow1", "abort",
    ]  # fmt: skip
    assert (end["kind"], end["choices"]) == ("user", [])
    assert result["state"] == "aborted"
