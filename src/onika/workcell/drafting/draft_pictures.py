"""Small pictures of a robot in some postures, for icons of targets, drawn without graphics (requirements X19, B11).

Points of its shapes are seen from before, from the left and from above, in parallel; a cell shows the nearest one.
"""

from collections.abc import Sequence
from typing import Any

import mujoco
import numpy as np

from onika.laws.frames import Array
from onika.model.picture import BLACK, SIZE, framed
from onika.workcell.scene import box_around, looked_at_numbers, mesh_number, mesh_of

_ROOM = SIZE - 6  # cells that a robot takes up at most, beside the border and a line around it
_RIGHT = np.array([-0.5, 0.8660254, 0.0])
_UP = np.array([-0.2961981, -0.1710101, 0.9396926])
_NEAR = np.array([0.8137977, 0.4698463, 0.3420201])
_COLOURS = np.array(
    ((200, 40, 30), (40, 150, 60), (40, 80, 200), (240, 210, 50), (240, 140, 40), (140, 70, 170), (128, 128, 128))
)
"""Red, green and blue of the first colours of pictures, in their order."""
_WHITE, _GREY = "7", 6
_POINTS = 15_000  # of a mesh, about
_EDGE = 24  # points along the edge of a shape that is no mesh

Rows = tuple[str, ...]


def draft_pictures(model: Any, joints: Sequence[int], postures: Sequence[Array]) -> tuple[Rows, ...]:
    """A picture of each posture of these joints, all seen from the same place; none where there is nothing to see."""
    shapes = looked_at_numbers(model)
    own = {k: _points(model, k) for k in shapes}
    if not shapes:
        return ()
    seen = [_seen(model, joints, posture, own) for posture in postures]
    every = np.concatenate([points for there in seen for points in there])
    lowest, highest = every[:, :2].min(axis=0), every[:, :2].max(axis=0)
    cell = max(float((highest - lowest).max()), 1e-6) / (_ROOM - 1)
    middle, colours = (lowest + highest) / 2.0, [_colour(model, k) for k in shapes]
    return tuple(_rows([(points[:, :2] - middle) / cell for points in there], there, colours) for there in seen)


def _seen(model: Any, joints: Sequence[int], posture: Array, own: dict[int, Array]) -> list[Array]:
    """The points of each shape: to the right, up and towards who looks (m)."""
    data = mujoco.MjData(model)
    data.qpos[[int(model.jnt_qposadr[joint]) for joint in joints]] = posture
    mujoco.mj_kinematics(model, data)
    view = np.stack((_RIGHT, _UP, _NEAR), axis=1)
    return [(data.geom_xpos[k] + points @ data.geom_xmat[k].reshape(3, 3).T) @ view for k, points in own.items()]


def _rows(cells: Sequence[Array], points: Sequence[Array], colours: Sequence[str]) -> Rows:
    picture = np.full((SIZE, SIZE), _WHITE)
    at = np.concatenate([np.rint(np.array([0.5, 0.5]) * (SIZE - 1) + (1, -1) * cell).astype(int) for cell in cells])
    depth = np.concatenate([there[:, 2] for there in points])
    colour = np.concatenate([np.full(len(there), each) for there, each in zip(points, colours, strict=True)])
    order = np.argsort(depth, kind="stable")  # the nearest last
    picture[at[order, 1], at[order, 0]] = colour[order]
    is_robot = picture != _WHITE
    around = np.zeros_like(is_robot)
    for axis in (0, 1):
        for step in (-1, 1):
            around |= np.roll(is_robot, step, axis)
    picture[around & ~is_robot] = BLACK
    return framed(["".join(row) for row in picture]).rows


def _colour(model: Any, k: int) -> str:
    """The digit of the colour that is nearest to that of a shape; what is white becomes grey, to be seen."""
    material = int(model.geom_matid[k])
    rgb = 255.0 * np.asarray(model.geom_rgba[k] if material < 0 else model.mat_rgba[material])[:3]
    if rgb.max() - rgb.min() < 40.0:
        return str(_GREY)
    return str(int(np.argmin(np.linalg.norm(_COLOURS - rgb, axis=1))))


def _points(model: Any, k: int) -> Array:
    """Points on a shape in its own frame, so near to each other that no cell is left out."""
    mesh = mesh_number(model, k)
    if mesh < 0:
        return box_around(model, k, _EDGE)
    corners, triangles = mesh_of(model, mesh)
    edge = int(np.clip(np.sqrt(2.0 * _POINTS / max(len(triangles), 1)), 2, 40))
    shares = np.array([(a, b) for a in range(edge) for b in range(edge - a)]) / (edge - 1)
    weights = np.column_stack((shares, 1.0 - shares.sum(axis=1)))
    return np.asarray(np.einsum("pc,tcx->tpx", weights, corners[triangles].astype(float)).reshape(-1, 3))
