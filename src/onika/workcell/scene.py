"""A scene: the shapes of a world as plain data, sent once to whoever draws it; poses follow for each picture."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np
import numpy.typing as npt

from onika.laws.mesh import mesh_name
from onika.workcell.plant import Plant

BULB, GLOW = "glass", "glow"
"""Paints by which whoever draws a scene knows what shines with a lamp, and the light in the air about it."""

_TOUCHING = 3  # the first group of shapes that are not seen


@dataclass(frozen=True, slots=True)
class Shape3d:
    """One shape on a body: its kind, half sizes and place in the body's frame (m), quaternion (w, x, y, z), colour.

    Half sizes: box x y z; sphere r; cylinder and capsule r, half length along z; ellipsoid the three radii; plane x y
    (0 is endless). Size and place of a mesh are those of the box around it, and what stands within is named by `mesh`.
    Bodies are numbered as the rows of poses; body 0 is the world.
    """

    name: str
    body: int
    kind: str
    size: tuple[float, ...]
    position: tuple[float, ...]
    quaternion: tuple[float, ...]
    rgba: tuple[float, ...]
    paint: str
    hinge: "Hinge3d | None" = None
    """How its body moves against the one that carries it, told once for each body; None: not here, or it is free."""
    mesh: str = ""
    """What `mesh.mesh_name` calls the mesh; empty where it is none."""


@dataclass(frozen=True, slots=True)
class Hinge3d:
    """A body in the frame of the body that carries it, where its joint is at 0: place (m) and quaternion (w, x, y, z).

    The joint turns it about `axis` through `anchor`, both in the body's own frame, or moves it along the axis. A body
    without a joint has no name for one.
    """

    carrier: int
    position: tuple[float, ...]
    quaternion: tuple[float, ...]
    joint: str = ""
    slides: bool = False
    axis: tuple[float, ...] = (0.0, 0.0, 1.0)
    anchor: tuple[float, ...] = (0.0, 0.0, 0.0)


def looked_at(plant: Plant) -> list[Shape3d]:
    """The shapes of a world that are there to be seen: of a body that has such, those that only touch are left out.

    In models of others, shapes of groups 0 to 2 are seen, and those above only touch. Some tell both apart below that:
    where a body has shapes that touch nothing, those that do and are of another group stand for its contact alone.
    """
    return _shapes(plant.model, looked_at_numbers(plant.model))


def looked_at_numbers(model: Any) -> list[int]:
    """The numbers of these shapes."""
    groups, bodies = np.ravel(model.geom_group).tolist(), np.ravel(model.geom_bodyid).tolist()
    touches = np.ravel((model.geom_contype != 0) | (model.geom_conaffinity != 0)).tolist()
    seen = [k for k in range(model.ngeom) if groups[k] < _TOUCHING]
    plain: dict[int, set[int]] = {}
    for k in (k for k in seen if not touches[k]):
        plain.setdefault(bodies[k], set()).add(groups[k])
    has_seen = {bodies[k] for k in seen}
    is_looked_at = {k for k in seen if not touches[k] or groups[k] in plain.get(bodies[k], {groups[k]})}
    return [k for k in range(model.ngeom) if k in is_looked_at or bodies[k] not in has_seen]


def _shapes(model: Any, numbers: Sequence[int]) -> list[Shape3d]:
    firsts: dict[int, int] = {}
    for k in numbers:
        firsts.setdefault(int(model.geom_bodyid[k]), k)
    names = {number: mesh_name(*mesh_of(model, number)) for number in {mesh_number(model, k) for k in numbers} - {-1}}
    return [_shape(model, k, names, is_first=firsts[int(model.geom_bodyid[k])] == k) for k in numbers]


def mesh_number(model: Any, k: int) -> int:
    """The number of the mesh that a shape is made of; -1: of none."""
    is_mesh = int(model.geom_type[k]) == int(mujoco.mjtGeom.mjGEOM_MESH)
    return int(model.geom_dataid[k]) if is_mesh else -1


def mesh_of(model: Any, number: int) -> tuple[npt.NDArray[np.float32], npt.NDArray[np.int32]]:
    """The corners of a mesh in the frame of its shapes, float32[n,3], and its triangles, int32[m,3]."""
    first, face = int(model.mesh_vertadr[number]), int(model.mesh_faceadr[number])
    corners = model.mesh_vert[first : first + int(model.mesh_vertnum[number])]
    triangles = model.mesh_face[face : face + int(model.mesh_facenum[number])]
    return corners.reshape(-1, 3), triangles.reshape(-1, 3)


def box_around(model: Any, k: int, edge: int) -> npt.NDArray[np.float64]:
    """Points on the box around a shape, `edge` along each edge, in the shape's frame: float64[n,3] (m)."""
    line = np.linspace(-1.0, 1.0, edge)
    grid = np.array(np.meshgrid(line, line, line)).reshape(3, -1).T
    outside = grid[np.abs(grid).max(axis=1) == 1.0]
    return np.asarray(model.geom_aabb[k][:3] + outside * model.geom_aabb[k][3:])


def _shape(model: Any, k: int, meshes: Mapping[int, str], *, is_first: bool) -> Shape3d:
    body, material = int(model.geom_bodyid[k]), int(model.geom_matid[k])
    rgba = model.geom_rgba[k] if material < 0 else model.mat_rgba[material]
    return Shape3d(
        model.geom(k).name,
        body,
        *_form(model, k),
        tuple(rgba.tolist()),
        model.material(material).name if material >= 0 else "",
        _hinge(model, body) if is_first else None,
        meshes.get(mesh_number(model, k), ""),
    )


def _form(model: Any, k: int) -> tuple[str, tuple[float, ...], tuple[float, ...], tuple[float, ...]]:
    """Kind, half sizes, place and quaternion; of a mesh those of the box around it."""
    kind = mujoco.mjtGeom(int(model.geom_type[k]))
    size, place = model.geom_size[k], model.geom_pos[k]
    if kind == mujoco.mjtGeom.mjGEOM_MESH:
        turn, middle = np.zeros(9), model.geom_aabb[k][:3]
        mujoco.mju_quat2Mat(turn, model.geom_quat[k])
        size, place = model.geom_aabb[k][3:], place + turn.reshape(3, 3) @ middle
    name = kind.name.removeprefix("mjGEOM_").lower()
    return name, tuple(size.tolist()), tuple(place.tolist()), tuple(model.geom_quat[k].tolist())


def _hinge(model: Any, body: int) -> Hinge3d | None:
    carrier, first, count = int(model.body_parentid[body]), int(model.body_jntadr[body]), int(model.body_jntnum[body])
    if body == 0 or count > 1:
        return None
    place = tuple(model.body_pos[body].tolist()), tuple(model.body_quat[body].tolist())
    if count == 0:
        return Hinge3d(carrier, *place)
    kind = mujoco.mjtJoint(int(model.jnt_type[first]))
    if kind not in (mujoco.mjtJoint.mjJNT_HINGE, mujoco.mjtJoint.mjJNT_SLIDE):
        return None
    return Hinge3d(
        carrier,
        *place,
        model.joint(first).name,
        kind == mujoco.mjtJoint.mjJNT_SLIDE,
        tuple(model.jnt_axis[first].tolist()),
        tuple(model.jnt_pos[first].tolist()),
    )
