"""What is known of a gripper: how its signal, the lengths of its actuators and the way between its fingers belong.

All three are proportional to each other: the file says two signals and the widths that belong to them.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from onika.model.robot import Numbers, RobotGripper
from onika.words.reason import Reason
from onika.workcell.composed.joint_facts import Unfit

_STRONG_N = 100.0
"""What fingers press with at most where nobody says it."""


@dataclass(frozen=True, slots=True)
class GripperFacts:
    """A gripper; the names are those of the robot's model.

    lengths    of its first actuator where it is closed, and where it is open
    ways       the same of each of them that is a motor, which knows no place by itself; None: its signal does
    leverage   by how much an actuator's length changes for each metre that the fingers go apart
    force      what the fingers press with at most (N)
    """

    gripper: RobotGripper
    lengths: tuple[float, float]
    leverage: float
    force: float
    constants: Mapping[str, Numbers | str]
    ways: tuple[tuple[float, float] | None, ...] = ()


def gripper_facts(model: Any, gripper: RobotGripper, robot: str) -> GripperFacts | Unfit:
    """A gripper of a compiled robot."""
    actuators = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_ACTUATOR, name) for name in gripper.moves]
    if min(actuators) < 0:
        there = tuple(model.actuator(k).name for k in range(model.nu)) or Reason.of("workcell.none")
        lacking = gripper.moves[actuators.index(-1)]
        return Unfit("MOVES", Reason.of("workcell.no_such_name", there=there, name=lacking))
    for sensor in gripper.force:
        if mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SENSOR, sensor) < 0:
            there = tuple(model.sensor(k).name for k in range(model.nsensor)) or Reason.of("workcell.none")
            return Unfit("FORCE", Reason.of("workcell.no_such_name", there=there, name=sensor))
    first = actuators[0]
    closed, opened = (_length(model, first, signal[0]) for signal in (gripper.closed, gripper.open))
    if closed == opened:
        return Unfit("OPEN", Reason.of("workcell.gripper_still", name=gripper.name))
    leverage = (opened - closed) / (gripper.open[1] - gripper.closed[1])
    force = _strength(model, actuators, gripper) * abs(leverage)
    sheet: dict[str, Numbers | str] = {
        "ROBOT": robot,
        "OPEN": (gripper.open[1],),
        "CLOSED": (gripper.closed[1],),
        "FORCE": (force,),
    }
    ways = tuple(_way(model, actuator, gripper) for actuator in actuators)
    return GripperFacts(gripper, (closed, opened), leverage, force, sheet, ways)


def _way(model: Any, actuator: int, gripper: RobotGripper) -> tuple[float, float] | None:
    """The lengths of a motor where the gripper is closed, and where it is open; a cylinder has its own two places."""
    is_motor = int(model.actuator_dyntype[actuator]) == int(mujoco.mjtDyn.mjDYN_NONE)
    if not is_motor or float(model.actuator_biasprm[actuator, 1]) != 0.0:
        return None
    return _length(model, actuator, gripper.closed[0]), _length(model, actuator, gripper.open[0])


def _length(model: Any, actuator: int, signal: float) -> float:
    """The length at which an actuator comes to rest with a signal: where its servo does, else at the end of its way."""
    gain, offset, stiffness = (
        float(model.actuator_gainprm[actuator, 0]),
        float(model.actuator_biasprm[actuator, 0]),
        -float(model.actuator_biasprm[actuator, 1]),
    )
    if stiffness > 0.0:
        return (gain * signal + offset) / stiffness
    return float(_ends(model, actuator)[1 if signal > 0.0 else 0])


def _ends(model: Any, actuator: int) -> tuple[float, float]:
    """How short and how long an actuator gets."""
    if int(model.actuator_trntype[actuator]) == int(mujoco.mjtTrn.mjTRN_JOINT):
        gear = float(model.actuator_gear[actuator, 0])
        ends = gear * model.jnt_range[int(model.actuator_trnid[actuator, 0])]
        return float(ends.min()), float(ends.max())
    low, high = model.actuator_lengthrange[actuator]
    return float(low), float(high)


def _strength(model: Any, actuators: list[int], gripper: RobotGripper) -> float:
    """The sum of what the actuators pull with at most."""
    return float(np.sum([_force(model, actuator, gripper) for actuator in actuators]))


def _force(model: Any, actuator: int, gripper: RobotGripper) -> float:
    if model.actuator_forcelimited[actuator]:
        return float(np.abs(model.actuator_forcerange[actuator]).max())
    if float(model.actuator_biasprm[actuator, 1]) == 0.0:
        signals = gripper.open[0], gripper.closed[0]
        return abs(float(model.actuator_gainprm[actuator, 0])) * max(map(abs, signals))
    return _STRONG_N
