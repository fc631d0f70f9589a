"""The devices of all robots that may stand at the places of a world."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from onika.workcell.composed import chain
from onika.workcell.composed.base_unit import BaseUnit, KinematicBaseUnit
from onika.workcell.composed.composition import Composition
from onika.workcell.composed.device_names import device_name
from onika.workcell.composed.finger_unit import FingerUnit
from onika.workcell.composed.held_joint_unit import HeldJointUnit
from onika.workcell.composed.joint_unit import JointUnit, KinematicJointUnit
from onika.workcell.composed.robot_model import HAND, ORIGIN, RobotModel, at_home
from onika.workcell.composed.robot_unit import ANY, RobotUnit
from onika.workcell.composed.sensor_unit import SensorUnit
from onika.workcell.composed.signal_unit import SignalUnit
from onika.workcell.composed.usable_parts import prefix_of

_WORLD = "world"  # the body in which the bodies of every document stand


def robot_units(composition: Composition, model_with: Callable[[str, str], Any]) -> Iterator[RobotUnit]:
    """The devices of each robot at each place; `model_with` gives the world's model with a robot at a place."""
    step_s = composition.world.step_s
    for place in composition.places:
        robots = [composition.robot(place, name) for name in composition.at(place)]
        there = [robot.robot for robot in robots]
        for robot in robots:
            called = {
                device.name: device_name(device, robot.robot, there, place.name) for device in robot.robot.devices
            }
            model = model_with(place.name, robot.robot.name)
            name, prefix = robot.robot.name, prefix_of(place.name)
            yield from _units_of(robot, called, _Stand(name, place.name, prefix, model, step_s))
        hand = composition.hand(place)
        if hand is not None and robots:
            called = {
                device.name: device_name(device, hand.robot, [hand.robot], place.name) for device in hand.robot.devices
            }
            prefix = prefix_of(place.name) + HAND
            model = model_with(place.name, there[0].name)
            yield from _units_of(hand, called, _Stand(ANY, place.name, prefix, model, step_s))


@dataclass(frozen=True, slots=True)
class _Stand:
    """How a robot stands at a place: what stands before the names of its model there, and the world's model with it."""

    robot: str
    place: str
    prefix: str
    model: Any
    step_s: float


def _units_of(robot: RobotModel, called: dict[str, str], stand: _Stand) -> Iterator[RobotUnit]:
    name, place, prefix, step_s = stand.robot, stand.place, stand.prefix, stand.step_s
    for drives in robot.bases:  # before arms on them, whose drives bear their own weight
        for base_kind in (BaseUnit, KinematicBaseUnit):
            yield base_kind(called[drives.base.name], drives, name, place, prefix, step_s)
    for facts in robot.joints:
        base = _base(stand.model, robot, prefix, facts.start) if facts.start else ()
        for kind in (JointUnit if facts.held_by is None else HeldJointUnit, KinematicJointUnit):
            yield kind(called[facts.name], facts, name, place, prefix, step_s, base)
    for fingers in robot.grippers:
        hand_kind = FingerUnit if fingers.gripper.drive == "opening" else SignalUnit
        yield hand_kind(called[fingers.gripper.name], fingers, name, place, prefix, step_s)
    for sensor in robot.sensors:
        yield SensorUnit(called[sensor.name], sensor, stand.model, name, place, prefix)


def _base(model: Any, robot: RobotModel, prefix: str, start: str) -> tuple[float, ...]:
    """Where frame 0 is in the world at home, double[4,4] in a row: a body of the robot, or its place."""
    data = at_home(model, robot.joints, prefix)
    if start == _WORLD:
        pose = chain.site_pose(data, int(model.site(prefix + ORIGIN).id))
    else:
        pose = chain.body_pose(data, int(model.body(prefix + start).id))
    return tuple(pose.ravel().tolist())
