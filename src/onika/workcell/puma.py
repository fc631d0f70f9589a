"""The PUMA 560 as a part: its links from the table of constants, a column to stand on, a motor at each joint."""

import numpy as np

from onika.laws import puma560
from onika.laws.chain import Link, links, text_of
from onika.laws.frames import Array
from onika.workcell.gripper import Gripper
from onika.workcell.part import Part, Touch, placed

SHOULDER_M = 0.6718
"""Height of frame 0 above the floor."""

_HUB, _WIDE = 0.075, 0.055  # radii of the drawn upper arm at its ends and of the forearm


def arm(name: str, base: Array, touch: Touch, hand: Gripper, drawn: bool) -> Part:
    """An arm with joints `name.joint1` ..., frame 0 at `base` (pose in the world), carrying `hand`."""
    inner = hand.body(touch, drawn)
    shapes = _drawn() if drawn else _touching(touch)
    chain = links(puma560.DH, np.zeros(puma560.NDOF))
    for k in reversed(range(puma560.NDOF)):
        inner = _body(f"{name}.link{k + 1}", f"{name}.joint{k + 1}", k, chain[k], shapes[k] + inner)
    bodies = f'<body name="{name}.base" {placed(base)}>{_column(drawn, touch)}{inner}</body>'
    if drawn:
        return Part(bodies)
    return Part(
        bodies,
        actuators="".join(_motor(name, k) for k in range(puma560.NDOF)) + hand.actuators(),
        equalities=hand.equalities(),
        sensors=hand.sensors(),
    )


def _body(name: str, joint: str, k: int, link: Link, inner: str) -> str:
    row = puma560.DYN[k]
    return (
        f'<body name="{name}" pos="{text_of(link.position)}" quat="{text_of(link.quaternion)}">'
        f'<inertial pos="{text_of(row[1:4])}" mass="{float(row[0])}" diaginertia="{text_of(row[4:7])}"/>'
        f'<joint name="{joint}" type="hinge" axis="{text_of(link.axis)}" pos="{text_of(link.anchor)}" '
        f'range="{float(puma560.QMIN[k])} {float(puma560.QMAX[k])}" armature="{float(row[7])}" '
        f'damping="{float(row[8])}"/>{inner}</body>'
    )


def _motor(name: str, k: int) -> str:
    most = float(puma560.TAUMAX[k])
    return f'<motor name="{name}.motor{k + 1}" joint="{name}.joint{k + 1}" ctrlrange="{-most} {most}"/>'


def _column(drawn: bool, touch: Touch) -> str:
    if not drawn:
        half = (SHOULDER_M - 0.08) / 2
        return f'<geom type="cylinder" size="0.09 {half}" pos="0 0 {-0.08 - half}" {touch}/>'
    foot = -SHOULDER_M
    return (
        f'<geom type="cylinder" size="0.17 0.012" pos="0 0 {foot + 0.012}" material="dark"/>'
        f'<geom type="cylinder" size="0.085 0.255" pos="0 0 {foot + 0.267}" material="slate"/>'
        f'<geom type="cylinder" size="0.098 0.016" pos="0 0 {foot + 0.5}" material="dark"/>'
        f'<geom type="cylinder" size="0.092 0.04" pos="0 0 {foot + 0.556}" material="slate"/>'
    )


def _touching(touch: Touch) -> tuple[str, ...]:
    """The shapes of each link that touch, in the frame of the link: capsules round the long ones."""
    d4 = float(puma560.DH[3, 2])
    return (
        "",
        f'<geom type="capsule" size="0.065" fromto="{-float(puma560.DH[1, 0])} 0 0 0 0 0" {touch}/>',
        f'<geom type="capsule" size="0.05" fromto="0 0 0 0 0 {d4}" {touch}/>',
        "",
        f'<geom type="sphere" size="0.048" {touch}/>',
        "",
    )


def _drawn() -> tuple[str, ...]:
    """The shapes of each link that are looked at; z of frame 1 and 2 is the axis of joints 2 and 3."""
    a2, d2, d4 = float(puma560.DH[1, 0]), float(puma560.DH[1, 2]), float(puma560.DH[3, 2])
    return (
        '<geom type="cylinder" size="0.074 0.055" pos="0 0.04 0" euler="1.5707963 0 0" material="cream"/>'
        + _rod(0, 0, -0.075, 0, 0, d2 - 0.055, 0.082, "cream")
        + _rod(0, 0, -0.083, 0, 0, -0.075, 0.058, "orange"),
        _rod(-a2, 0, -0.055, -a2, 0, 0.055, _HUB + 0.012, "cream")
        + _rod(-a2, 0, 0.055, -a2, 0, 0.064, 0.052, "orange")
        + f'<geom type="box" size="{a2 / 2} 0.062 0.046" pos="{-a2 / 2} 0 0" material="cream"/>'
        + _rod(0, 0, -0.055, 0, 0, 0.055, 0.064, "cream")
        + _rod(0, 0, 0.055, 0, 0, 0.064, 0.042, "orange"),
        _rod(0, -0.062, 0, 0, 0.052, 0, _WIDE + 0.006, "cream")
        + _rod(0, -0.071, 0, 0, -0.062, 0, 0.04, "orange")
        + _capsule(0, 0, 0.02, 0, 0, 0.30, 0.048, "cream")
        + _capsule(0, 0, 0.2, 0, 0, d4 - 0.07, 0.041, "cream")
        + _rod(0, 0, d4 - 0.085, 0, 0, d4 - 0.05, 0.044, "orange"),
        _rod(0, 0, -0.045, 0, 0, 0.045, 0.036, "slate")
        + f'<geom type="box" size="0.03 0.025 0.03" pos="0 {0.03} 0" material="slate"/>',
        '<geom type="sphere" size="0.038" material="cream"/>' + _rod(0, 0, 0, 0, 0, 0.03, 0.03, "cream"),
        _rod(0, 0, -0.028, 0, 0, -0.006, 0.034, "orange") + _rod(0, 0, -0.008, 0, 0, 0, 0.04, "steel"),
    )


def _rod(x0: float, y0: float, z0: float, x1: float, y1: float, z1: float, radius: float, material: str) -> str:
    return f'<geom type="cylinder" size="{radius}" fromto="{x0} {y0} {z0} {x1} {y1} {z1}" material="{material}"/>'


def _capsule(x0: float, y0: float, z0: float, x1: float, y1: float, z1: float, radius: float, material: str) -> str:
    return f'<geom type="capsule" size="{radius}" fromto="{x0} {y0} {z0} {x1} {y1} {z1}" material="{material}"/>'
