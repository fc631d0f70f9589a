"""The constants of a chain of joints, derived from a compiled model: SCREW, LINK, PARENT, all at q = 0 in frame 0.

SCREW double[NDOF,6]   axis w and v = -w x p of each joint, p a point on it; of one that slides w is 0 and v its axis
LINK double[NDOF,13]   mass, centre (3), inertia about it xx yy zz xy xz yz, armature, damping, dry friction (SI)
PARENT double[NDOF]    the joint before it, -1 at the base

Frame 0 is the body in which the chain begins. Joints beside the chain stand as in the model; their bodies are part of
the link that bears them. Source: R. M. Murray, Z. Li, S. S. Sastry, A Mathematical Introduction to Robotic
Manipulation, §3.2.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from onika.laws.frames import Array, inverse_pose

_MOVING = (int(mujoco.mjtJoint.mjJNT_SLIDE), int(mujoco.mjtJoint.mjJNT_HINGE))


@dataclass(frozen=True, slots=True)
class Chain:
    """The joints of a chain by their numbers in the model, the body of its frame 0, and its constants."""

    joints: tuple[int, ...]
    start: int
    screw: Array
    link: Array
    parent: Array


def joints_between(model: Any, start: int | None, body: int) -> tuple[int, ...]:
    """Hinges and slides from a body, or the world, to another one, from the base on; raises ValueError for a ball."""
    joints: list[int] = []
    while body and body != start:
        first, count = int(model.body_jntadr[body]), int(model.body_jntnum[body])
        own = range(first, first + count)
        if any(int(model.jnt_type[joint]) not in _MOVING for joint in own):
            raise ValueError(model.joint(first).name)
        joints[:0] = own
        body = int(model.body_parentid[body])
    return tuple(joints)


def chain(model: Any, joints: Sequence[int], start: int) -> Chain:
    """The constants of these joints, frame 0 being that of the body `start`."""
    data = at_zero(model, joints)
    to_base = inverse_pose(body_pose(data, start))
    screw, link = np.zeros((len(joints), 6)), np.zeros((len(joints), 13))
    for k, joint in enumerate(joints):
        screw[k] = _screw(model, data, joint, to_base)
        dof = int(model.jnt_dofadr[joint])
        frictions = (model.dof_armature, model.dof_damping, model.dof_frictionloss)
        link[k, 10:] = [float(np.ravel(of[dof])[0]) for of in frictions]
    for k, bodies in enumerate(_bodies(model, joints)):
        link[k, :10] = _inertia(model, data, bodies, to_base)
    return Chain(tuple(joints), start, screw, link, np.arange(-1.0, len(joints) - 1))


def at_zero(model: Any, joints: Sequence[int]) -> Any:
    """The model's data with these joints at 0 and all others as the model has them."""
    data = mujoco.MjData(model)
    data.qpos[:] = model.qpos0
    for joint in joints:
        data.qpos[model.jnt_qposadr[joint]] = 0.0
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    return data


def body_pose(data: Any, body: int) -> Array:
    """Where a body is, double[4,4]."""
    return _pose(data.xpos[body], data.xmat[body])


def site_pose(data: Any, site: int) -> Array:
    """Where a site is, double[4,4]."""
    return _pose(data.site_xpos[site], data.site_xmat[site])


def _pose(position: Array, rotation: Array) -> Array:
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = rotation.reshape(3, 3), position
    return pose


def _screw(model: Any, data: Any, joint: int, to_base: Array) -> Array:
    axis = to_base[:3, :3] @ data.xaxis[joint]
    if int(model.jnt_type[joint]) == _MOVING[0]:
        return np.concatenate((np.zeros(3), axis))
    point = to_base[:3, :3] @ data.xanchor[joint] + to_base[:3, 3]
    return np.concatenate((axis, -np.cross(axis, point)))


def _bodies(model: Any, joints: Sequence[int]) -> list[list[int]]:
    """For each joint, the bodies that it moves and no later one of the chain does."""
    places = {joint: k for k, joint in enumerate(joints)}
    owned: list[list[int]] = [[] for _ in joints]
    for body in range(1, model.nbody):
        bearer = _bearer(model, body, places)
        if bearer is not None:
            owned[bearer].append(body)
    return owned


def _bearer(model: Any, body: int, places: dict[int, int]) -> int | None:
    """The last joint of the chain that moves a body."""
    while body:
        first, count = int(model.body_jntadr[body]), int(model.body_jntnum[body])
        own = [places[joint] for joint in range(first, first + count) if joint in places]
        if own:
            return max(own)
        body = int(model.body_parentid[body])
    return None


def _inertia(model: Any, data: Any, bodies: Sequence[int], to_base: Array) -> Array:
    """Mass, centre and inertia of bodies as one."""
    heavy = [body for body in bodies if float(np.ravel(model.body_mass[body])[0]) > 0.0]
    masses = [float(np.ravel(model.body_mass[body])[0]) for body in heavy]
    total = sum(masses)
    if total == 0.0:
        return np.zeros(10)
    centres = [to_base[:3, :3] @ data.xipos[body] + to_base[:3, 3] for body in heavy]
    centre: Array = np.sum([mass * at for mass, at in zip(masses, centres, strict=True)], axis=0) / total
    inertia = np.zeros((3, 3))
    for body, mass, at in zip(heavy, masses, centres, strict=True):
        turn = to_base[:3, :3] @ data.ximat[body].reshape(3, 3)
        way = at - centre
        inertia += turn @ np.diag(model.body_inertia[body]) @ turn.T
        inertia += mass * (way @ way * np.eye(3) - np.outer(way, way))
    products = inertia[0, 1], inertia[0, 2], inertia[1, 2]
    return np.array((total, *centre, *np.diag(inertia), *products))
