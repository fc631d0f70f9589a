"""How a camera that looks along its tool moves, so that a point of its picture comes to another place in it."""

import math
from collections import deque

import numpy as np

from onika.laws.frames import Array

_REMEMBERED_S = 2.0


class ImageServo:
    """Proportional in the picture, with what the camera has moved since the picture was taken counted in.

    focal    pixels from the middle of the picture to what is seen at 45 degrees
    depth    how far away the point is, about (m)
    gain     by how much of the way it comes nearer in a second (1/s)
    turn     how far the right of the picture is turned from x of the tool, about its approach (rad)
    speed    highest speed (m/s); `rise` is how fast it may change (m/s2)

    The camera moves in the plane of its picture and does not turn (Chaumette & Hutchinson 2006, with one point).
    """

    def __init__(self, focal: float, depth: float, gain: float, turn: float, speed: float, rise: float) -> None:
        self._metres = depth / focal
        self._gain, self._speed, self._rise = gain, speed, rise
        cos, sin = math.cos(turn), math.sin(turn)
        self._turned = np.array(((cos, -sin), (sin, cos)))
        self._past: deque[tuple[float, Array]] = deque()
        self._way = np.zeros(2)
        self._velocity = np.zeros(2)
        self._error = np.zeros(2)
        self._origin = np.zeros(2)

    def see(self, error: Array, taken: float) -> None:
        """In a picture of the time `taken` (s) the point was so far (px) from where it is to come."""
        self._error = np.array(error, dtype=np.float64)
        self._origin = self._past[0][1] if self._past else self._way.copy()
        for time, way in self._past:
            if time > taken:
                break
            self._origin = way

    def lose(self) -> None:
        """The point is not seen: come to rest."""
        self._error[:] = 0.0
        self._origin = self._way.copy()

    def move(self, now: float, dt: float) -> Array:
        """The speed along x and y of the tool for the next `dt` seconds (m/s)."""
        left = self._error * self._metres - (self._way - self._origin)
        wanted = self._gain * left
        size = float(np.linalg.norm(wanted))
        wanted *= min(1.0, self._speed / size) if size else 1.0
        change = wanted - self._velocity
        most = self._rise * dt
        size = float(np.linalg.norm(change))
        self._velocity = self._velocity + change * (min(1.0, most / size) if size else 1.0)
        self._past.append((now, self._way.copy()))
        while self._past[0][0] < now - _REMEMBERED_S:
            self._past.popleft()
        self._way = self._way + dt * self._velocity
        along: Array = self._turned @ self._velocity
        return along
