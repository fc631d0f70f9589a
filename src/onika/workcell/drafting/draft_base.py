"""Which joints of a model drive it about: two wheels beside each other, or two slides and a turn (requirement X19)."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import mujoco
import numpy as np

from onika.laws.frames import Array
from onika.model.robot import RobotBase
from onika.words.reason import Reason

BASE = "base"
AHEAD_M = 0.3
"""How far the first motion of a base leads."""

_ALONG = 0.999  # the least share of an axis that lies along the one that it should be
_BESIDE_M = 0.005  # how far one wheel may stand before or above the other
_HINGE, _SLIDE = int(mujoco.mjtJoint.mjJNT_HINGE), int(mujoco.mjtJoint.mjJNT_SLIDE)


@dataclass(frozen=True, slots=True)
class DraftBase:
    """A base with the numbers of its joints, where its lines come from, and how high the floor is below it (m)."""

    device: RobotBase
    joints: tuple[int, ...]
    origin: Reason
    floor: float = 0.0


def draft_base(model: Any) -> DraftBase | None:
    """The base of a compiled model; None: it has none that is like one."""
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    actuators = {
        int(model.actuator_trnid[k, 0]): k for k in range(model.nu) if not int(model.actuator_trntype[k])
    }  # by the joints that they drive
    return _on_slides(model, data, actuators) or _on_wheels(model, data, actuators)


def _on_slides(model: Any, data: Any, actuators: dict[int, int]) -> DraftBase | None:
    """The first three joints of a tree, along x, along y and about z."""
    first = [joint for joint in sorted(actuators) if _bears_all(model, joint)][:3]
    wanted = ((_SLIDE, 0), (_SLIDE, 1), (_HINGE, 2))
    if len(first) < len(wanted) or not all(
        int(model.jnt_type[joint]) == kind and abs(float(data.xaxis[joint][axis])) > _ALONG
        for joint, (kind, axis) in zip(first, wanted, strict=True)
    ):
        return None
    names = tuple(model.actuator(actuators[joint]).name for joint in first)
    device = RobotBase(BASE, slides=names, lines={"BASE": 1})
    return DraftBase(device, tuple(first), Reason.of("workcell.draft_slides"))


def _bears_all(model: Any, joint: int) -> bool:
    """Whether nothing but other joints of this kind stands between a joint and the world, and no second tree."""
    root = int(model.body_rootid[int(model.jnt_bodyid[joint])])
    trees = {int(model.body_rootid[body]) for body in range(1, model.nbody) if model.body_jntnum[body]}
    return trees == {root}


def _on_wheels(model: Any, data: Any, actuators: dict[int, int]) -> DraftBase | None:
    """Two driven wheels of one body that stands or may stand on the floor, and no third and fourth one."""
    wheels = [joint for joint in actuators if _is_wheel(model, data, joint)]
    pairs = [pair for pair in combinations(wheels, 2) if _are_beside(model, data, *pair)]
    if len(pairs) != 1:
        return None
    left, right = sorted(pairs[0], key=lambda joint: -_place(model, data, joint)[1])
    track = float(_place(model, data, left)[1] - _place(model, data, right)[1])
    radius = _radius(model, data, int(model.jnt_bodyid[left]))
    names = tuple(model.actuator(actuators[joint]).name for joint in (left, right))
    device = RobotBase(BASE, names, round(radius, 4), round(track, 4), lines={"BASE": 1})
    floor = float(data.xanchor[left][2]) - radius
    return DraftBase(device, (left, right), Reason.of("workcell.draft_wheels"), round(floor, 4))


def _is_wheel(model: Any, data: Any, joint: int) -> bool:
    """Whether it turns without limit about y of a body that is fixed to nothing, bears nothing and has a shape."""
    body = int(model.jnt_bodyid[joint])
    bearer = int(model.body_parentid[body])
    if int(model.jnt_type[joint]) != _HINGE or model.jnt_limited[joint] or not bearer:
        return False
    axis = data.xmat[bearer].reshape(3, 3).T @ data.xaxis[joint]
    bears = any(int(model.body_parentid[other]) == body for other in range(1, model.nbody))
    is_free = all(int(model.jnt_type[k]) == int(mujoco.mjtJoint.mjJNT_FREE) for k in _joints_above(model, bearer))
    return abs(float(axis[1])) > _ALONG and not bears and is_free and _radius(model, data, body) > 0.0


def _joints_above(model: Any, body: int) -> Iterator[int]:
    while body:
        first = int(model.body_jntadr[body])
        yield from range(first, first + int(model.body_jntnum[body]))
        body = int(model.body_parentid[body])


def _are_beside(model: Any, data: Any, one: int, other: int) -> bool:
    bodies = [int(model.body_parentid[int(model.jnt_bodyid[joint])]) for joint in (one, other)]
    apart = _place(model, data, one) - _place(model, data, other)
    return bodies[0] == bodies[1] and max(abs(apart[0]), abs(apart[2])) < _BESIDE_M < abs(apart[1])


def _place(model: Any, data: Any, joint: int) -> Array:
    """Where a joint is in the frame of the body that bears its wheel."""
    bearer = int(model.body_parentid[int(model.jnt_bodyid[joint])])
    frame = data.xmat[bearer].reshape(3, 3)
    return np.asarray(frame.T @ (data.xanchor[joint] - data.xpos[bearer]))


def _radius(model: Any, data: Any, body: int) -> float:
    """How far the shapes of a wheel that touch, else all of them, reach down from its middle."""
    first = int(model.body_geomadr[body])
    geoms: Sequence[int] = range(first, first + int(model.body_geomnum[body])) if first >= 0 else ()
    touching = [geom for geom in geoms if model.geom_contype[geom] or model.geom_conaffinity[geom]]
    return max((_reach(model, data, geom) for geom in touching or geoms), default=0.0)


def _reach(model: Any, data: Any, geom: int) -> float:
    """Half the height of the box around a shape."""
    return float(np.abs(data.geom_xmat[geom].reshape(3, 3)[2]) @ model.geom_aabb[geom][3:])
