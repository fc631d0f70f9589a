"""The pneumatic two-finger hand as a part: two coupled fingers, one binary signal, the force of its cylinder.

Fingers slide along y of the flange's frame; their faces stand 30 to 56 mm from the middle; the point between the pads
is 130 mm beyond the flange, where the arm's TOOL is.
"""

from dataclasses import dataclass

from onika.laws import puma560
from onika.workcell.part import TouchSpot

CLOSED_M = 0.060
"""Distance of the pads with the hand closed; a finger at position 0."""

TRAVEL_M = 0.026
"""How far each finger slides."""

FORCE_N = 60.0
"""What the cylinder presses each finger with, once its valve has opened (first order, 30 ms)."""

_TIP = float(puma560.TOOL[2, 3])
_FINGER_KG = 0.14
_PALM_KG = float(puma560.LOAD[0]) - 2 * _FINGER_KG
_PALM_Z = (float(puma560.LOAD[0] * puma560.LOAD[3]) - 2 * _FINGER_KG * (_TIP - 0.01)) / _PALM_KG
_PAD = (0.014, 0.002, 0.015)  # half sizes: 28 mm along x, 4 mm thick, 30 mm along the approach


@dataclass(frozen=True, slots=True)
class GripperPart:
    """One hand by name; joints `name.finger1` (towards +y) and `name.finger2`."""

    name: str

    def body(self, touch: TouchSpot, drawn: bool) -> str:
        """The hand as a body to stand in the arm's last link."""
        shapes = _drawn_palm() if drawn else f'<geom type="box" size="0.03 0.062 0.02" pos="0 0 0.034" {touch}/>'
        fingers = self._finger(1, touch, drawn) + self._finger(2, touch, drawn)
        return (
            f'<body name="{self.name}.hand"><inertial pos="0 0 {_PALM_Z}" mass="{_PALM_KG}" '
            f'diaginertia="8e-4 4e-4 8e-4"/>{shapes}{fingers}</body>'
        )

    def actuators(self) -> str:
        """One cylinder to each finger; signal -1 closes, +1 opens."""
        return "".join(
            f'<general name="{self.name}.valve{k}" joint="{self.name}.finger{k}" ctrlrange="-1 1" '
            f'dyntype="filter" dynprm="0.03" gainprm="{FORCE_N}"/>'
            for k in (1, 2)
        )

    def equalities(self) -> str:
        """Both fingers go the same way: the hand centres itself."""
        return f'<joint joint1="{self.name}.finger1" joint2="{self.name}.finger2" polycoef="0 1 0 0 0"/>'

    def sensors(self) -> str:
        """How hard each pad is pressed."""
        return "".join(f'<touch name="{self.name}.touch{k}" site="{self.name}.pad{k}"/>' for k in (1, 2))

    def _finger(self, k: int, touch: TouchSpot, drawn: bool) -> str:
        side = 1 if k == 1 else -1
        face = side * CLOSED_M / 2
        shapes = _drawn_finger(side, face) if drawn else self._touching_finger(k, side, face, touch)
        return (
            f'<body name="{self.name}.finger{k}"><inertial pos="0 {face + side * 0.01} {_TIP - 0.01}" '
            f'mass="{_FINGER_KG}" diaginertia="6e-5 6e-5 2e-5"/>'
            f'<joint name="{self.name}.finger{k}" type="slide" axis="0 {side} 0" range="0 {TRAVEL_M}" '
            # firm stops: the usual soft ones give way 5 mm to the cylinder
            f'solreflimit="0.004 1" solimplimit="0.95 0.99 0.001" damping="150" armature="0.1"/>{shapes}</body>'
        )

    def _touching_finger(self, k: int, side: int, face: float, touch: TouchSpot) -> str:
        x, y, z = _PAD
        pad = f'pos="0 {face + side * y} {_TIP}"'
        return (
            f'<geom type="box" size="0.011 0.006 0.045" pos="0 {face + side * 0.0101} {_TIP - 0.03}" {touch}/>'
            f'<geom name="{self.name}.pad{k}" type="box" size="{x} {y} {z}" {pad} friction="1.2 0.01 0.001" condim="4" '
            f'solref="0.004 1" {touch}/>'
            f'<site name="{self.name}.pad{k}" type="box" size="{x + 0.003} {y + 0.003} {z + 0.003}" {pad}/>'
        )


def _drawn_palm() -> str:
    return (
        '<geom type="cylinder" size="0.03 0.007" pos="0 0 0.007" material="dark"/>'
        '<geom type="box" size="0.026 0.062 0.018" pos="0 0 0.032" material="slate"/>'
        '<geom type="box" size="0.02 0.092 0.006" pos="0 0 0.054" material="steel"/>'
    )


def _drawn_finger(side: int, face: float) -> str:
    x, y, z = _PAD
    return (
        f'<geom type="box" size="0.016 0.012 0.009" pos="0 {face + side * 0.0101} 0.066" material="dark"/>'
        f'<geom type="box" size="0.011 0.006 0.045" pos="0 {face + side * 0.0101} {_TIP - 0.03}" material="steel"/>'
        f'<geom type="box" size="{x} {y} {z}" pos="0 {face + side * y} {_TIP}" material="rubber"/>'
    )
