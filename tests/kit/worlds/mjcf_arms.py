"""Small arms as MJCF, their constants read from the compiled model, and what the model itself says of them.

They have what arms of textbooks have not: axes that are askew, products of inertia, seven joints, slides, branches.
"""

from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from onika.laws.frames import Array, inverse_pose

_INERTIAL = '<inertial pos="0.02 0.03 0.1" mass="1.0" fullinertia="0.03 0.02 0.025 0.004 -0.003 0.002"/>'
_TOOL = '<site name="tool" pos="0.01 0 0.12" euler="0.1 0.2 0.3"/>'
_X, _Y, _Z = (f'axis="{axis}" range="-2.6 2.6"' for axis in ("1 0 0", "0 1 0", "0 0 1"))


def _body(joint: str, at: str, inner: str, euler: str = "0 0 0") -> str:
    return f'<body pos="{at}" euler="{euler}">{_INERTIAL}<joint {joint}/>{inner}</body>'


def _nested(joints: tuple[tuple[str, str], ...], euler: str = "0 0 0") -> str:
    inner = _TOOL
    for joint, at in reversed(joints):
        inner = _body(joint, at, inner, euler)
    return inner


def _document(inner: str) -> str:
    return (
        '<mujoco><compiler angle="radian" autolimits="true"/><option integrator="implicitfast"/>'
        '<default><joint armature="0.05" damping="0.4"/></default>'
        f'<worldbody><body name="base" pos="0.1 -0.2 0.3" euler="0 0 0.5">{inner}</body></worldbody></mujoco>'
    )


_SEVEN = (
    *((_Z, "0 0 0.2"), (_Y, "0 0 0.1"), (_Z, "0 0 0.2"), (_Y, "0.05 0 0.15")),
    *((_Z, "-0.05 0 0.2"), (_Y, "0 0 0.1"), (_X, "0.08 0 0.05")),
)
_SIX = (
    *((_Z, "0 0 0.1"), (_Y, "0.1 0.03 0.1"), (_Y, "0.3 0 0.1")),
    *((_X, "0.1 0.05 0.1"), (_Y, "0.2 0 0"), (_Z, "0 0.08 0.05")),
)
_FIVE = ((_Z, "0 0 0.05"), (_Y, "0 0 0.06"), (_Y, "0 0 0.12"), (_Y, "0 0 0.13"), (_Z, "0 0 0.05"))
_GANTRY = (
    ('type="slide" axis="1 0 0" range="-0.5 0.5"', "0 0 0.5"),
    ('type="slide" axis="0 1 0" range="-0.4 0.4"', "0 0 0"),
    ('type="slide" axis="0 0 -1" range="0 0.3"', "0 0 0"),
    (_Z, "0 0 -0.1"),
)
_BRANCHES = (
    _body(_Y, "0.05 0.04 0.1", _body(_Y, "0 0 0.08", ""), "0.2 0 0"),
    _body(_Y, "0.05 -0.04 0.1", _body(_Y, "0 0 0.09", _TOOL), "-0.2 0 0"),
)


@dataclass(frozen=True, slots=True)
class MjcfArm:
    """An arm as a compiled model, with the constants that were read from it."""

    model: Any
    constants: dict[str, Any]

    @property
    def n(self) -> int:
        """The number of joints."""
        return int(self.model.njnt)

    def data_at(self, q: Array, qd: Array | None = None) -> Any:
        """The model's own data at q and qd."""
        data = mujoco.MjData(self.model)
        data.qpos[:] = q
        data.qvel[:] = 0.0 if qd is None else qd
        mujoco.mj_forward(self.model, data)
        return data

    def pose(self, q: Array) -> Array:
        """The pose of the tool in the world, as the model has it."""
        data = self.data_at(q)
        return _pose(data.site("tool").xmat, data.site("tool").xpos)

    def inertia(self, q: Array) -> Array:
        """The mass matrix, as the model has it."""
        data = self.data_at(q)
        columns = np.empty((self.n, self.n))
        for column, unit in zip(columns, np.eye(self.n), strict=True):
            mujoco.mj_mulM(self.model, data, column, unit)
        return columns

    def identity(self, drive: str, robot: str = "small") -> dict[str, tuple[float, ...] | str]:
        """What a device of this arm says of itself."""
        numbers = {name: tuple(np.ravel(value).astype(float).tolist()) for name, value in self.constants.items()}
        return {"ROBOT": robot, "DRIVE": drive, **numbers}


