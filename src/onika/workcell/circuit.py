"""The lamp's circuit: six contacts between the stacked boxes, closed by touch alone.

Between two boxes of the right order two metal feet of the upper one must stand within 6 mm of the brass patches of the
lower one that belong to them, and press them with more than 0.02 N. Six closed contacts light the lamp.
"""

import math
from itertools import pairwise

from onika.laws.frames import Array
from onika.workcell.box import METAL, PATCH_M, SIGNS
from onika.workcell.plant import Plant
from onika.workcell.unit import row_of

CLOSE_M = 2e-4
"""How near a foot must be to its patch, in height, to stand on it where there are no forces."""

PRESS_N = 0.02
"""Normal force from which on metal conducts."""

CONTACTS = len(METAL) * (len(SIGNS) - 1)
"""Number of contacts in the circuit, from the bottom up, plus before minus."""


class Circuit:
    """The circuit in one compiled world; it reads what `Plant.sense` felt after the last step."""

    def __init__(self, plant: Plant) -> None:
        # sites stand in the order of boxes: the patches of one, the feet of the next on it, that one's patches ...
        sites = [
            plant.site(f"box_{sign}.{what}_{tag}")
            for lower, upper in pairwise(SIGNS)
            for sign, what in ((lower, "patch"), (upper, "foot"))
            for tag, _, _ in METAL
        ]
        self._places: Array = plant.data.site_xpos[sites[0] : sites[-1] + 1]
        names = [f"box_{sign}.patch_{tag}" for sign in SIGNS[:-1] for tag, _, _ in METAL]
        self._presses = row_of(plant.data.sensordata[plant.sensors(names)])

    def press(self) -> None:
        """Where there are no forces: press each patch on which the foot that belongs to it stands, and no other."""
        places = self._places.tolist()
        for number in range(CONTACTS):
            k = 4 * (number // 2) + number % 2
            rests = abs(places[k][2] - places[k + 2][2]) <= CLOSE_M and math.dist(places[k], places[k + 2]) <= PATCH_M
            self._presses[number] = 2.0 * PRESS_N if rests else 0.0

    def scan(self, flags: Array) -> None:
        """Write 1.0 for each closed contact and 0.0 for each open one into `flags` double[6]."""
        flags[:] = 0.0
        pressed = [number for number, force in enumerate(self._presses) if force > PRESS_N]
        if not pressed:
            return
        places = self._places.tolist()
        for number in pressed:
            k = 4 * (number // 2) + number % 2
            if math.dist(places[k], places[k + 2]) <= PATCH_M:
                flags[number] = 1.0
