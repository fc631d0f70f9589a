"""A hand of one jaw that closes on what does not move: how far both are apart at their tips (requirement X19).

The hulls of both meet at the hinge, so the tip is looked at: where it meets the other one when closed, and how far that
point has gone away from there when open.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import mujoco
import numpy as np

from onika.laws.frames import Array
from onika.words.reason import Reason
from onika.workcell.drafting.draft_chain import DraftTool, below
from onika.workcell.scene import box_around, mesh_number, mesh_of

_OUTER = 0.85  # a share of the length of the jaw; its tip is what lies further out
_WIDEST_RAD = 1.0  # further open, jaws face nothing that could stand between them
_AMONG = 0.3  # a share of the way from the other one to the open jaw: where the middle of most things is
_MOST_POINTS = 3000
_GRID = 7  # points along the edge of a shape that is no mesh

Tried = Callable[[float], Any]
"""The data of a hand that has come to rest with a signal, its arm at home."""


@dataclass(frozen=True, slots=True)
class DraftJaw:
    """Signal and width (m) of both ends; in the world at home where its middle is (m), and the way it opens."""

    open: tuple[float, float]
    closed: tuple[float, float]
    middle: Array
    way: Array


def draft_jaw(model: Any, bearer: int, jaw: int, signals: Sequence[float], tried: Tried, *, is_servo: bool) -> DraftJaw:
    """The only moving body `jaw` of a hand whose other one belongs to the body `bearer`.

    signals     those with which it is closed and open
    is_servo    whether it stops between them with a signal between them
    """
    states = [(signal, tried(signal)) for signal in signals]
    (closing, closed), (opening, opened) = sorted(states, key=lambda each: _nearest(model, each[1], bearer, jaw)[0])
    _, tip, foot = _nearest(model, closed, bearer, jaw)
    own = closed.xmat[jaw].reshape(3, 3).T @ (tip - closed.xpos[jaw])
    share = _facing(model, opened, closed, int(model.body_jntadr[jaw]))
    way = _at(_between(model, closed, opened, share), jaw, own) - foot
    if is_servo:
        opening = round(closing + share * (opening - closing), 4)
    width = way if is_servo else _at(opened, jaw, own) - foot
    ends = [round(float(np.linalg.norm(apart)), 4) for apart in (width, tip - foot)]
    return DraftJaw((opening, ends[0]), (closing, ends[1]), foot + _AMONG * way, way)


def between_jaws(model: Any, data: Any, tool: DraftTool, jaw: DraftJaw) -> DraftTool:
    """A tool whose point is where the jaw takes things, and whose fingers lie along the way that it opens."""
    site = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SITE, tool.name)
    if site >= 0:
        place, frame = data.site_xpos[site], data.site_xmat[site]
    else:
        place, frame = data.body(tool.name).xpos, data.body(tool.name).xmat
    to_tool = frame.reshape(3, 3).T
    across = np.abs(to_tool @ jaw.way)
    across["xyz".index(tool.approach[-1])] = 0.0
    offset = np.round(to_tool @ (jaw.middle - place), 4)
    origin = Reason.of("workcell.draft_tool_jaw")
    return replace(tool, offset=tuple(offset.tolist()), fingers="xyz"[int(np.argmax(across))], origin=origin)


def _facing(model: Any, opened: Any, closed: Any, joint: int) -> float:
    """The share of its way which a jaw goes while it still faces the other one."""
    turned = abs(float(opened.qpos[model.jnt_qposadr[joint]] - closed.qpos[model.jnt_qposadr[joint]]))
    return min(1.0, _WIDEST_RAD / turned) if _is_hinge(model, joint) and turned else 1.0


def _between(model: Any, closed: Any, opened: Any, share: float) -> Any:
    """The data where all stands so far on the way from closed to open."""
    data = mujoco.MjData(model)
    data.qpos[:] = closed.qpos + share * (opened.qpos - closed.qpos)
    mujoco.mj_kinematics(model, data)
    return data


def _at(data: Any, body: int, own: Array) -> Array:
    """Where a point of a body is in the world."""
    place: Array = data.xpos[body] + data.xmat[body].reshape(3, 3) @ own
    return place


def _nearest(model: Any, data: Any, bearer: int, jaw: int) -> tuple[float, Array, Array]:
    """How far the tip of a jaw is from what does not move (m), and the points of both there, in the world."""
    moved, carried = below(model, jaw), below(model, bearer)
    tip = _tip(model, data, bearer, jaw, _points(model, data, moved))
    still = _points(model, data, [body for body in carried if body not in moved])
    around = np.argsort(np.linalg.norm(still - tip.mean(axis=0), axis=1))
    still, tip = still[around[:_MOST_POINTS]], tip[:: len(tip) // _MOST_POINTS + 1]
    apart = (tip**2).sum(axis=1)[:, None] + (still**2).sum(axis=1) - 2.0 * tip @ still.T
    at, other = np.unravel_index(int(np.argmin(apart)), apart.shape)
    return float(np.linalg.norm(tip[at] - still[other])), tip[at], still[other]


def _tip(model: Any, data: Any, bearer: int, jaw: int, points: Array) -> Array:
    """The outer of some points: far from the axis of a hinge, else from what bears the jaw."""
    joint = int(model.body_jntadr[jaw])
    if _is_hinge(model, joint):
        far = np.linalg.norm(np.cross(points - data.xanchor[joint], data.xaxis[joint]), axis=1)
    else:
        far = np.linalg.norm(points - data.xpos[bearer], axis=1)
    outer: Array = points[far >= _OUTER * far.max()]
    return outer


def _points(model: Any, data: Any, bodies: Sequence[int]) -> Array:
    """Points on the shapes of some bodies, in the world."""
    shapes = [k for k in range(model.ngeom) if int(model.geom_bodyid[k]) in bodies]
    turns = [data.geom_xmat[k].reshape(3, 3) for k in shapes]
    rows = [data.geom_xpos[k] + _own(model, k) @ turn.T for k, turn in zip(shapes, turns, strict=True)]
    return np.concatenate(rows) if rows else data.xpos[list(bodies)]


def _own(model: Any, k: int) -> Array:
    """Points on a shape in its own frame: the corners of a mesh, else a grid on the box around it."""
    mesh = mesh_number(model, k)
    if mesh >= 0:
        return np.asarray(mesh_of(model, mesh)[0], dtype=float)
    return box_around(model, k, _GRID)


def _is_hinge(model: Any, joint: int) -> bool:
    return int(model.jnt_type[joint]) == int(mujoco.mjtJoint.mjJNT_HINGE)
