"""A world as it is drawn, at its start, as plain data: whoever has it needs none of its large meshes again."""

from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from onika.laws.chain import text_of
from onika.laws.frames import quaternion_of_rotation
from onika.workcell.plant import Plant
from onika.workcell.scene import Shape3d, looked_at
from onika.workcell.view import CAMERA


@dataclass(frozen=True, slots=True)
class Material:
    """How something reflects; colours are those of shapes."""

    name: str
    specular: float
    shininess: float


@dataclass(frozen=True, slots=True)
class Drawing:
    """What there is to draw; `eye` is the camera of a model that is there for pictures, in MJCF, empty without one."""

    shapes: tuple[Shape3d, ...]
    materials: tuple[Material, ...]
    eye: str


def drawing(plant: Plant) -> Drawing:
    """What there is to draw of a world that was compiled to be drawn."""
    model: Any = plant.model
    materials = (
        Material(model.material(k).name, float(model.mat_specular[k]), float(model.mat_shininess[k]))
        for k in range(model.nmat)
    )
    return Drawing(tuple(looked_at(plant)), tuple(materials), _eye(plant))


def _eye(plant: Plant) -> str:
    model: Any = plant.model
    eyes = [k for k in range(model.ncam) if model.camera(k).name.rpartition(".")[2] == CAMERA]
    if not eyes:
        return ""
    mujoco.mj_kinematics(model, plant.data)
    mujoco.mj_camlight(model, plant.data)
    place, turn = plant.data.cam_xpos[eyes[0]], plant.data.cam_xmat[eyes[0]].reshape(3, 3)
    return (
        f'<camera name="{CAMERA}" pos="{text_of(place)}" quat="{text_of(quaternion_of_rotation(turn))}" '
        f'fovy="{float(np.ravel(model.cam_fovy)[eyes[0]])}"/>'
    )
