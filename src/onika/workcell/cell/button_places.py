"""Where the panic buttons of a world stand, for whoever draws it: beside what they stop; they have no shape (X19)."""

from collections import Counter
from collections.abc import Mapping
from math import cos, radians, sin
from typing import Any

import numpy as np

from onika.model.world import PlaceBlock, Spot, WorldText

_BESIDE_M = 0.3
"""So far from the middle of the first place that it stops, at the right hand of the robot there."""

_APART_M = 0.12
"""From one button of a place to the next."""

Place = tuple[float, float, float]


def button_places(world: WorldText, data: Any) -> Mapping[str, Place]:
    """The place of each panic button, x, y, z (m), with the data of the world's physics."""
    places = {place.name: place for place in world.places}
    there: Counter[str] = Counter()
    found: dict[str, Place] = {}
    for button in world.buttons:
        stopped = next((places[name] for name in button.stops if name in places), None)
        if stopped is not None:
            found[button.name] = _beside(stopped, data, _BESIDE_M + _APART_M * there[stopped.name])
            there[stopped.name] += 1
    return found


def _beside(place: PlaceBlock, data: Any, far: float) -> Place:
    middle, turn = _stand(place.spot, data)
    right = np.array([sin(turn), -cos(turn), 0.0])
    x, y, z = (round(float(number), 4) for number in middle + far * right)
    return x, y, z


def _stand(spot: Spot, data: Any) -> tuple[Any, float]:
    """Where a spot is in the world (m), and how it is turned about z (rad)."""
    x, y, z, turn = spot.at
    if not spot.on:
        return np.array([x, y, z]), radians(turn)
    site = data.site(spot.on)
    frame = site.xmat.reshape(3, 3)
    return site.xpos + frame @ np.array([x, y, z]), float(np.arctan2(frame[1, 0], frame[0, 0])) + radians(turn)
