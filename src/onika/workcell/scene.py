"""A scene: the shapes of a world as plain data, sent once to whoever draws it; poses of bodies follow for each picture."""

from dataclasses import dataclass

import mujoco
import numpy as np

from onika.workcell.plant import Plant


@dataclass(frozen=True, slots=True)
class Shape3d:
    """One shape on a body: its kind, half sizes and place in the body's frame (m), quaternion (w, x, y, z), colour.

    Half sizes: box x y z; sphere r; cylinder and capsule r, half length along z; ellipsoid the three radii; plane x y (0 is
    endless). Bodies are numbered as the rows of poses; body 0 is the world.
    """

    name: str
    body: int
    kind: str
    size: tuple[float, float, float]
    position: tuple[float, float, float]
    quaternion: tuple[float, float, float, float]
    rgba: tuple[float, float, float, float]
    paint: str


def shapes(plant: Plant) -> list[Shape3d]:
    """All shapes of a drawn world, in MuJoCo's order."""
    return [_shape(plant, k) for k in range(plant.model.ngeom)]


def _shape(plant: Plant, k: int) -> Shape3d:
    model = plant.model
    paint = int(model.geom_matid[k])
    rgba = model.mat_rgba[paint] if paint >= 0 else model.geom_rgba[k]
    x, y, z = model.geom_size[k].tolist()
    return Shape3d(
        model.geom(k).name,
        int(model.geom_bodyid[k]),
        mujoco.mjtGeom(int(model.geom_type[k])).name.removeprefix("mjGEOM_").lower(),
        (x, y, z),
        _three(model.geom_pos[k]),
        (
            *(float(model.geom_quat[k, 0]), float(model.geom_quat[k, 1])),
            *(float(model.geom_quat[k, 2]), float(model.geom_quat[k, 3])),
        ),
        (float(rgba[0]), float(rgba[1]), float(rgba[2]), float(rgba[3])),
        model.material(paint).name if paint >= 0 else "",
    )


def _three(row: np.ndarray) -> tuple[float, float, float]:
    return float(row[0]), float(row[1]), float(row[2])
