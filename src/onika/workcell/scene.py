"""A scene: the shapes of a world as plain data, sent once to whoever draws it; poses follow for each picture."""

from dataclasses import dataclass
from typing import Any

import mujoco

from onika.workcell.plant import Plant


@dataclass(frozen=True, slots=True)
class Shape3d:
    """One shape on a body: its kind, half sizes and place in the body's frame (m), quaternion (w, x, y, z), colour.

    Half sizes: box x y z; sphere r; cylinder and capsule r, half length along z; ellipsoid the three radii; plane x y
    (0 is endless). Bodies are numbered as the rows of poses; body 0 is the world.
    """

    name: str
    body: int
    kind: str
    size: tuple[float, ...]
    position: tuple[float, ...]
    quaternion: tuple[float, ...]
    rgba: tuple[float, ...]
    paint: str


def shapes(plant: Plant) -> list[Shape3d]:
    """All shapes of a drawn world, in MuJoCo's order."""
    return [_shape(plant.model, k) for k in range(plant.model.ngeom)]


def _shape(model: Any, k: int) -> Shape3d:
    paint = model.material(int(model.geom_matid[k]))
    return Shape3d(
        model.geom(k).name,
        int(model.geom_bodyid[k]),
        mujoco.mjtGeom(int(model.geom_type[k])).name.removeprefix("mjGEOM_").lower(),
        tuple(model.geom_size[k].tolist()),
        tuple(model.geom_pos[k].tolist()),
        tuple(model.geom_quat[k].tolist()),
        tuple(paint.rgba.tolist()),
        paint.name,
    )
