"""What is wrong with an application is said before anything moves: everything at once, each with its place (E01)."""

import json

import pytest

from kit.labs.laboratory import HOLE, Laboratory, job, joints, target
from onika.cli import main

pytestmark = [pytest.mark.site, pytest.mark.usefixtures("warm_runtimes")]

TRIGGER = """
from onika.module import Module, finish

class Trigger(Module):
    trigger = True

    def cycle(self):
        return finish()
"""
SPEAKER = """
from onika.module import Module, OutVar

class Speaker(Module):
    HEIGHT = OutVar("double", "m", "how high")
"""
LISTENER = """
from onika.module import InVar, Module

class Listener(Module):
    HEIGHT = InVar("double[3]", "mm", "how high")
"""
ROGUE = """
from onika.module import Module

class Rogue(Module):
    hardware = True
"""
ARM = ("puma 500", "diff 500", "gravcomp 250", "pd 500", "torque_sum 500")


@pytest.fixture
def laboratory(tmp_path):
    return Laboratory(tmp_path)


def refused(capsys, path, *words):
    """The faults of a refused run, each as one line; nothing has begun."""
    assert main(["run", str(path), "--virtual", "--json", *words]) == 2
    events = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert [event["event"] for event in events] == ["result"]
    assert (events[-1]["state"], events[-1]["exit"]) == ("refused", 2)
    for fault in events[-1]["faults"]:
        assert all(fault[field] for field in ("file", "reason", "instead"))
    return [
        f"{fault['file'].rpartition('/')[2]}:{fault['line']} {fault['reason']['text']}"
        for fault in events[-1]["faults"]
    ]


def holds(faults, *parts):
    """Whether one of the faults has all these parts."""
    return any(all(part in fault for part in parts) for fault in faults)


def plant_everything(laboratory):
    """An application with a fault of every kind that can stand beside the others."""
    for name, source in (("halt", TRIGGER), ("speaker", SPEAKER), ("listener", LISTENER), ("rogue", ROGUE)):
        laboratory.module(name, source)
    laboratory.module("liar", SPEAKER)
    laboratory.module("broken", "from onika.module import Module\n\nclass Broken(Module\n")
    laboratory.plain_task("halt")
    laboratory.plain_task("speaker", writes="HEIGHT")
    laboratory.plain_task("listener", reads="HEIGHT")
    laboratory.plain_task("rogue", local="DEVICE boxes:arm_left\n", hz=20)
    laboratory.plain_task("liar", writes="DEPTH")
    laboratory.plain_task("broken")
    laboratory.plain_task("ghost")
    laboratory.configuration("talkC", "speaker 100", "listener 100", "halt 100")
    laboratory.configuration("rogueC", "rogue 20", "halt 100")
    laboratory.configuration("lonelyC", "nobody 100", "halt 100")
    laboratory.configuration("brokenC", "broken 100", "liar 100", "ghost 100", "halt 100")
    laboratory.configuration("restC", *ARM)
    first = [
        job("jmoveC", "Joint job"),
        joints("too_far", 9.0, -1.0, 2.0, 0.0, 0.5, 0.0),
        job("cmoveC", "Cartesian job"),
        target("in_the_sky", "Cartesian object", "0 0 -1 0 1 0 5 5 5", "2"),
        job("talkC"),
        job("restC"),
    ]
    second = [
        job("rogueC"),
        job("lonelyC"),
        job("brokenC"),
        job("nowhereC"),
        job("jmove_rightC", "Joint job"),
        HOLE,
        job("jmove_rightC", "Joint job"),
    ]
    return laboratory.application("everything", first, second, parallel=True)


def test_every_fault_is_listed_at_once_with_its_place(capsys, laboratory):  # R-E01, R-B07, R-X02
    path = plant_everything(laboratory)
    faults = refused(capsys, path)
    rows = path.read_text().splitlines()
    line = {name: rows.index(f"ROUTINE     {name}") + 1 for name in ("jmoveC", "cmoveC", "restC")}
    assert holds(faults, f"everything.appl:{line['jmoveC']} ", "too_far", "9")
    assert holds(faults, f"everything.appl:{line['cmoveC']} ", "in_the_sky", "reach")
    assert holds(faults, "listener.rmod", "HEIGHT", "double in m", "double[3] in mm")
    assert holds(faults, f"everything.appl:{line['restC']} ", "a trigger that ends job restC", "none")
    assert holds(faults, "rogue.rmod", "boxes:arm_left", "puma")
    assert holds(faults, "the task nobody", "lonelyC")
    assert holds(faults, "broken.py:3", "Python")
    assert holds(faults, "liar.rmod", "HEIGHT", "no such port")
    assert holds(faults, "liar.rmod", "only ports that module liar declares", "DEPTH")
    assert holds(faults, "ghost.py", "none")
    assert holds(faults, "the configuration nowhereC")
    assert holds(faults, "a hole, step 5 of flow 1")
    assert holds(faults, "Joint object", "step 6 of flow 1")
    assert holds(faults, "rogue.rmod", "40 Hz", "20 Hz")


