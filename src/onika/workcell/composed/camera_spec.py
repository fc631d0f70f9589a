"""Cameras in the document of a world or robot: those that a file places are added, those of a model are found."""

import math
from collections.abc import Sequence
from typing import Any

import mujoco
import numpy as np

from onika.model.camera import CameraBlock

_PAPER = (0.97, 0.96, 0.94)
_PLACED = "camera."
"""Before the name of a camera that a file places."""


def add_cameras(spec: mujoco.MjSpec, cameras: Sequence[CameraBlock]) -> None:
    """Add the cameras that stand somewhere; one on a body that is not there is lacking."""
    for camera in cameras:
        bodies = [body for body in spec.bodies if body.name == camera.on] if camera.on else [spec.worldbody]
        if camera.at and bodies:
            bodies[0].add_camera(
                name=_PLACED + camera.name, pos=camera.at, quat=_towards(camera.at, camera.looks), fovy=camera.lens
            )


def eye_of(camera: CameraBlock) -> str:
    """What a camera is called in its document."""
    return _PLACED + camera.name if camera.at else camera.view or camera.name


def add_sky(spec: mujoco.MjSpec) -> None:
    """What is seen where nothing is: paper."""
    spec.add_texture(
        name="sky.paper",
        type=mujoco.mjtTexture.mjTEXTURE_SKYBOX,
        builtin=mujoco.mjtBuiltin.mjBUILTIN_GRADIENT,
        rgb1=_PAPER,
        rgb2=_PAPER,
        width=8,
        height=48,
    )


def lenses(model: Any) -> dict[str, float]:
    """How much each camera of a compiled model sees from below to above (degrees)."""
    return {model.camera(k).name: float(np.ravel(model.cam_fovy)[k]) for k in range(model.ncam)}


def is_placed(eye: str) -> bool:
    """Whether a file places this camera of a document, so that it is none of a model."""
    return f".{eye}".rpartition(".")[0].endswith(f".{_PLACED[:-1]}")


def focal_length(lens: float, height: int) -> float:
    """Pixels from the middle of a picture of this height to what is seen at 45 degrees, through this lens (degrees)."""
    return 0.5 * height / math.tan(0.5 * math.radians(lens))


def _towards(at: Sequence[float], looks: Sequence[float]) -> Any:
    """The turn of a camera that looks at a point: z points back, y up as far as that can be."""
    back = np.subtract(at, looks) / math.dist(at, looks)
    upright = (0.0, 0.0, 1.0) if abs(back[2]) < 0.999 else (0.0, 1.0, 0.0)
    right = np.cross(upright, back)
    right /= np.linalg.norm(right)
    turned, quaternion = np.stack((right, np.cross(back, right), back), axis=1), np.zeros(4)
    mujoco.mju_mat2Quat(quaternion, turned.ravel())
    return quaternion