def mjcf_arm(text: str) -> MjcfArm:
    """Compile an arm whose base body is called `base` and whose tool is the site `tool`, and read its constants."""
    return arm_of_model(mujoco.MjModel.from_xml_string(text))


def arm_of_model(model: Any, base: str = "base", tool: str = "tool") -> MjcfArm:
    """The constants of all joints of a model; raises KeyError where it has no such body or site."""
    data = mujoco.MjData(model)
    data.qpos[:] = 0.0
    mujoco.mj_forward(model, data)
    stand = _pose(data.body(base).xmat, data.body(base).xpos)
    into = inverse_pose(stand)
    n = int(model.njnt)
    screw, parent = np.zeros((n, 6)), np.full(n, -1)
    for k in range(n):
        axis, place = into[:3, :3] @ data.xaxis[k], (into @ [*data.xanchor[k], 1.0])[:3]
        is_slide = model.jnt_type[k] == mujoco.mjtJoint.mjJNT_SLIDE
        screw[k] = [0.0, 0.0, 0.0, *axis] if is_slide else [*axis, *np.cross(place, axis)]
        body = int(model.jnt_bodyid[k])
        is_first = int(model.body_jntadr[body]) == k
        parent[k] = _moved_by(model, int(model.body_parentid[body])) if is_first else k - 1
    limited = np.asarray(model.jnt_limited, dtype=bool)
    low, high = np.where(limited, model.jnt_range[:, 0], -np.inf), np.where(limited, model.jnt_range[:, 1], np.inf)
    return MjcfArm(
        model,
        {
            "NDOF": n,
            "SCREW": screw,
            "LINK": np.array([_link(model, data, into, k) for k in range(n)]),
            "PARENT": parent,
            "TOOL": into @ _pose(data.site(tool).xmat, data.site(tool).xpos),
            "BASE": stand,
            "QMIN": low,
            "QMAX": high,
            "Q^_MAX": np.full(n, 2.0),
            "TAUMAX": np.full(n, 200.0),
            "HOME": np.clip(np.full(n, 0.3), low, high),
        },
    )


def _link(model: Any, data: Any, into: Array, joint: int) -> list[float]:
    """A row of LINK: the bodies that a joint moves by itself, taken together."""
    bodies = [body for body in range(1, model.nbody) if _moved_by(model, body) == joint]
    mass = float(sum(model.body_mass[body] for body in bodies))
    centres = {body: (into @ [*data.xipos[body], 1.0])[:3] for body in bodies}
    centre = sum((model.body_mass[body] * centres[body] for body in bodies), np.zeros(3)) / max(mass, 1e-12)
    inertia = np.zeros((3, 3))
    for body in bodies:
        turn, way = into[:3, :3] @ data.ximat[body].reshape(3, 3), centres[body] - centre
        inertia += turn @ np.diag(model.body_inertia[body]) @ turn.T
        inertia += model.body_mass[body] * (way @ way * np.eye(3) - np.outer(way, way))
    moments = [inertia[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
    dof = int(model.jnt_dofadr[joint])
    own = [np.ravel(of[dof])[0] for of in (model.dof_armature, model.dof_damping, model.dof_frictionloss)]
    return [mass, *centre, *moments, *own]


def _moved_by(model: Any, body: int) -> int:
    """The joint that moves a body; -1: none does."""
    while body and not model.body_jntnum[body]:
        body = int(model.body_parentid[body])
    return int(model.body_jntadr[body] + model.body_jntnum[body] - 1) if body else -1


def _pose(turn: Any, place: Any) -> Array:
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = np.reshape(turn, (3, 3)), place
    return pose


SEVEN = _document(_nested(_SEVEN))
"""An arm of seven joints, without motors."""

ARMS = {
    "seven": mjcf_arm(SEVEN),
    "six": mjcf_arm(_document(_nested(_SIX, "0.1 -0.07 0.05"))),
    "five": mjcf_arm(_document(_nested(_FIVE))),
    "gantry": mjcf_arm(_document(_nested(_GANTRY))),
    "tree": mjcf_arm(_document(_body(_Z, "0 0 0.1", "".join(_BRANCHES)))),
}
"""By their names; joints without limits are those without a range."""
