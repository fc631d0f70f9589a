"""The tool of an arm in a compiled world: the point between its fingers, y along their way, z the approach."""

from typing import Any

import mujoco
import numpy as np

from onika.laws.frames import Array, inverse_pose
from onika.workcell.composed import chain
from onika.workcell.composed.joint_unit import JointUnit
from onika.workcell.composed.robot_model import ORIGIN
from onika.workcell.plant import Plant

_WORLD = "world"


class ToolFrame:
    """The tool of one arm; `link` is the body of its last joint, in which it does not move."""

    def __init__(self, plant: Plant, unit: JointUnit) -> None:
        model = plant.model
        joints = [int(model.joint(name).id) for name in unit.joint_names]
        self.link = int(model.jnt_bodyid[joints[-1]])
        data = chain.at_zero(model, joints)
        tool = np.reshape(unit.facts.constants["TOOL"], (4, 4))
        self._in_link: Array = inverse_pose(chain.body_pose(data, self.link)) @ _frame_0(model, data, unit) @ tool
        self._place, self._turn = plant.data.xpos[self.link], plant.data.xmat[self.link].reshape(3, 3)

    def pose(self) -> Array:
        """Where it is in the world, double[4,4], as of the last kinematics."""
        pose = np.eye(4)
        pose[:3, :3], pose[:3, 3] = self._turn, self._place
        tool: Array = pose @ self._in_link
        return tool


def _frame_0(model: Any, data: Any, unit: JointUnit) -> Array:
    mujoco.mj_kinematics(model, data)
    start = unit.facts.start
    if start == _WORLD:
        return chain.site_pose(data, int(model.site(unit.prefix + ORIGIN).id))
    return chain.body_pose(data, int(model.body(unit.prefix + start).id))
