"""What of a model is a gripper, and how far its fingers are apart: tried out, as no model says it (requirement X19)."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import mujoco
import numpy as np

from onika.laws.frames import Array
from onika.model.robot import RobotAxes, RobotDevice, RobotGripper
from onika.words.reason import Reason
from onika.workcell.drafting.draft_chain import DraftChain, below
from onika.workcell.drafting.draft_jaw import DraftJaw, draft_jaw

_MOST = 2  # actuators that a gripper has; more are fingers of a hand
_STEPS = 500
_WIDTH_M = 0.05
_LEAST_M = 0.002  # what opens less than this was not seen to open
_SIGNAL = 20.0
_FARTHEST_M = 1.0
_JOINT = int(mujoco.mjtTrn.mjTRN_JOINT)


@dataclass(frozen=True, slots=True)
class DraftHand:
    """What is below the last joint of an arm: a device or none, the bodies that it moves, where it comes from."""

    device: RobotDevice | None
    fingers: tuple[int, ...]
    origin: Reason
    jaw: DraftJaw | None = None
    """Its only finger, where that closes on what does not move."""


def draft_hand(model: Any, chain: DraftChain, home: Array) -> DraftHand:
    """The gripper, or the servos of a hand, at the end of an arm whose joints stand at `home`."""
    bodies = below(model, chain.last)
    fingers = tuple(body for body in bodies if body != chain.last and model.body_jntnum[body])
    actuators = [k for k in range(model.nu) if _is_at(model, k, fingers, chain)]
    if not actuators:
        return DraftHand(None, fingers, Reason.plain(""))
    if len(actuators) > _MOST:
        return DraftHand(_servos(model, actuators), fingers, Reason.of("workcell.draft_hand", count=len(actuators)))
    names, ends = tuple(model.actuator(k).name for k in actuators), _signals(model, actuators[0])

    def tried(signal: float) -> Any:
        return _at_rest(model, chain, home, actuators, signal)

    if len(fingers) == 1:
        is_servo = bool(model.actuator_biasprm[actuators[0], 1])
        jaw = draft_jaw(model, chain.last, fingers[0], ends, tried, is_servo=is_servo)
        if jaw.open[1] - jaw.closed[1] >= _LEAST_M:
            gripper = RobotGripper("gripper", names, jaw.open, jaw.closed)
            return DraftHand(gripper, fingers, Reason.of("workcell.draft_width_jaw"), jaw)
    gripper, origin = _gripper(names, ends, [_width(model, tried(signal), fingers) for signal in ends])
    return DraftHand(gripper, fingers, origin)


def _servos(model: Any, actuators: Sequence[int]) -> RobotAxes | None:
    """Those of some actuators that move a joint."""
    names = tuple(model.actuator(k).name for k in actuators if int(model.actuator_trntype[k]) == _JOINT)
    return RobotAxes("fingers", names) if names else None


def _gripper(
    names: tuple[str, ...], ends: tuple[float, float], tried: Sequence[float | None]
) -> tuple[RobotGripper, Reason]:
    """The gripper of these actuators, with what was seen of its fingers at the ends of their signal."""
    widths, origin = [width for width in tried if width is not None], Reason.of("workcell.draft_width_tried")
    if len(widths) < len(ends) or abs(widths[0] - widths[1]) < _LEAST_M:
        widths, origin = [0.0, _WIDTH_M], Reason.of("workcell.draft_width_guessed")
    (closed, closing), (opened, opening) = sorted(zip(widths, ends, strict=True))
    return RobotGripper("gripper", names, (opening, round(opened, 4)), (closing, round(closed, 4))), origin


def _is_at(model: Any, actuator: int, fingers: Sequence[int], chain: DraftChain) -> bool:
    """Whether an actuator moves fingers, by a joint or a tendon."""
    target = int(model.actuator_trnid[actuator, 0])
    if int(model.actuator_trntype[actuator]) == _JOINT:
        return int(model.jnt_bodyid[target]) in fingers and target not in chain.joints
    if int(model.actuator_trntype[actuator]) != int(mujoco.mjtTrn.mjTRN_TENDON):
        return False
    first = int(model.tendon_adr[target])
    wraps = range(first, first + int(model.tendon_num[target]))
    joint = int(mujoco.mjtWrap.mjWRAP_JOINT)
    joints = [int(model.wrap_objid[k]) for k in wraps if int(model.wrap_type[k]) == joint]
    return any(int(model.jnt_bodyid[k]) in fingers for k in joints)


def _signals(model: Any, actuator: int) -> tuple[float, float]:
    """The ends of what an actuator takes."""
    if model.actuator_ctrllimited[actuator]:
        low, high = (float(end) for end in model.actuator_ctrlrange[actuator])
        return low, high
    joint = int(model.actuator_trnid[actuator, 0])
    is_joint = int(model.actuator_trntype[actuator]) == _JOINT
    if is_joint and model.actuator_biasprm[actuator, 1] and model.jnt_limited[joint]:
        low, high = (float(end) for end in model.jnt_range[joint])
        return low, high
    if is_joint and model.jnt_actfrclimited[joint]:
        strength = float(np.abs(model.jnt_actfrcrange[joint]).max())
        return -strength, strength
    return -_SIGNAL, _SIGNAL


def _at_rest(model: Any, chain: DraftChain, home: Array, actuators: Sequence[int], signal: float) -> Any:
    """The data once the fingers have come to rest with a signal."""
    data = mujoco.MjData(model)
    at = [int(model.jnt_qposadr[joint]) for joint in chain.joints]
    dofs = [int(model.jnt_dofadr[joint]) for joint in chain.joints]
    data.qpos[at] = home
    data.ctrl[list(actuators)] = signal
    for _ in range(_STEPS):
        mujoco.mj_step(model, data)
        data.qpos[at], data.qvel[dofs] = home, 0.0  # the arm stands still meanwhile
    limited = np.flatnonzero(model.jnt_limited)
    stops = model.jnt_qposadr[limited]
    data.qpos[stops] = np.clip(data.qpos[stops], *model.jnt_range[limited].T)  # strong motors press beyond them
    mujoco.mj_forward(model, data)
    return data


def _width(model: Any, data: Any, fingers: Sequence[int]) -> float | None:
    """How far the fingers are apart; None: they cannot be told apart."""
    tips = [body for body in fingers if not any(other in fingers for other in below(model, body) if other != body)]
    shapes = [[k for k in range(model.ngeom) if int(model.geom_bodyid[k]) in below(model, body)] for body in tips]
    gaps = [_gap(model, data, first, other) for first, other in combinations(shapes, 2) if first and other]
    return max(gaps) if gaps else None


def _gap(model: Any, data: Any, first: Sequence[int], other: Sequence[int]) -> float:
    """The distance of the nearest two of some shapes, 0 where they meet."""
    between = [mujoco.mj_geomDistance(model, data, a, b, _FARTHEST_M, None) for a in first for b in other]
    return max(float(min(between)), 0.0)
