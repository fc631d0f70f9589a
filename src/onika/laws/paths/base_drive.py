"""How a base drives to a place that has two wheels: it turns towards it, goes there, and turns as it is wanted."""

import math

import numpy as np

from onika.laws.frames import Array, Numbers
from onika.laws.planar import turn_to
from onika.laws.signals.limited_rate import LimitedRate

_STEER = 2.0  # 1/s: how quick it turns back towards its place while it goes
_SIGHT_M = 0.2  # it steers towards a point at least so far ahead, also where its place is nearer
_BRAKING = 0.7  # share of the highest rise that it brakes with
_GENTLE = 4.0  # 1/s: how quick it comes nearer at the end
_AGAIN = 3.0  # as many times `near` it may be off its place before it begins anew


class BaseDrive:
    """The speeds of a base on its way to `target`, x y turn (m, m, rad).

    speed, rise    the highest speed and its highest change (m/s, m/s2); `turning`, `turning_rise` of its turn
    near           how near to its place it comes (m), `near_turn` to its turn (rad)
    """

    def __init__(
        self,
        target: Numbers,
        start: Numbers,
        speed: tuple[float, float],
        turning: tuple[float, float],
        near: tuple[float, float],
    ) -> None:
        self._x, self._y, self._turn = (float(number) for number in target)
        (self._speed, self._rise), (self._turning, self._turning_rise) = speed, turning
        self._near, self._near_turn = near
        self._limited = LimitedRate(start, (self._rise, self._rise, self._turning_rise))
        self._phase = "aim"

    @property
    def is_there(self) -> bool:
        """Whether it stands at its place, turned as it is wanted."""
        return self._phase == "there"

    def away(self, place: Numbers) -> float:
        """How far it is from its place (m)."""
        return math.hypot(self._x - float(place[0]), self._y - float(place[1]))

    def twist(self, place: Numbers, dt: float) -> Array:
        """The speeds double[3] of the next `dt` seconds, where it now is at a place double[3]."""
        self._go_on(place)
        wanted = {"aim": self._aim, "go": self._go, "turn": self._arrive, "there": _stand}[self._phase](place)
        self._limited.follow(np.array(wanted), dt)
        return self._limited.value

    def _go_on(self, place: Numbers) -> None:
        """The next phase, where this one is over and the base stands."""
        if not self._stands():
            return
        away = self.away(place)
        match self._phase:
            case "aim" if away <= _AGAIN * self._near:
                self._phase = "turn"
            case "aim" if abs(self._off(place)) <= self._near_turn:
                self._phase = "go"
            case "go" if self._ahead(place) <= self._near:
                self._phase = "turn" if away <= _AGAIN * self._near else "aim"
            case "turn" if abs(turn_to(float(place[2]), self._turn)) <= self._near_turn:
                self._phase = "there"

    def _stands(self) -> bool:
        forward, left, turning = self._limited.value.tolist()
        if self._phase == "go":
            return bool(abs(forward) <= 2.0 * self._near)
        return math.hypot(forward, left) <= self._near and abs(turning) <= 4.0 * self._near_turn

    def _aim(self, place: Numbers) -> tuple[float, float, float]:
        return 0.0, 0.0, self._turned(self._off(place))

    def _go(self, place: Numbers) -> tuple[float, float, float]:
        ahead = self._ahead(place)
        if ahead <= self._near:
            return _stand(place)
        aside = math.atan2(self._aside(place), max(ahead, _SIGHT_M))
        steer = min(max(_STEER * aside, -self._turning), self._turning)
        return min(self._speed, _braked(ahead, self._rise)) * math.cos(aside), 0.0, steer

    def _arrive(self, place: Numbers) -> tuple[float, float, float]:
        return 0.0, 0.0, self._turned(turn_to(float(place[2]), self._turn))

    def _turned(self, angle: float) -> float:
        if abs(angle) <= 0.5 * self._near_turn:
            return 0.0
        return math.copysign(min(self._turning, _braked(abs(angle), self._turning_rise)), angle)

    def _off(self, place: Numbers) -> float:
        """How far it has to turn to look at its place."""
        return turn_to(float(place[2]), math.atan2(self._y - float(place[1]), self._x - float(place[0])))

    def _ahead(self, place: Numbers) -> float:
        """How far its place lies ahead of it."""
        x, y, turn = (float(number) for number in place)
        return math.cos(turn) * (self._x - x) + math.sin(turn) * (self._y - y)

    def _aside(self, place: Numbers) -> float:
        """How far to its left its place lies."""
        x, y, turn = (float(number) for number in place)
        return math.cos(turn) * (self._y - y) - math.sin(turn) * (self._x - x)


def _braked(way: float, rise: float) -> float:
    """The speed from which it still comes to rest on this way, gently at its end."""
    return min(_GENTLE * max(way, 0.0), math.sqrt(2.0 * _BRAKING * rise * max(way, 0.0)))


def _stand(_place: Numbers) -> tuple[float, float, float]:
    return 0.0, 0.0, 0.0
