"""The robots whose constants are known here, by their names."""

from onika.laws import adept_one, puma560
from onika.laws.robot import Robot
from onika.laws.sentence import LawSentence

_ROBOTS: dict[str, Robot] = {robot.ROBOT: robot for robot in (puma560, adept_one)}


def robot_of(name: str) -> Robot:
    """The constants of the robot of this name; raises ValueError where there is none."""
    robot = _ROBOTS.get(name)
    if robot is None:
        names = ", ".join(_ROBOTS)
        raise ValueError(
            LawSentence("laws.robot_unknown", "expected one of {names}, found {name}", names=names, name=name)
        )
    return robot
