"""The way of a gripper's fingers, found by trying: its joints where it is closed and open, and what is a finger of it.

Both ends are simulated without weight and contacts, with all else of the world held still; so couplings, tendons and
linkages need not be understood.
"""

import copy
from typing import Any

import mujoco
import numpy as np

from onika.laws.frames import Array
from onika.workcell.composed.finger_unit import FingerUnit
from onika.workcell.gripping.tool_frame import ToolFrame
from onika.workcell.plant import Plant

_TRIED_S = 1.5  # how long an end is tried
_MOVES_M = 0.002  # a body that goes less far is no finger
_HINGES = (int(mujoco.mjtJoint.mjJNT_SLIDE), int(mujoco.mjtJoint.mjJNT_HINGE))


class FingerWay:
    """The fingers of one gripper in one plant.

    fingers     the shapes of both fingers, each with its number; a finger that stays is what bears the other
    """

    def __init__(self, plant: Plant, unit: FingerUnit, tool: ToolFrame) -> None:
        model, self._data = plant.model, plant.data
        carried = _carried(model, tool.link)
        of_hand = [k for k in range(model.njnt) if int(model.jnt_bodyid[k]) in carried[1:]]
        joints = [k for k in of_hand if int(model.jnt_type[k]) in _HINGES]
        self._q_at = np.array([int(model.jnt_qposadr[k]) for k in joints], dtype=int)
        self._v_at = np.array([int(model.jnt_dofadr[k]) for k in joints], dtype=int)
        gripper = unit.facts.gripper
        tried = [self._tried(plant, unit, opening) for opening in (gripper.closed[1], gripper.open[1])]
        self._closed, self._opened = (_within(model, joints, data.qpos[self._q_at]) for data in tried)
        self.fingers = _fingers(model, carried, tool, *tried)

    def share(self) -> float:
        """How far the joints stand between closed, 0, and open, 1."""
        way = self._opened - self._closed
        along = float(way @ way)
        here = float(way @ (self._data.qpos[self._q_at] - self._closed)) / along if along else 0.0
        return min(max(here, 0.0), 1.0)

    def go(self, share: float, speed: float) -> None:
        """Put the joints where the gripper is open by this share, 0 to 1, and becomes so much more so in a second."""
        way = self._opened - self._closed
        self._data.qpos[self._q_at] = self._closed + share * way
        self._data.qvel[self._v_at] = speed * way

    def _tried(self, plant: Plant, unit: FingerUnit, opening: float) -> Any:
        model = copy.copy(plant.model)
        model.opt.gravity[:] = 0.0
        model.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
        data = mujoco.MjData(model)
        data.qpos[:] = plant.data.qpos
        data.ctrl[:] = plant.data.ctrl
        data.ctrl[unit.motors] = unit.signals(opening)
        still_q, still_v = np.ones(model.nq, dtype=bool), np.ones(model.nv, dtype=bool)
        still_q[self._q_at], still_v[self._v_at] = False, False
        places, speeds, there = data.qpos, data.qvel, plant.data.qpos[still_q]
        for _ in range(round(_TRIED_S / model.opt.timestep)):
            mujoco.mj_step(model, data)
            places[still_q], speeds[still_v] = there, 0.0
        mujoco.mj_kinematics(model, data)
        return data


def _carried(model: Any, first: int) -> list[int]:
    carried = [first]
    for body in range(first + 1, model.nbody):  # whoever carries stands before
        if int(model.body_parentid[body]) in carried:
            carried.append(body)
    return carried


def _within(model: Any, joints: list[int], q: Array) -> Array:
    low = np.array([model.jnt_range[k][0] if model.jnt_limited[k] else -np.inf for k in joints])
    high = np.array([model.jnt_range[k][1] if model.jnt_limited[k] else np.inf for k in joints])
    within: Array = np.clip(q, low, high)
    return within


def _fingers(model: Any, carried: list[int], tool: ToolFrame, closed: Any, opened: Any) -> dict[int, int]:
    """Which shapes go one way along y of the tool and which the other; where none goes a way, those that stay."""
    along = tool.pose()[:3, 1]
    ways = {body: float(along @ (opened.xipos[body] - closed.xipos[body])) for body in carried}
    of_body = {body: 1 if way > 0.0 else 2 for body, way in ways.items() if abs(way) > _MOVES_M}
    staying = [body for body in carried if body not in of_body]
    for number in (1, 2):
        if number not in of_body.values():
            of_body |= dict.fromkeys(staying, number)
    bodies = model.geom_bodyid.tolist()
    return {shape: of_body[body] for shape, body in enumerate(bodies) if body in of_body}
