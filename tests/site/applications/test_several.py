"""Several arms in one world, several processing units in one runtime; in wall and in virtual time (K02, A15)."""

import json

import pytest

from kit.labs.laboratory import Laboratory, job, joints
from onika.cli import main

pytestmark = pytest.mark.site

MODES = pytest.mark.parametrize("mode", [(), ("--virtual",)])


def events_of(capsys, path, *words):
    code = main(["run", str(path), "--json", *words])
    events = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert events[-1]["exit"] == code
    return events


@pytest.fixture
def two_arms(tmp_path):
    left = [job("jmoveC", "Joint job"), joints("left", 0.3, -1.4, 1.6, 0.0, 0.1, 0.0)]
    right = [job("jmove_rightC", "Joint job"), joints("right", -0.4, -1.4, 1.6, 0.0, 0.1, 0.0)]
    return Laboratory(tmp_path).application("both", left, right, parallel=True)


@MODES
def test_two_flows_move_two_arms_of_one_world_to_where_they_are_told(capsys, two_arms, mode):  # R-K02, R-E04, law 18
    ends = ("flow0/Q_MEZ[0] > 0.299", "flow0/Q_MEZ[0] < 0.301", "flow1/Q_MEZ[0] > -0.401", "flow1/Q_MEZ[0] < -0.399")
    words = [word for end in ends for word in ("--expect", end)]
    *events, result = events_of(capsys, two_arms, *words, *mode)
    assert (result["exit"], result["actions_done"]) == (0, 2), result
    drives = [(event["device"], event["state"]) for event in events if event["event"] == "drive"]
    for arm in ("boxes:arm_left", "boxes:arm_right"):
        assert [state for device, state in drives if device == arm] == ["DRIVEN", "HELD"]
    began = [event["at_s"] for event in events if event["event"] == "began"]
    assert len(began) == 2


def test_two_arms_in_virtual_time_are_the_same_every_time(capsys, two_arms):  # R-X08
    assert events_of(capsys, two_arms, "--virtual")[-1]["hash"] == events_of(capsys, two_arms, "--virtual")[-1]["hash"]


@pytest.fixture
def two_units(tmp_path):
    laboratory = Laboratory(tmp_path)
    arm = ("puma 500 rt0", "pd 500 rt0", "torque_sum 500 rt0", "diff 500 rt0", "led_monitor 50 rt1", "gravcomp 250 rt1")
    laboratory.configuration("spreadC", *arm, "jtraj 250 rt1")
    laboratory.configuration("otherC", *arm, "jtraj 125 rt1")
    spread = [job("spreadC", "Joint job"), joints("one", 0.2, -1.5, 1.6, 0.0, 0.1, 0.0)]
    other = [job("otherC", "Joint job"), joints("other", 0.4, -1.5, 1.6, 0.0, 0.1, 0.0)]
    return laboratory.application("spread", [*spread, *other])


@MODES
def test_a_configuration_may_be_spread_over_processing_units(capsys, two_units, mode):  # R-A15, law 10
    words = ("--expect", "Q_MEZ[0] > 0.399", "--expect", "Q_MEZ[0] < 0.401")
    *events, result = events_of(capsys, two_units, *words, *mode)
    assert (result["exit"], result["actions_done"]) == (0, 2), result
    units = {task["task"]: task["rtpu"] for task in result["tasks"]}
    assert {name for name, unit in units.items() if unit == "rt1"} == {"led_monitor", "gravcomp", "jtraj"}
    assert set(units.values()) == {"rt0", "rt1"}
    turned_on = [event["task"] for event in events if event["event"] == "taskstate" and event["state"] == "ON"]
    for early, late in (("puma", "diff"), ("jtraj", "pd"), ("pd", "torque_sum"), ("gravcomp", "torque_sum")):
        assert turned_on.index(early) < turned_on.index(late)  # producers before consumers (reading 14)
    drives = [event["state"] for event in events if event["event"] == "drive"]
    assert drives == ["DRIVEN", "HELD"]  # the arm does not fall into a hold between the two actions
    hertz = {task["task"]: task["hz"] for task in result["tasks"]}
    assert (hertz["jtraj"], hertz["puma"]) == (125, 500)  # each action sets its rates (reading 13)


def test_several_processing_units_in_virtual_time_are_the_same_every_time(capsys, two_units):  # R-X08, law 14
    hashes = {events_of(capsys, two_units, "--virtual")[-1]["hash"] for _ in range(2)}
    assert len(hashes) == 1
