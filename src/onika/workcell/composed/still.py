"""A document of one instant of a world, to be drawn elsewhere without its files: shapes where they are, no joints."""

import numpy as np
import numpy.typing as npt

from onika.laws.chain import text_of
from onika.workcell.plant import Plant
from onika.workcell.scene import Shape3d, looked_at
from onika.workcell.view import CAMERA, LOOK

_LIGHT = (
    '<light pos="-0.4 -1.9 2.6" dir="0.38 0.95 -1.20" directional="true" diffuse="0.52 0.51 0.49"/>'
    '<light pos="2.8 -1.0 1.8" dir="-0.9 0.35 -0.6" directional="true" castshadow="false" diffuse="0.2 0.21 0.24"/>'
)
_SKY = (
    '<asset><texture type="skybox" builtin="gradient" rgb1="0.965 0.955 0.932" rgb2="0.972 0.963 0.942" '
    'width="64" height="384"/></asset>'
)
_SHINING = "1 0.95 0.7 1"
_TOWARDS = np.array((-0.55, -0.75, 0.38))
"""From the middle of a world to the eye."""


def still(drawn: Plant, poses: npt.NDArray[np.float32], lit: tuple[str, ...]) -> str:
    """The document in MJCF; `poses` float32[bodies,7] as `World.poses` has them."""
    rows = looked_at(drawn)
    bodies = [
        f'<body pos="{text_of(pose[:3])}" quat="{text_of(pose[3:])}">{_geoms(rows, number, lit)}</body>'
        for number, pose in enumerate(poses.astype(float))
        if number
    ]
    return (
        f"<mujoco>{LOOK}{_SKY}<worldbody>{_LIGHT}{_camera(poses.astype(float))}{_geoms(rows, 0, lit)}"
        f"{''.join(bodies)}</worldbody></mujoco>"
    )


def _geoms(rows: list[Shape3d], body: int, lit: tuple[str, ...]) -> str:
    return "".join(_geom(row, row.name in lit) for row in rows if row.body == body)


def _geom(row: Shape3d, is_lit: bool) -> str:
    colour = _SHINING if is_lit else text_of(row.rgba)
    size = "0 0 0.05" if row.kind == "plane" else text_of(tuple(max(part, 1e-4) for part in row.size))
    place = f'pos="{text_of(row.position)}" quat="{text_of(row.quaternion)}"'
    kind = "box" if row.kind == "mesh" else row.kind
    return f'<geom type="{kind}" size="{size}" {place} rgba="{colour}" contype="0" conaffinity="0"/>'


def _camera(poses: npt.NDArray[np.float64]) -> str:
    """An eye that sees all bodies."""
    places = poses[1:, :3] if len(poses) > 1 else poses[:, :3]
    middle = (places.min(axis=0) + places.max(axis=0)) / 2.0
    far = 2.2 * max(float(np.linalg.norm(np.ptp(places, axis=0))), 0.6)
    back = _TOWARDS / np.linalg.norm(_TOWARDS)
    right = np.cross((0.0, 0.0, 1.0), back)
    axes = f"{text_of(right)} {text_of(np.cross(back, right))}"
    return f'<camera name="{CAMERA}" pos="{text_of(middle + far * back)}" xyaxes="{axes}"/>'
