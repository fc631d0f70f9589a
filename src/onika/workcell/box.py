"""A box of the assembly as a part: blue, with a white sign, four feet, and contacts that carry the lamp's current.

Three by five inches and two high. On each box two feet across the diagonal are metal; the box below has brass patches
at the same places on its top. The last box carries the lamp.
"""

import math
from dataclasses import dataclass
from itertools import pairwise

from onika.workcell.part import THINGS, WorldPart

SIZE_M = (0.0762, 0.1270, 0.0508)
"""Width along x (the side the hand takes), depth along y, height with feet."""

MASS_KG = 0.25

FEET_M = (0.030, 0.055)
"""Places of the feet: plus and minus these on x and y."""

METAL = (("pp", 1, 1), ("mm", -1, -1))
"""The two metal feet and the patches that belong to them: name and signs of x and y."""

PATCH_M = 0.006
"""Radius of a brass patch."""

SIGNS = ("waves", "triangle", "square", "cross")
"""The boxes from the bottom of the stack to its top."""

GLOWS = 6
"""Shells of the glow about the lamp, `lamp.glow0` ...; invisible until the lamp is lit."""

_FEET = (*METAL, ("pm", 1, -1), ("mp", -1, 1))
_FOOT_M, _OUT_M = 0.004, 0.001  # radius of a foot, and how far it stands out below
_STROKE_M, _SUNK_M = 0.0034, 0.0024  # radius of a sign's strokes, and how deep their middle lies in the face

_Stroke = tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True)
class AssemblyBox:
    """One box by its sign, standing with the middle of its foot print at x, y on a table whose top is at z (metres)."""

    sign: str
    x: float
    y: float
    z: float

    @property
    def name(self) -> str:
        """The name of its body and of its free joint."""
        return f"box_{self.sign}"

    def part(self, drawn: bool) -> WorldPart:
        """The box with a free joint; shapes `box_x.slab` and `box_x.foot_pp` ... touch."""
        width, depth, height = (size / 2 for size in SIZE_M)
        lift, thick = _OUT_M / 2, height - _OUT_M / 2
        x2, y2, z2 = ((2 * half) ** 2 for half in (width, depth, height))
        inertia = " ".join(str(MASS_KG / 12 * sides) for sides in (y2 + z2, x2 + z2, x2 + y2))
        slab = f'type="box" size="{width} {depth} {thick}" pos="0 0 {lift}"'
        shapes = self._drawn(slab, height) if drawn else self._touching(slab, height)
        bodies = (
            f'<body name="{self.name}" pos="{self.x} {self.y} {self.z + height}"><freejoint name="{self.name}"/>'
            f'<inertial pos="0 0 0" mass="{MASS_KG}" diaginertia="{inertia}"/>{shapes}</body>'
        )
        if drawn or self.sign == SIGNS[-1]:
            return WorldPart(bodies)
        touch = (f"{self.name}.patch_{tag}" for tag, _, _ in METAL)
        return WorldPart(bodies, sensors="".join(f'<touch name="{patch}" site="{patch}"/>' for patch in touch))

    def _touching(self, slab: str, height: float) -> str:
        feel = 'condim="4" friction="0.6 0.01 0.001" solref="0.005 1" solimp="0.95 0.99 0.001"'
        feet = "".join(
            f'<geom name="{self.name}.foot_{tag}" type="sphere" size="{_FOOT_M}" '
            f'pos="{i * FEET_M[0]} {j * FEET_M[1]} {_FOOT_M - height}" {feel} {THINGS}/>'
            for tag, i, j in _FEET
        )
        feet += "".join(self._site(f"foot_{tag}", i, j, -height) for tag, i, j in METAL if self.sign != SIGNS[0])
        patches = "".join(self._site(f"patch_{tag}", i, j, height) for tag, i, j in METAL if self.sign != SIGNS[-1])
        return f'<geom name="{self.name}.slab" {slab} {feel} {THINGS}/>{feet}{patches}'

    def _site(self, name: str, i: int, j: int, z: float) -> str:
        place = f"{i * FEET_M[0]} {j * FEET_M[1]} {z}"
        return f'<site name="{self.name}.{name}" type="cylinder" size="{PATCH_M} 0.002" pos="{place}"/>'

    def _drawn(self, slab: str, height: float) -> str:
        feet = "".join(
            f'<geom type="sphere" size="{_FOOT_M}" pos="{i * FEET_M[0]} {j * FEET_M[1]} {_FOOT_M - height}" '
            f'material="{"brass" if (tag, i, j) in METAL else "rubber"}"/>'
            for tag, i, j in _FEET
        )
        top = self._drawn_lamp(height) if self.sign == SIGNS[-1] else self._drawn_patches(height)
        return f'<geom {slab} material="blue"/>{feet}{top}{_signs(self.sign)}'

    def _drawn_patches(self, height: float) -> str:
        places = (f"{i * FEET_M[0]} {j * FEET_M[1]} {height}" for _, i, j in METAL)
        return "".join(
            f'<geom type="cylinder" size="{PATCH_M} 0.0006" pos="{place}" material="brass"/>' for place in places
        )

    def _drawn_lamp(self, height: float) -> str:
        return (
            f'<geom type="cylinder" size="0.011 0.003" pos="0 0 {height + 0.003}" material="dark"/>'
            f'<geom name="lamp" type="ellipsoid" size="0.009 0.009 0.014" pos="0 0 {height + 0.008}" material="glass"/>'
            f"{''.join(self._glow(k, height + 0.011) for k in range(GLOWS))}"
            f'<light name="lamp" pos="0 0 {height + 0.03}" dir="0 0 -1" cutoff="180" active="false" castshadow="false" '
            f'attenuation="0.4 6 60" diffuse="1 0.78 0.3" specular="0.3 0.25 0.1" ambient="0 0 0"/>'
        )

    def _glow(self, k: int, z: float) -> str:
        return f'<geom name="lamp.glow{k}" type="sphere" size="{0.013 * 1.3**k}" pos="0 0 {z}" material="glow"/>'


