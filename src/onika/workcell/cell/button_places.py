"""Where the buttons of a world stand, for whoever draws it; they have no shape (X19).

Panic buttons stand at the right hand of the robot that they stop, switches that a hand touches at the left hand of the
first one.
"""

from collections import Counter
from collections.abc import Mapping
from math import cos, radians, sin
from typing import Any

import numpy as np

from onika.model.world import PlaceBlock, Spot, WorldText

_BESIDE_M = 0.3
"""So far from the middle of the place; to the other side if negative."""

_APART_M = 0.12
"""From one button of a place to the next."""

Place = tuple[float, float, float]


def button_places(world: WorldText, data: Any) -> Mapping[str, Place]:
    """The place of each button and touched switch, x, y, z (m), with the data of the world's physics."""
    places = {place.name: place for place in world.places}
    there: Counter[str] = Counter()
    found: dict[str, Place] = {}
    for button in world.buttons:
        stopped = next((places[name] for name in button.stops if name in places), None)
        if stopped is not None:
            found[button.name] = _beside(stopped, data, _BESIDE_M + _APART_M * there[stopped.name])
            there[stopped.name] += 1
    touched = [switch.name for switch in world.switches if switch.is_touched and world.places]
    for number, name in enumerate(touched):
        found[name] = _beside(world.places[0], data, -_BESIDE_M - _APART_M * number)
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
