"""The Adept One-like SCARA as a kind of arm: a stout column, two flat arms, a quill that slides through the second."""

from onika.laws import adept_one
from onika.workcell.arm import SHOULDER_M, ArmKind, capsule, rod
from onika.workcell.part import TouchSpot

_INNER, _OUTER = float(adept_one.DH[0, 0]), float(adept_one.DH[1, 0])
_PLANE_M = float(adept_one.DH[0, 2])
"""Height of both arms above frame 0."""

_QUILL_M = 0.52
"""Length of the quill; drawn up, it stands out above the arm."""


def _column(drawn: bool, touch: TouchSpot) -> str:
    """From the floor to under the first arm."""
    if not drawn:
        half = (SHOULDER_M + _PLANE_M - 0.07) / 2
        return f'<geom type="cylinder" size="0.10 {half}" pos="0 0 {half - SHOULDER_M}" {touch}/>'
    foot, top = -SHOULDER_M, _PLANE_M - 0.06
    return (
        rod(0, 0, foot, 0, 0, foot + 0.024, 0.19, "dark")
        + rod(0, 0, foot + 0.024, 0, 0, top - 0.22, 0.11, "slate")
        + rod(0, 0, top - 0.22, 0, 0, top - 0.19, 0.118, "orange")
        + rod(0, 0, top - 0.19, 0, 0, top, 0.105, "cream")
    )


def _touching(touch: TouchSpot) -> tuple[str, ...]:
    """The shapes of each link that touch, in the frame of the link."""
    return (
        f'<geom type="capsule" size="0.06" fromto="{-_INNER} 0 0 0 0 0" {touch}/>',
        f'<geom type="capsule" size="0.055" fromto="{-_OUTER} 0 0 0 0 0" {touch}/>',
        f'<geom type="capsule" size="0.022" fromto="0 0 {-_QUILL_M} 0 0 -0.03" {touch}/>',
        "",
    )


def _drawn() -> tuple[str, ...]:
    """The shapes of each link that are looked at; z of frame 1 points up, that of the others down."""
    return (
        rod(-_INNER, 0, -0.058, -_INNER, 0, 0.06, 0.098, "cream")
        + f'<geom type="box" size="{_INNER / 2} 0.068 0.05" pos="{-_INNER / 2} 0 0.004" material="cream"/>'
        + rod(-_INNER, 0, 0.06, -_INNER, 0, 0.074, 0.07, "orange")
        + rod(0, 0, -0.046, 0, 0, 0.054, 0.082, "cream"),
        rod(-_OUTER, 0, -0.12, -_OUTER, 0, -0.054, 0.074, "orange")
        + f'<geom type="box" size="{_OUTER / 2} 0.056 0.032" pos="{-_OUTER / 2} 0 -0.088" material="cream"/>'
        + rod(0, 0, -0.13, 0, 0, 0.02, 0.06, "cream")
        + rod(0, 0, 0.02, 0, 0, 0.032, 0.04, "orange")
        + capsule(-_OUTER * 0.72, 0, -0.125, -_OUTER * 0.3, 0, -0.125, 0.032, "slate"),
        rod(0, 0, -_QUILL_M, 0, 0, -0.03, 0.02, "steel") + rod(0, 0, -_QUILL_M, 0, 0, -_QUILL_M + 0.02, 0.026, "dark"),
        rod(0, 0, -0.04, 0, 0, -0.008, 0.032, "orange") + rod(0, 0, -0.008, 0, 0, 0, 0.04, "steel"),
    )


SCARA = ArmKind(adept_one, _touching, _drawn, _column)
