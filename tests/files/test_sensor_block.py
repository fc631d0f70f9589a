"""Blocks of sensors, in files of robots and of worlds."""

import pytest

from onika.files import robot as robot_file, world as world_file
from onika.model.robot import SensorBlock

WRIST = """VERSION     2.0
FILE        arm.xml

SENSOR      wrist
READS       force torque

EOF
"""

HALL = """VERSION     2.0

SENSOR      ball
POSE        ball.ball

EOF
"""


def test_a_sensor_reads_sensors_of_a_model_or_the_pose_of_a_body():  # R-X19
    robot, faults = robot_file.read(WRIST, "arm", "f")
    assert (robot.devices, faults) == ((SensorBlock("wrist", ("force", "torque")),), ())
    assert robot_file.write(robot, WRIST) == WRIST
    world, faults = world_file.read(HALL, "hall", "f")
    assert (world.sensors, faults) == ((SensorBlock("ball", body="ball.ball"),), ())
    assert world_file.write(world, HALL) == HALL


@pytest.mark.parametrize(
    ("old", "new", "line", "key"),
    [
        ("READS       force torque\n", "", 4, "files.reads_or_pose"),
        ("READS       force torque", "READS force\nPOSE hand", 4, "files.reads_or_pose"),
        ("force torque", "force force", 5, "files.meaning_after"),
        ("SENSOR      wrist", "SENSOR a wrist", 4, "files.meaning_after"),
    ],
)
def test_what_is_wrong_with_a_sensor_is_told_with_its_line(old, new, line, key):  # R-B07, R-X19
    robot, faults = robot_file.read(WRIST.replace(old, new, 1), "arm", "f")
    assert robot is None
    assert (line, key) in [(fault.place.line, fault.reason.key) for fault in faults]
