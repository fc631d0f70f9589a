"""What devices of robots are called in a world: an arm by its robot and its place, others by their word and place."""

from collections.abc import Sequence

from onika.model.camera import CameraBlock
from onika.model.robot import RobotArm, RobotDevice, RobotText
from onika.model.world import UNNAMED


def device_name(device: RobotDevice | CameraBlock, robot: RobotText, others: Sequence[RobotText], place: str) -> str:
    """The name of a robot's device at a place where these other robots may stand too; `-` adds nothing.

    The only arm of a robot has the robot's name. Where another robot has a device of the same word, or the robot
    another arm, the robot's name stands before the word.
    """
    arms = [other for other in robot.devices if isinstance(other, RobotArm)]
    if isinstance(device, RobotArm) and len(arms) == 1:
        word = robot.name
    elif isinstance(device, RobotArm) or any(device.name in _words(other) for other in others if other != robot):
        word = f"{robot.name}_{device.name}"
    else:
        word = device.name
    return word if place == UNNAMED else f"{word}_{place}"


def _words(robot: RobotText) -> list[str]:
    return [device.name for device in (*robot.devices, *robot.cameras)]