def _wave(height: float) -> _Stroke:
    return tuple((x / 20 - 0.6, height + 0.14 * math.sin(x / 24 * 4 * math.pi)) for x in range(0, 25, 2))


_STROKES: dict[str, tuple[_Stroke, ...]] = {
    "waves": (_wave(0.28), _wave(-0.28)),
    "triangle": (((-0.6, -0.52), (0.0, 0.6), (0.6, -0.52), (-0.6, -0.52)),),
    "square": (((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5), (-0.5, -0.5)),),
    "cross": (((0.0, -0.62), (0.0, 0.62)), ((-0.62, 0.0), (0.62, 0.0))),
}


def _signs(sign: str) -> str:
    """The sign on the four sides and, where no lamp stands, the top: faces by middle, right and up."""
    width, depth, height = (size / 2 for size in SIZE_M)
    low = 0.0005
    faces = [
        ((0.0, -depth, low), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0), 0.024),
        ((0.0, depth, low), (-1.0, 0.0, 0.0), (0.0, 0.0, 1.0), 0.024),
        ((-width, 0.0, low), (0.0, -1.0, 0.0), (0.0, 0.0, 1.0), 0.024),
        ((width, 0.0, low), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), 0.024),
    ]
    if sign != SIGNS[-1]:
        faces.append(((0.0, 0.0, height), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), 0.034))
    return "".join(_on_face(stroke, *face) for face in faces for stroke in _STROKES[sign])


def _on_face(
    stroke: _Stroke,
    middle: tuple[float, float, float],
    right: tuple[float, float, float],
    up: tuple[float, float, float],
    scale: float,
) -> str:
    inward = tuple(right[(k + 2) % 3] * up[(k + 1) % 3] - right[(k + 1) % 3] * up[(k + 2) % 3] for k in range(3))
    points = [
        " ".join(f"{middle[k] + _SUNK_M * inward[k] + scale * (u * right[k] + v * up[k]):.5f}" for k in range(3))
        for u, v in stroke
    ]
    return "".join(
        f'<geom type="capsule" size="{_STROKE_M}" fromto="{start} {two}" material="white"/>'
        for start, two in pairwise(points)
    )