def test_a_hardware_task_may_not_be_slowed_below_forty_hertz_by_its_configuration(capsys, laboratory):  # law 17
    laboratory.configuration("slowC", "puma 20", "diff 500", "gravcomp 250", "pd 500", "torque_sum 500", "jtraj 250")
    path = laboratory.application("slow", [job("slowC", "Joint job"), joints("there", 0.1, -1.2, 2.0, 0.0, 0.5, 0.0)])
    assert holds(refused(capsys, path), "slow.appl", "puma", "40 Hz", "20 Hz")


def test_no_task_may_be_quicker_than_its_clock_can_tell(capsys, laboratory):  # R-A04
    laboratory.configuration("oddC", "gripper 250", "opengrip 1e12")
    faults = refused(capsys, laboratory.application("odd", [job("oddC")]))
    assert holds(faults, "odd.appl", "0.001 Hz to 1e+06 Hz for opengrip in oddC", "1e+12 Hz")


def test_two_tasks_of_one_flow_may_not_claim_one_device(capsys, laboratory):  # law 9
    laboratory.module("rogue", ROGUE)
    laboratory.plain_task("rogue", local="DEVICE boxes:gripper_left\n")
    laboratory.configuration("twiceC", "gripper 250", "rogue 100", "opengrip 50")
    faults = refused(capsys, laboratory.application("twice", [job("twiceC")]))
    assert holds(faults, "boxes:gripper_left", "gripper", "rogue")


@pytest.mark.parametrize("number", ["NaN", "inf", "-Infinity", "1e999"])
def test_no_number_that_is_none_is_read_from_an_application(capsys, laboratory, number):  # R-B07
    path = laboratory.application(
        "none", [job("jmoveC", "Joint job"), target("there", "Joint object", f"0 {number} 1.5 0 0 0", "2")]
    )
    faults = refused(capsys, path)
    assert holds(faults, "none.appl:", "finite number", number)


def test_a_target_of_a_type_that_no_syntax_defines_is_not_run(capsys, laboratory):  # R-B04, R-D16
    path = laboratory.application("odd", [job("jmoveC", "Joint job"), target("there", "Wobbly object", "1")])
    assert holds(refused(capsys, path), "odd.appl:", "syntax defines", "Wobbly object")


def test_a_truncated_application_is_not_run(capsys, laboratory):  # R-B07
    path = laboratory.application("whole", [job("opengripC")])
    text = path.read_text()
    for end in (0, len(text) // 3, len(text) // 2, len(text) - 6):
        path.write_text(text[:end])
        assert holds(refused(capsys, path), "whole.appl:")


def test_a_binary_file_is_no_application(capsys, laboratory):  # R-B07
    path = laboratory.application("binary", [job("opengripC")])
    path.write_bytes(bytes(range(256)) * 8)
    assert holds(refused(capsys, path), "binary.appl:2", "UTF-8", "0x80")


def test_a_world_that_nobody_offers_is_named_with_those_that_are_there(capsys, laboratory):  # law 16
    laboratory.module("rogue", ROGUE)
    laboratory.module("halt", TRIGGER)
    laboratory.plain_task("halt")
    laboratory.plain_task("rogue", local="DEVICE atlantis:arm\n")
    laboratory.configuration("rogueC", "rogue 100", "halt 100")
    path = laboratory.application("rogue", [job("rogueC")])
    assert main(["run", str(path), "--virtual", "--json"]) == 2
    (fault,) = json.loads(capsys.readouterr().out.splitlines()[-1])["faults"]
    assert "boxes" in fault["reason"]["text"]
    assert "none installed" not in fault["reason"]["text"]
    assert "atlantis" in fault["reason"]["text"]
    assert "rogue" in fault["file"]


def test_no_application_of_this_name_names_those_there_are(capsys):  # R-E01
    assert main(["run", "nothing_like_it"]) == 2
    output = capsys.readouterr().out
    assert "assemble" in output
    assert "nothing_like_it: refused, nothing moved (1 fault)" in output


def test_module_code_that_ends_the_loader_is_named(capsys, laboratory):  # law 21
    laboratory.module("suicide", "import os\nos._exit(7)\n")
    laboratory.module("halt", TRIGGER)
    laboratory.plain_task("halt")
    laboratory.plain_task("suicide")
    laboratory.configuration("suicideC", "suicide 100", "halt 100")
    faults = refused(capsys, laboratory.application("suicide", [job("suicideC")]))
    assert holds(faults, "suicide.py", "the loader died of it")
    assert len(faults) == 1
