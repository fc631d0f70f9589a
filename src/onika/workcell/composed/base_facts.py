"""What is known of a base that drives, from the compiled model of its robot and from its file.

On wheels it has a free joint, which nothing drives; the floor does. On slides it hangs at two slides and a turn.
Forward is x of its body, left y.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from onika.laws.frames import Array
from onika.model.robot import Numbers, RobotBase
from onika.words.reason import Reason
from onika.workcell.composed import chain
from onika.workcell.composed.joint_facts import Unfit, absent, highest_torque
from onika.workcell.composed.servo import felt_inertia

FREE_JOINT = "free"
"""The joint of a base on wheels whose model has none."""

_QUICK = 200.0  # 1/s: how quick a drive comes to its speed
_ALONG = 0.999  # the least share of an axis that lies along the one that it should be


@dataclass(frozen=True, slots=True)
class BaseFacts:
    """A base; the names are those of the robot's model.

    body       whose place and heading are told
    root       the body that bears all of it
    free       the free joint of a base on wheels; empty for one on slides
    joints     those of the actuators
    turned     +1 or -1 for each: which way round it is
    gains      of its drives: force or torque per speed
    torque     the highest force or torque of each
    speed      the highest speeds forward and to the left (m/s), and of turning (rad/s)
    """

    base: RobotBase
    body: str
    root: str
    free: str
    joints: tuple[str, ...]
    turned: Array
    gains: Array
    torque: Array
    speed: Array
    constants: Mapping[str, Numbers | str]

    @property
    def name(self) -> str:
        """The name of its block."""
        return self.base.name

    @property
    def keyword(self) -> str:
        """The line of its block that says which joints it has."""
        return "WHEELS" if self.base.wheels else "SLIDES"


def base_facts(model: Any, base: RobotBase, robot: str) -> BaseFacts | Unfit:
    """A base of a compiled robot."""
    keyword = "WHEELS" if base.wheels else "SLIDES"
    actuators, joints = [], []
    for name in base.wheels or base.slides:
        actuator = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_ACTUATOR, name)
        if actuator < 0:
            return absent(model, keyword, "actuator", model.nu, name)
        if int(model.actuator_trntype[actuator]) != int(mujoco.mjtTrn.mjTRN_JOINT):
            return Unfit(keyword, Reason.of("workcell.no_joint_moved", actuator=name))
        actuators.append(actuator)
        joints.append(int(model.actuator_trnid[actuator, 0]))
    last = int(model.jnt_bodyid[joints[-1]])
    body = int(model.body_parentid[last]) if base.wheels else last
    turned = _turned(model, joints, body if base.wheels else 0, is_on_wheels=bool(base.wheels))
    if isinstance(turned, Reason):
        return Unfit(keyword, turned)
    root = int(model.body_rootid[body])
    free = _free_joint(model, root)
    if base.wheels and not free:
        return Unfit(keyword, Reason.of("workcell.base_fixed", body=model.body(root).name))
    torque = np.array([highest_torque(model, at, joint) for at, joint in zip(actuators, joints, strict=True)])
    sheet: dict[str, Numbers | str] = {"ROBOT": robot, "DRIVE": "twist", "V_MAX": tuple(_speed(base).tolist())}
    return BaseFacts(
        base,
        model.body(body).name,
        model.body(root).name,
        free,
        tuple(model.joint(joint).name for joint in joints),
        turned,
        _QUICK * _inertia(model, base, joints, root),
        torque,
        _speed(base),
        sheet,
    )


def _speed(base: RobotBase) -> Array:
    """Two wheels do not go to the left."""
    forward, turning = base.speed
    return np.array((forward, 0.0 if base.wheels else forward, turning))


def _turned(model: Any, joints: Sequence[int], body: int, *, is_on_wheels: bool) -> Array | Reason:
    """Which way round each joint is about, or along, the axis where it belongs; or why it is neither."""
    data = chain.at_zero(model, ())
    hinge, slide = int(mujoco.mjtJoint.mjJNT_HINGE), int(mujoco.mjtJoint.mjJNT_SLIDE)
    places = ((hinge, 1), (hinge, 1)) if is_on_wheels else ((slide, 0), (slide, 1), (hinge, 2))
    turned = np.zeros(len(joints))
    to_body = data.xmat[body].reshape(3, 3).T
    for k, (joint, (kind, axis)) in enumerate(zip(joints, places, strict=True)):
        along = float((to_body @ data.xaxis[joint])[axis])
        if int(model.jnt_type[joint]) != kind or abs(along) < _ALONG:
            key = "workcell.wheel_askew" if is_on_wheels else "workcell.slide_askew"
            return Reason.of(key, joint=model.joint(joint).name, axis="xyz"[axis])
        turned[k] = np.sign(along)
    return turned


def _free_joint(model: Any, body: int) -> str:
    first = int(model.body_jntadr[body])
    is_free = first >= 0 and int(model.jnt_type[first]) == int(mujoco.mjtJoint.mjJNT_FREE)
    return str(model.joint(first).name) if is_free else ""


def _inertia(model: Any, base: RobotBase, joints: Sequence[int], root: int) -> Array:
    """What each drive has to bring to speed (kg m2; kg): a wheel half of the whole base too."""
    dofs = np.array([int(model.jnt_dofadr[joint]) for joint in joints])
    felt = felt_inertia(model, mujoco.MjData(model), dofs)
    if not base.wheels:
        return felt
    mass = float(np.ravel(model.body_subtreemass[root])[0])
    return np.asarray(felt + 0.5 * mass * base.radius**2)
