"""Joint motions of limited jerk, by Ruckig: as quick as speeds, accelerations and jerks allow."""

import numpy as np
import ruckig

from onika.laws.frames import Array, Numbers


class JerkLimited:
    """The quickest motion of n joints from rest at `start` to rest at `end` within the limits; all end together.

    `speed`, `acceleration` and `jerk` double[n] are the limits (rad or m, per s, s^2, s^3), all above 0; `least` is how
    many seconds it takes at least (Berscheid & Kröger, Jerk-limited Real-time Trajectory Generation, 2021).
    """

    def __init__(
        self, start: Numbers, end: Numbers, speed: Numbers, acceleration: Numbers, jerk: Numbers, least: float
    ) -> None:
        wish = ruckig.InputParameter(len(start))
        wish.current_position, wish.target_position = _plain(start), _plain(end)
        wish.max_velocity, wish.max_acceleration, wish.max_jerk = _plain(speed), _plain(acceleration), _plain(jerk)
        wish.minimum_duration = least
        self._course = ruckig.Trajectory(len(start))
        ruckig.Ruckig(len(start)).calculate(wish, self._course)
        self.duration = float(self._course.duration)
        """Seconds that it takes."""

    def at(self, t: float) -> tuple[Array, Array, Array]:
        """Position, speed and acceleration double[n] at t in s; before 0 and after its duration it rests."""
        place, speed, acceleration = self._course.at_time(min(max(t, 0.0), self.duration))[:3]
        return np.array(place), np.array(speed), np.array(acceleration)


def _plain(numbers: Numbers) -> list[float]:
    return [float(number) for number in numbers]
