"""A document of one instant of a world, to be drawn elsewhere without its files: shapes where they are, no joints.

Materials keep their gloss. The floor is paper with faint lines. A camera `picture` of a model is where it is seen from;
else it is seen whole.
"""

from collections.abc import Collection, Iterator

import numpy as np
import numpy.typing as npt

from onika.laws.chain import text_of
from onika.workcell.composed.drawing import Drawing
from onika.workcell.scene import Shape3d
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
_GLOWING = (1.0, 0.80, 0.25)
_FLOOR = (
    '<texture name="tiles" type="2d" builtin="flat" mark="edge" rgb1="1 1 1" rgb2="1 1 1" markrgb="0.93 0.915 0.88" '
    'width="512" height="512"/><material name="tiles" texture="tiles" texrepeat="3.3 3.3" texuniform="true" '
    'specular="0" shininess="0" emission="0.10"/>'
)
_BULB_LIGHT = (
    'dir="0 0 -1" cutoff="180" castshadow="false" attenuation="0.4 6 60" diffuse="1 0.78 0.3" '
    'specular="0.3 0.25 0.1" ambient="0 0 0"'
)
"""What a lamp that glows throws on what is about it."""
_TOWARDS = np.array((-0.55, -0.75, 0.38))
"""From the middle of a world to the eye."""


def still(
    drawn: Drawing,
    poses: npt.NDArray[np.float32],
    lit: Collection[str],
    glowing: Collection[str] = (),
    unlit: Collection[str] = (),
) -> str:
    """The document in MJCF; `poses` float32[bodies,7] as `World.poses` has them.

    lit, glowing, unlit     shapes that shine; shapes of the light in the air, and those of lamps that are dark
    """
    rows = [row for row in drawn.shapes if row.name not in unlit]
    colours = dict.fromkeys(lit, _SHINING) | dict(_glow(glowing))
    bodies = [
        f'<body pos="{text_of(pose[:3])}" quat="{text_of(pose[3:])}">{_geoms(rows, number, colours)}'
        f"{_lamp(rows, number, glowing)}</body>"
        for number, pose in enumerate(poses.astype(float))
        if number
    ]
    sky = _SKY.replace("</asset>", f"{_FLOOR}{_materials(drawn)}</asset>")
    return (
        f"<mujoco>{LOOK}{sky}<worldbody>{_LIGHT}{drawn.eye or _camera(poses.astype(float))}"
        f"{_geoms(rows, 0, colours)}{''.join(bodies)}</worldbody></mujoco>"
    )


def _glow(glowing: Collection[str]) -> Iterator[tuple[str, str]]:
    """The innermost is the brightest."""
    for number, name in enumerate(glowing):
        yield name, text_of((*_GLOWING, 0.30 / (number + 1)))


def _lamp(rows: list[Shape3d], body: int, glowing: Collection[str]) -> str:
    first = next((row for row in rows if row.body == body and row.name in glowing), None)
    return "" if first is None else f'<light pos="{text_of(first.position)}" {_BULB_LIGHT}/>'


def _materials(drawn: Drawing) -> str:
    """How they reflect; colours are those of the shapes."""
    return "".join(
        f'<material name="{each.name}" specular="{each.specular:.4g}" shininess="{each.shininess:.4g}"/>'
        for each in drawn.materials
    )


def _geoms(rows: list[Shape3d], body: int, colours: dict[str, str]) -> str:
    return "".join(_geom(row, colours.get(row.name)) for row in rows if row.body == body)


def _geom(row: Shape3d, shining: str | None) -> str:
    colour = shining or text_of(row.rgba)
    size = "0 0 0.05" if row.kind == "plane" else text_of(tuple(max(part, 1e-4) for part in row.size))
    place = f'pos="{text_of(row.position)}" quat="{text_of(row.quaternion)}"'
    kind = "box" if row.kind == "mesh" else row.kind
    paint = "tiles" if row.kind == "plane" else "" if shining else row.paint
    material = f'material="{paint}" ' if paint else ""
    return f'<geom type="{kind}" size="{size}" {place} {material}rgba="{colour}" contype="0" conaffinity="0"/>'


def _camera(poses: npt.NDArray[np.float64]) -> str:
    """An eye that sees all bodies."""
    places = poses[1:, :3] if len(poses) > 1 else poses[:, :3]
    middle = (places.min(axis=0) + places.max(axis=0)) / 2.0
    far = 2.2 * max(float(np.linalg.norm(np.ptp(places, axis=0))), 0.6)
    back = _TOWARDS / np.linalg.norm(_TOWARDS)
    right = np.cross((0.0, 0.0, 1.0), back)
    axes = f"{text_of(right)} {text_of(np.cross(back, right))}"
    return f'<camera name="{CAMERA}" pos="{text_of(middle + far * back)}" xyaxes="{axes}"/>'
