"""Where the buttons of a world stand, for whoever draws it; they have no shape (X19).

Panic buttons stand at the right hand of the robot that they stop, switches that a hand touches at the left hand of the
first one, and where something stands, beside it.
"""

from collections import Counter
from collections.abc import Mapping
from math import cos, radians, sin
from typing import Any

import mujoco
import numpy as np

from onika.model.world import Spot, WorldText

_BESIDE_M = 0.3
"""So far from the middle of the place; to the other side if negative."""

_APART_M = 0.12
"""From one button of a place to the next."""

Place = tuple[float, float, float]

_RADIUS_M, _HEIGHT_M = 0.05, 0.06
"""What a button takes up."""

_STEP_M, _FAR_M = 0.05, 3.0
"""Where something stands in its way a button goes on by such steps, and not further than that."""


def button_places(world: WorldText, model: Any, data: Any) -> Mapping[str, Place]:
    """The place of each button and touched switch, x, y, z (m), with the world's physics as it stands.

    They stand beside what does not move. In a world without robots they stand about its middle, on the floor.
    """
    places = {place.name: place for place in world.places}
    still = _still(model, data)
    row: Counter[str] = Counter()
    at: dict[str, Place] = {}
    for button in world.buttons:
        stopped = next((places[name] for name in button.stops if name in places), None)
        if stopped is not None:
            at[button.name] = _beside(_stand(stopped.spot, data), _BESIDE_M + _APART_M * row[stopped.name], still)
            row[stopped.name] += 1
    first = _stand(world.places[0].spot, data) if world.places else (np.array([0.0, 0.0, world.floor or 0.0]), 0.0)
    for number, name in enumerate(switch.name for switch in world.switches if switch.is_touched):
        at[name] = _beside(first, -_BESIDE_M - _APART_M * number, still)
    return at


def _beside(stand: tuple[Any, float], far: float, still: Any) -> Place:
    """So far to the right of a stand, or to the left if negative, and further as long as something is there."""
    middle, turn = stand
    right = np.array([sin(turn), -cos(turn), 0.0])
    steps = np.copysign(np.arange(0.0, _FAR_M, _STEP_M), far)
    spots = (middle + (far + step) * right for step in steps)
    free = next((spot for spot in spots if not _is_taken(spot, still)), middle + far * right)
    x, y, z = (round(float(number), 4) for number in free)
    return x, y, z


def _is_taken(spot: Any, still: Any) -> bool:
    lowest = spot + np.array([-_RADIUS_M, -_RADIUS_M, 0.01])  # a button stands on something
    highest = spot + np.array([_RADIUS_M, _RADIUS_M, _HEIGHT_M])
    return bool(np.any(np.all((still[0] < highest) & (still[1] > lowest), axis=1)))


def _still(model: Any, data: Any) -> Any:
    """The lowest and highest corners of the boxes around all shapes that never move, float64[2,shapes,3] (m)."""
    is_plane = model.geom_type == int(mujoco.mjtGeom.mjGEOM_PLANE)
    shapes = np.flatnonzero((model.body_weldid[model.geom_bodyid] == 0) & ~is_plane)
    turns = data.geom_xmat[shapes].reshape(-1, 3, 3)
    middle, half = model.geom_aabb[shapes, :3, None], model.geom_aabb[shapes, 3:, None]
    center = data.geom_xpos[shapes] + (turns @ middle)[:, :, 0]
    reach = (np.abs(turns) @ half)[:, :, 0]
    return np.stack((center - reach, center + reach))


def _stand(spot: Spot, data: Any) -> tuple[Any, float]:
    """Where a spot is in the world (m), and how it is turned about z (rad)."""
    x, y, z, turn = spot.at
    if not spot.on:
        return np.array([x, y, z]), radians(turn)
    site = data.site(spot.on)
    frame = site.xmat.reshape(3, 3)
    return site.xpos + frame @ np.array([x, y, z]), float(np.arctan2(frame[1, 0], frame[0, 0])) + radians(turn)
