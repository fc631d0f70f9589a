"""The PUMA 560 as a kind of arm: a column, a heavy upper arm, a forearm and a small wrist."""

from onika.laws import puma560
from onika.workcell.arm import SHOULDER_M, ArmKind, capsule, rod
from onika.workcell.part import TouchSpot

_HUB, _WIDE = 0.075, 0.055  # radii of the drawn upper arm at its ends and of the forearm


def _column(drawn: bool, touch: TouchSpot) -> str:
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


def _touching(touch: TouchSpot) -> tuple[str, ...]:
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
        + rod(0, 0, -0.075, 0, 0, d2 - 0.055, 0.082, "cream")
        + rod(0, 0, -0.083, 0, 0, -0.075, 0.058, "orange"),
        rod(-a2, 0, -0.055, -a2, 0, 0.055, _HUB + 0.012, "cream")
        + rod(-a2, 0, 0.055, -a2, 0, 0.064, 0.052, "orange")
        + f'<geom type="box" size="{a2 / 2} 0.062 0.046" pos="{-a2 / 2} 0 0" material="cream"/>'
        + rod(0, 0, -0.055, 0, 0, 0.055, 0.064, "cream")
        + rod(0, 0, 0.055, 0, 0, 0.064, 0.042, "orange"),
        rod(0, -0.062, 0, 0, 0.052, 0, _WIDE + 0.006, "cream")
        + rod(0, -0.071, 0, 0, -0.062, 0, 0.04, "orange")
        + capsule(0, 0, 0.02, 0, 0, 0.30, 0.048, "cream")
        + capsule(0, 0, 0.2, 0, 0, d4 - 0.07, 0.041, "cream")
        + rod(0, 0, d4 - 0.085, 0, 0, d4 - 0.05, 0.044, "orange"),
        rod(0, 0, -0.045, 0, 0, 0.045, 0.036, "slate")
        + f'<geom type="box" size="0.03 0.025 0.03" pos="0 {0.03} 0" material="slate"/>',
        '<geom type="sphere" size="0.038" material="cream"/>' + rod(0, 0, 0, 0, 0, 0.03, 0.03, "cream"),
        rod(0, 0, -0.028, 0, 0, -0.006, 0.034, "orange") + rod(0, 0, -0.008, 0, 0, 0, 0.04, "steel"),
    )


PUMA = ArmKind(puma560, _touching, _drawn, _column)
