"""A little motion with which a new robot can be tried: beside home, free of itself, and a straight line from there."""

from collections.abc import Iterable, Iterator, Sequence
from itertools import product
from typing import Any

import mujoco
import numpy as np

from onika.laws import reach
from onika.laws.arm_identity import arm_constants
from onika.laws.frames import Array, pose_of_nine
from onika.workcell.composed import chain
from onika.workcell.composed.joint_facts import JointFacts
from onika.workcell.composed.robot_model import at_home

ANY_POSE = 6
"""So many joints come to any pose; an arm of fewer goes straight only where its tool may keep its direction."""

_TURNS = (0.3, 0.2, 0.1)
_DEEP_M = 0.001
_LINES_M = (0.06, 0.03)
_POINTS = 12
_JUMP = 0.2  # between two points of a straight line a joint turns no further (rad)
_SHORTEST_S = 2.0
_LINE_S, _SLOWEST_S = 3.0, 20.0  # how long a straight line takes, and may
_HASTE = 2.5  # a motion of fifth order is faster than its mean by 1.875 in the middle, and joints are to have a reserve


def beside_home(model: Any, facts: JointFacts, excluded: Sequence[tuple[str, str]]) -> Array:
    """Joint values a little beside home, where the robot does not reach into itself; home where there are none."""
    apart = {frozenset(pair) for pair in excluded}
    for turn, sign in product(_TURNS, (1.0, -1.0)):
        slides = facts.highest - facts.lowest < turn * 4.0
        step = np.where(slides, (facts.highest - facts.lowest) / 4.0, turn)
        inward = np.where(facts.home + sign * step <= facts.highest, sign, -sign)
        away: Array = np.round(np.clip(facts.home + inward * step, facts.lowest, facts.highest), 4)
        away = np.clip(away, facts.lowest, facts.highest)
        between = (facts.home + part * (away - facts.home) for part in (0.25, 0.5, 0.75, 1.0))
        if not any(_meets(model, facts, values, apart) for values in between):
            return away
    return facts.home


def seconds_between(facts: JointFacts, away: Array) -> float:
    """How long a joint path of fifth order between home and there takes without haste."""
    return max(_SHORTEST_S, float(np.ceil(4.0 * np.max(np.abs(away - facts.home) / facts.speed))))


def straight_line(
    model: Any,
    facts: JointFacts,
    devices: Sequence[JointFacts],
    away: Array,
    excluded: Sequence[tuple[str, str]] = (),
) -> tuple[tuple[float, ...], float, tuple[Array, ...]]:
    """The nine numbers of a pose to which the tool goes straight from there, seconds, postures; empty: none was found.

    The pose is that in a world whose middle is the middle of the model; `devices` stand at home. On its way the robot
    does not reach into itself, unless it does so where the line begins.
    """
    apart = {frozenset(pair) for pair in excluded}
    is_free = not _meets(model, facts, away, apart)
    stand = chain.body_pose(at_home(model, devices), int(model.body(facts.start).id))
    constants = arm_constants({**facts.constants, "BASE": tuple(stand.ravel().tolist())})
    nine = reach.poses(constants, [away.tolist()])[0]
    for length, way in product(_LINES_M, _ways(nine)):
        points = [_shifted(nine, way, length * k / _POINTS) for k in range(_POINTS + 1)]
        postures = _without_jump(reach.postures_along(constants, points, away.tolist(), starts=0), away)
        if len(postures) < len(points) or (is_free and any(_meets(model, facts, each, apart) for each in postures)):
            continue
        fastest = _fastest([away, *postures], facts.speed)
        if fastest <= _SLOWEST_S:
            seconds = max(_LINE_S, float(np.ceil(fastest)))
            return tuple(np.round(points[-1], 6).tolist()), seconds, tuple(postures)
    return (), 0.0, ()


def lowest_point(model: Any, facts: JointFacts, postures: Sequence[Array]) -> float:
    """The height of the lowest shape of a robot that stands at 0, in any of some postures (m)."""
    lowest = 0.0
    for values in postures:
        data = _at(model, facts, values)
        for geom in range(model.ngeom):
            turn = np.abs(data.geom_xmat[geom].reshape(3, 3))
            centre, half = model.geom_aabb[geom, :3], model.geom_aabb[geom, 3:]
            middle = data.geom_xpos[geom, 2] + float(data.geom_xmat[geom].reshape(3, 3)[2] @ centre)
            is_plane = int(model.geom_type[geom]) == int(mujoco.mjtGeom.mjGEOM_PLANE)
            lowest = min(lowest, lowest if is_plane else float(middle - turn[2] @ half))
    return lowest


def _ways(nine: Array) -> Iterator[Array]:
    """Directions along the axes of the world, up first, and then along those of the tool."""
    turn = pose_of_nine(nine)[:3, :3]
    for axes in (np.eye(3), turn.T):
        for axis, sign in product((2, 0, 1), (1.0, -1.0)):
            yield sign * axes[axis]


def _shifted(nine: Array, way: Array, length: float) -> Array:
    moved: Array = np.array(nine)
    moved[6:9] += length * way
    return moved


def _without_jump(postures: Iterable[Array | str], start: Array) -> list[Array]:
    """The postures of a line up to where there is none, or a joint would jump; what lies behind is not asked for."""
    before, passed = start, []
    for posture in postures:
        if isinstance(posture, str) or np.abs(posture - before).max() > _JUMP:
            break
        passed.append(posture)
        before = posture
    return passed


def _fastest(postures: Sequence[Array], speed: Array) -> float:
    """In how many seconds these postures are passed without haste."""
    turns = np.abs(np.diff(postures, axis=0))
    return _HASTE * _POINTS * float(np.max(turns / speed))


def _meets(model: Any, facts: JointFacts, values: Array, apart: set[frozenset[str]]) -> bool:
    data = _at(model, facts, values)
    for contact in np.flatnonzero(data.contact.dist < -_DEEP_M).tolist():
        bodies = [int(model.geom_bodyid[geom]) for geom in data.contact.geom[contact]]
        if frozenset(model.body(body).name for body in bodies) not in apart:
            return True
    return False


def _at(model: Any, facts: JointFacts, values: Array) -> Any:
    data = mujoco.MjData(model)
    for name, value in zip(facts.joints, values, strict=True):
        data.joint(name).qpos[0] = value
    mujoco.mj_forward(model, data)
    return data
