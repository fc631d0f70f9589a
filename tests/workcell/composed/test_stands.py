"""Which robot stands where."""

import pytest

from kit.worlds.file_cells import CELL, files_of
from onika.ring.device import DeviceOrder, DriveState
from onika.workcell.cell.file_world import FileWorld


@pytest.fixture
def stands():
    return FileWorld(files_of())._stands


def unit(stands, name):
    return next(unit for unit in stands.units if unit.sheet.name == name)


def test_the_first_robot_stands_there_until_another_one_is_wanted(stands):  # R-X19
    assert stands.acting == {"left": "elbow", "right": "elbow"}
    assert not stands.admit(unit(stands, "elbow_left"))
    assert stands.admit(unit(stands, "stiff_gripper_left"))
    assert stands.acting["left"] == "stiff"
    names = {unit.sheet.name for unit in stands.present()}
    assert names == {"stiff_left", "stiff_gripper_left", "elbow_right", "gripper_right"}


def test_two_robots_do_not_stand_at_one_place_nor_two_modes_in_one_world(stands):
    objections = [reason.key for reason in stands.objections(["elbow_left", "stiff_left", "elbow_right_kin"])]
    assert objections == ["workcell.one_place", "workcell.modes_unlike", "workcell.modes_unlike"]
    unit(stands, "elbow_left").epoch = 1
    with pytest.raises(ValueError, match="a free place"):
        stands.admit(unit(stands, "stiff_left"))
    with pytest.raises(ValueError, match="arms of one mode"):
        stands.admit(unit(stands, "elbow_right_kin"))
    assert not stands.admit(unit(stands, "gripper_right"))


HAND = """VERSION 2.0
FILE hand.xml
GRIPPER gripper
MOVES squeeze
DRIVE signal
OPEN 0.03 0.06
CLOSED 0 0
EOF
"""
HAND_MODEL = """<mujoco><worldbody><body name="hand">
<geom type="box" size="0.02 0.02 0.01" mass="0.1"/>
<body name="jaw"><joint name="jaw" type="slide" axis="0 1 0" range="0 0.03" damping="5"/>
<geom type="box" size="0.01 0.002 0.02" pos="0 0.01 0.03" mass="0.05"/></body></body></worldbody>
<actuator><position name="squeeze" joint="jaw" kp="400" ctrlrange="0 0.03"/></actuator></mujoco>"""
POLE = """<mujoco><compiler angle="radian"/><worldbody><body name="foot">
<joint name="turn" axis="0 0 1" range="-3 3" armature="0.1"/>
<geom size="0.05" mass="1"/><site name="tip" pos="0 0 0.3"/></body></worldbody></mujoco>"""
EMPTY = {
    **CELL,
    "world/cell.world": CELL["world/cell.world"].replace("elbow stiff", "- elbow pole\nHAND hand tip", 1),
    "robot/elbow.robot": CELL["robot/elbow.robot"].partition("GRIPPER")[0] + "EOF\n",
    "robot/hand.robot": HAND,
    "robot/hand.xml": HAND_MODEL,
    "robot/pole.robot": "VERSION 2.0\nFILE pole.xml\nARM arm\nTOOL tip\nHOME 0.4\nEOF\n",
    "robot/pole.xml": POLE,
}


def test_a_place_is_empty_until_a_device_of_it_is_claimed():  # R-X19
    world = FileWorld(files_of(EMPTY))
    assert world.faults == ()
    before = len(world.poses())
    assert world._stands.acting["left"] == ""
    assert world.state("pole_left")[2] == 0.4
    world.claim("pole_left", 1)
    assert len(world.poses()) == before + 3
    assert world.state("pole_left")[2] == pytest.approx(0.4)


def test_a_hand_belongs_to_its_place_and_stays_when_the_arm_is_exchanged():  # R-X19
    world = FileWorld(files_of(EMPTY))
    world.claim("gripper_left", 1)
    assert world._stands.acting["left"] == "elbow"
    for _ in range(200):
        world.command("gripper_left", 1, DeviceOrder.DRIVE, [1.0])
        world.step(world.now_ns + world.step_ns)
    opening = world.state("gripper_left")[2]
    assert opening == pytest.approx(0.06, abs=1e-3)
    world.claim("pole_left", 2)
    world.step(world.now_ns + world.step_ns)
    assert world.state("gripper_left")[2] == pytest.approx(opening, abs=1e-3)
    assert world.state("pole_left")[2] == pytest.approx(0.4, abs=1e-3)
    assert [*world._stands.objections(["pole_left", "gripper_left"])] == []


def test_the_drive_of_a_place_is_one_whatever_arm_is_plugged_in():  # law 17, R-X19
    world = FileWorld(files_of(EMPTY))
    world.claim("elbow_left", 1)
    world.fence(1)
    world.claim("pole_left_kin", 2)
    assert world.state("pole_left_kin")[1] == DriveState.TRIPPED
    world.command("pole_left_kin", 2, DeviceOrder.CLEAR, ())
    assert world.state("pole_left_kin")[1] == DriveState.HELD


def test_a_hand_that_is_nowhere_or_one_too_many_is_told_with_its_line():  # R-B07, R-X19
    gone = FileWorld(files_of({name: text for name, text in EMPTY.items() if name != "robot/hand.robot"}))
    assert [(fault.reason.key, fault.place.line) for fault in gone.faults] == [("workcell.robot_missing", 13)]
    two = EMPTY["robot/pole.robot"].replace("FILE pole.xml\n", "FILE pole.xml\nHAND hand.xml\nON tip\n")
    handed = FileWorld(files_of({**EMPTY, "robot/pole.robot": two}))
    assert [(fault.reason.key, fault.place.line) for fault in handed.faults] == [("workcell.hand_twice", 13)]
    assert "pole_left" not in {sheet.name for sheet in handed.devices()}


def test_a_hand_that_no_arm_of_the_flow_bears_is_odd(stands):  # R-E16, R-X19
    (remark,) = stands.remarks(["elbow_left", "gripper_right"])
    assert str(remark) == "gripper_right is the hand at the right, and the arm that moves is elbow_left"
    assert [*stands.remarks(["elbow_left", "elbow_gripper_left"])] == []


@pytest.mark.parametrize(
    ("given", "key"), [("hand nowhere", "workcell.no_such_name"), ("elbow tip", "workcell.hand_is_arm")]
)
def test_a_hand_that_is_an_arm_or_has_no_place_at_the_arm_is_told_with_its_line(given, key):  # R-B07, R-X19
    text = EMPTY["world/cell.world"].replace("HAND hand tip", f"HAND {given}")
    faults = FileWorld(files_of({**EMPTY, "world/cell.world": text})).faults
    assert {(fault.reason.key, fault.place.line) for fault in faults if fault.place.line == 13} == {(key, 13)}
