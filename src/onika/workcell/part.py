"""A part of a workcell, written in MJCF; a world is a row of parts put into one document.

A part is written twice from the same numbers: as physics sees it (`drawn` false: the shapes that touch) and as people
see it (`drawn` true: the shapes that are looked at). Bodies, joints and their order are the same in both, so that one
set of joint positions places either.
"""

from collections.abc import Iterable
from dataclasses import dataclass

from onika.laws.chain import text_of
from onika.laws.frames import Array, quaternion_of_rotation

STEP_S = 0.002
"""The physical time step in seconds."""

GRAVITY = 9.81
"""Acceleration of free fall in m/s2."""


@dataclass(frozen=True, slots=True)
class WorldPart:
    """Elements to stand in the world body, among the assets, the actuators, the equalities and the sensors."""

    bodies: str = ""
    assets: str = ""
    actuators: str = ""
    equalities: str = ""
    sensors: str = ""


@dataclass(frozen=True, slots=True)
class TouchSpot:
    """Which shapes touch: two meet where one's `kinds` share a bit with the other's `meets`."""

    kinds: int
    meets: int

    def __str__(self) -> str:
        return f'contype="{self.kinds}" conaffinity="{self.meets}"'


THINGS = TouchSpot(1, 1)
ARMS = (TouchSpot(2, 5), TouchSpot(4, 3))
"""Tables and boxes touch everything; an arm touches things and the other arm, not itself."""


def document(name: str, parts: Iterable[WorldPart], look: str = "") -> str:
    """The MJCF document of a world of parts; `look` holds elements that only a picture needs."""
    rows = list(parts)
    return (
        f'<mujoco model="{name}"><compiler angle="radian" autolimits="true"/>'
        # sensors are asked when someone wants to know (Plant.sense), not at each step.
        # Newton converges where conjugate gradients let stacked boxes creep; the cone is the real one of friction
        f'<option timestep="{STEP_S}" gravity="0 0 -{GRAVITY}" solver="Newton" integrator="implicitfast" '
        'cone="elliptic" impratio="10" iterations="50"><flag sensor="disable"/></option>'
        f"{look}<asset>{''.join(part.assets for part in rows)}</asset>"
        f"<worldbody>{''.join(part.bodies for part in rows)}</worldbody>"
        f"<actuator>{''.join(part.actuators for part in rows)}</actuator>"
        f"<equality>{''.join(part.equalities for part in rows)}</equality>"
        f"<sensor>{''.join(part.sensors for part in rows)}</sensor></mujoco>"
    )


def placed(pose: Array) -> str:
    """The attributes `pos` and `quat` of a pose double[4,4]."""
    return f'pos="{text_of(pose[:3, 3])}" quat="{text_of(quaternion_of_rotation(pose[:3, :3]))}"'
