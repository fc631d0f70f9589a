"""Files of robots: what is wrong with a line is told with its number; see `contract/test_formats` for the rest."""

import pytest

from onika.files.robot import read, write
from onika.model.robot import RobotArm, RobotAxes, RobotGripper

PANDA = """# from its maker
VERSION     2.0
DESC        an arm with its hand
FILE        franka/panda.xml

ARM         arm
# between the fingers
TOOL        hand 0 0 0.1034
SPEED       2 2 2

GRIPPER     gripper
MOVES       actuator8
OPEN        255 0.08
CLOSED      0 0

AXES        lift
MOVES       up
DRIVE       torque

EOF
"""


def test_a_robot_is_its_model_and_its_devices():  # R-X19
    robot, faults = read(PANDA, "panda", "f")
    assert faults == ()
    assert (robot.name, robot.models) == ("panda", ("franka/panda.xml",))
    assert robot.devices == (
        RobotArm("arm", "hand", (0.0, 0.0, 0.1034), speed=(2.0, 2.0, 2.0)),
        RobotGripper("gripper", ("actuator8",), (255.0, 0.08), (0.0, 0.0)),
        RobotAxes("lift", ("up",), "torque"),
    )
    assert [device.lines["MOVES"] for device in robot.devices[1:]] == [12, 17]


def test_comments_stay_where_they_are():  # R-B01
    robot, _ = read(PANDA, "panda", "f")
    assert write(robot, PANDA) == PANDA


@pytest.mark.parametrize(
    ("old", "new", "line", "key"),
    [
        ("2.0", "1.3", 2, "files.version_of_ours"),
        ("FILE        franka/panda.xml", "FILE", 4, "files.meaning_after"),
        ("FILE        franka/panda.xml", "FILE a.xml\nHAND b.xml", 5, "files.hand_and_site"),
        ("FILE        franka/panda.xml", "FILE a.xml\nLINKS b.xml b.xml", 5, "files.hand_and_site"),
        ("FILE        franka/panda.xml", "FILE a.xml\nLINKS\nON end", 5, "files.meaning_after"),
        ("TOOL        hand 0 0 0.1034", "TOOL hand 0 0", 8, "files.meaning_after"),
        ("TOOL        hand 0 0 0.1034", "TOOL hand\nAPPROACH y", 9, "files.axes_alike"),
        ("SPEED       2 2 2", "SPEED 2 -2 2", 9, "files.meaning_after"),
        ("SPEED       2 2 2", "SPEED fast", 9, "files.meaning_after"),
        ("OPEN        255 0.08", "OPEN 255", 13, "files.meaning_after"),
        ("OPEN        255 0.08", "OPEN 255 -0.08", 14, "files.widths_reversed"),
        ("OPEN        255 0.08", "OPEN 0 0.08", 14, "files.signals_alike"),
        ("DRIVE       torque", "DRIVE power", 18, "files.choice_after"),
        ("MOVES       up", "MOVES actuator8", 17, "files.actuator_twice"),
        ("MOVES       up", "MOVES up up", 17, "files.meaning_after"),
        ("AXES        lift", "AXES arm", 16, "files.every_name_once"),
        ("MOVES       up", "MOVES up\nWHEELS a", 18, "files.keywords_expected"),
    ],
)
def test_what_is_wrong_is_told_with_its_line_and_the_robot_is_left_out(old, new, line, key):  # R-B07, R-X19
    robot, faults = read(PANDA.replace(old, new, 1), "panda", "f")
    assert robot is None
    assert (line, key) in [(fault.place.line, fault.reason.key) for fault in faults]


def test_links_are_attached_to_each_other_as_often_as_they_are_named():  # R-K04
    text = "VERSION     2.0\nFILE        foot.xml\nLINKS       turn.xml bend.xml turn.xml\nON          end\n\nEOF\n"
    robot, faults = read(text, "modular", "f")
    assert faults == ()
    assert (robot.links, robot.on) == (("turn.xml", "bend.xml", "turn.xml"), "end")
    assert robot.models == ("foot.xml", "turn.xml", "bend.xml")
    assert write(robot, text) == text


HELD = """VERSION     2.0
KIND        puma560
FILE        puma.xml

ARM         arm
TOOL        flange
DRIVE       torque
KP          4000 6000
KD          213 382

GRIPPER     gripper
MOVES       valve
DRIVE       signal
OPEN        1 0.1
CLOSED      -1 0.06

EOF
"""


def test_an_arm_may_hold_by_gains_of_its_own_and_a_gripper_take_one_signal():  # R-X19
    robot, faults = read(HELD, "arm", "f")
    assert faults == ()
    assert (robot.name, robot.kind) == ("arm", "puma560")
    assert robot.devices[0].gains == ((4000.0, 6000.0), (213.0, 382.0))
    assert robot.devices[1].drive == "signal"
    assert write(robot) == HELD


@pytest.mark.parametrize(
    ("old", "new", "line", "key"),
    [
        ("KD          213 382\n", "", 8, "files.gains_both"),
        ("DRIVE       torque", "DRIVE       position", 8, "files.gains_of_torques"),
        ("DRIVE       signal", "DRIVE       torque", 13, "files.choice_after"),
        ("KP          4000", "KP          0", 8, "files.meaning_after"),
    ],
)
def test_gains_stand_together_and_belong_to_torques(old, new, line, key):  # R-B07, R-X19
    robot, faults = read(HELD.replace(old, new), "arm", "f")
    assert robot is None
    assert (faults[0].place.line, faults[0].reason.key) == (line, key)
