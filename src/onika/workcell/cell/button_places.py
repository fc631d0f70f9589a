"""Where the buttons of a world stand, for whoever draws it; they have no shape (X19).

Panic buttons stand at the right hand of the robot that they stop, switches that a hand touches at the left hand of the
first one, and where something stands, beside it. They are as high as their robot, on a post where nothing is there.
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

Place = tuple[float, float, float, float]
"""Where a button is, x y z, and how high what its post stands on (m)."""

_RADIUS_M, _HEIGHT_M = 0.05, 0.06
"""What a button takes up."""

_EVEN_M = 0.01
"""What stands so little above the stand of its robot is even with it."""

_STEP_M, _FAR_M = 0.05, 3.0
"""Where something stands in its way a button goes on by such steps, and not further than that."""


def button_places(world: WorldText, model: Any, data: Any) -> Mapping[str, Place]:
    """The place of each button and touched switch, with the world's physics as it stands.

    They stand beside what does not move. In a world without robots they stand about its middle, on the floor.
    """
    places = {place.name: place for place in world.places}
    still = _Still(model, data, world.floor)
    row: Counter[str] = Counter()
    at: dict[str, Place] = {}
    for button in world.buttons:
        stopped = next((places[name] for name in button.stops if name in places), None)
        if stopped is not None:
            at[button.name] = still.beside(_stand(stopped.spot, data), _BESIDE_M + _APART_M * row[stopped.name])
            row[stopped.name] += 1
    first = _stand(world.places[0].spot, data) if world.places else (np.array([0.0, 0.0, world.floor or 0.0]), 0.0)
    for number, name in enumerate(switch.name for switch in world.switches if switch.is_touched):
        at[name] = still.beside(first, -_BESIDE_M - _APART_M * number)
    return at


class _Still:
    """Shapes that never move, by the lowest and highest corners of the boxes around them; `floor` None: no floor."""

    def __init__(self, model: Any, data: Any, floor: float | None) -> None:
        is_plane = model.geom_type == int(mujoco.mjtGeom.mjGEOM_PLANE)
        shapes = np.flatnonzero((model.body_weldid[model.geom_bodyid] == 0) & ~is_plane)
        turns = data.geom_xmat[shapes].reshape(-1, 3, 3)
        middle, half = model.geom_aabb[shapes, :3, None], model.geom_aabb[shapes, 3:, None]
        center = data.geom_xpos[shapes] + (turns @ middle)[:, :, 0]
        reach = (np.abs(turns) @ half)[:, :, 0]
        self._lowest, self._highest, self._floor = center - reach, center + reach, floor

    def beside(self, stand: tuple[Any, float], far: float) -> Place:
        """So far to the right of a stand, or to the left if negative, and further as long as something is there."""
        middle, turn = stand
        right = np.array([sin(turn), -cos(turn), 0.0])
        steps = np.copysign(np.arange(0.0, _FAR_M, _STEP_M), far)
        spots = (middle + (far + step) * right for step in steps)
        free = next((spot for spot in spots if not self._is_taken(spot)), middle + far * right)
        x, y, z, ground = (round(float(number), 4) for number in (*free, self._ground(free)))
        return x, y, z, ground

    def _ground(self, spot: Any) -> float:
        """How high what is below a spot is; where nothing is, the spot itself."""
        is_below = self._beneath(spot) & (self._highest[:, 2] <= spot[2] + _EVEN_M)
        heights = [*self._highest[is_below, 2].tolist(), *([] if self._floor is None else [self._floor])]
        return float(max((each for each in heights if each <= spot[2]), default=spot[2]))

    def _is_taken(self, spot: Any) -> bool:
        low, high = spot[2] + _EVEN_M, spot[2] + _HEIGHT_M
        return bool(np.any(self._beneath(spot) & (self._lowest[:, 2] < high) & (self._highest[:, 2] > low)))

    def _beneath(self, spot: Any) -> Any:
        """Which of them are below or above a button at this spot, or about it."""
        around = np.array([_RADIUS_M, _RADIUS_M])
        is_before = self._lowest[:, :2] < spot[:2] + around
        return np.all(is_before & (self._highest[:, :2] > spot[:2] - around), axis=1)


def _stand(spot: Spot, data: Any) -> tuple[Any, float]:
    """Where a spot is in the world (m), and how it is turned about z (rad)."""
    x, y, z, turn = spot.at
    if not spot.on:
        return np.array([x, y, z]), radians(turn)
    site = data.site(spot.on)
    frame = site.xmat.reshape(3, 3)
    return site.xpos + frame @ np.array([x, y, z]), float(np.arctan2(frame[1, 0], frame[0, 0])) + radians(turn)
