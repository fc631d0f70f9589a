"""One actuator variable after a reconfiguration: how far it steps, and its way from the old value to the new (law 33).

The difference between the old value and the new is taken back evenly over so many cycles, and added to the newest
value meanwhile: what a controller answers to its measurements goes through. No cycle goes farther than it may; what is
cut off by that is added to the difference. Where the difference has become too large to be taken back in time, it is
refused.
"""

from math import ceil
from typing import TYPE_CHECKING, Any

import numpy as np

from onika.ring.slots import Ring
from onika.runtime import news
from onika.runtime.declaration import PortDeclaration
from onika.runtime.error import LawBroken
from onika.words.reason import NOTHING, Reason

if TYPE_CHECKING:
    from numpy.typing import NDArray

BLENDED_NS = 100_000_000
"""Within this time a step is blended, or not at all."""


class BumplessChannel:
    """One actuator variable: `data` is the buffer from which the task reads it, flat."""

    def __init__(
        self, svar: str, port: str, declared: PortDeclaration, data: "NDArray[Any]", ring: Ring, limit: Any
    ) -> None:
        self.svar, self.unit, self.step = svar, declared.unit, declared.step
        self.port = port
        self._data = data
        self._target = np.zeros_like(data)
        self._fetch = ring.reader(self._target.data.cast("B"))
        self._last = data.astype(np.float64)
        self._step, self._ratio = np.zeros(data.size), np.zeros(data.size)
        self.allow(limit)
        self._offset: NDArray[np.float64] | None = None
        self._left = self._cycles = 0
        self._worst = self._most_given = -1.0
        self._wanted = self._given = 0.0

    def allow(self, limit: Any) -> None:
        """What it may step by in one cycle; None: nobody knows."""
        self._has_limit = limit is not None
        self._limit = np.broadcast_to(np.ravel(1.0 if limit is None else limit), (self._data.size,)).copy()
        self._share = 1.0 / self._limit

    def change_rate(self, share: float) -> None:
        """So many times as many cycles come in the same time: what is being blended takes as long as before."""
        self._left, self._cycles = ceil(self._left * share), ceil(self._cycles * share)

    def keep(self) -> None:
        """What was passed on last."""
        self._last[:] = self._data

    def come_from(self, held: Any) -> bool:
        """Where a hold has come in between: what has its effect counts as passed on last, None: nobody knows.

        Whether the newest value is within one step of it.
        """
        self._fetch()
        self._last[:] = self._target if held is None else np.ravel(held)
        return not self._has_limit or self._measure(self._target)[0] <= 1.0

    def pass_on(self, now: int, most: int, is_bounded: bool) -> bool:
        """Pass the newest value on; whether it is being blended.

        is_bounded   it goes no farther than it may; else what was begun comes to its end, whatever comes meanwhile
        """
        self._fetch()
        offset = self._offset
        if offset is None:
            worst, index = self._measure(self._target)
            if worst > self._worst:
                self._worst, self._index, self._wanted, self._at = worst, index, float(abs(self._step[index])), now
            if not self._has_limit or worst <= 1.0:
                if worst > self._most_given:
                    self._most_given, self._given = worst, float(abs(self._step[index]))
                self._data[:] = self._target
                return False
            offset = self._begin(worst, most)
        self._blend(offset, most, is_bounded)
        return self._offset is not None

    def take(self, subsystem: str, task: str) -> news.Stepped | None:
        """What was seen since the last call, None where nothing was; a blend that is under way is given up."""
        if self._worst < 0.0:
            return None
        limit = float(self._limit[self._index]) if self._has_limit else 0.0
        measured = self._index, self._wanted, self._given, limit, self._cycles, self._at
        self._worst = self._most_given = -1.0
        self._wanted = self._given = 0.0
        self._left = self._cycles = 0
        self._offset = None
        return news.Stepped(subsystem, task, self.svar, self.unit, *measured)

    def objection(self, value: "NDArray[np.float64]", most: int, task: str = "") -> Reason:
        """Why this value cannot come next to the task that reads it, and what helps."""
        if not self._has_limit:
            return NOTHING
        self._last[:] = self._data
        worst, index = self._measure(value)
        if worst <= most:
            return NOTHING
        return Reason.of(
            "runtime.begin_near",
            why=self._why_not(index, most),
            value=float(self._last[index]),
            unit=self._unit_word,
            task=task or Reason.of("runtime.the_hardware_task"),
        )

    # Inner

    def _measure(self, value: "NDArray[Any]") -> tuple[float, int]:
        """The largest step from what was passed on last, as a share of its limit, and in which element."""
        step, ratio = self._step, self._ratio
        np.subtract(value, self._last, out=step)
        np.multiply(step, self._share, out=ratio)
        np.abs(ratio, out=ratio)
        index = int(ratio.argmax())
        return float(ratio[index]), index

    def _begin(self, worst: float, most: int) -> "NDArray[np.float64]":
        """From the old value to the new one in so many cycles: twice as many as it takes, for the new one moves too."""
        if worst > most:
            raise LawBroken(Reason.of("runtime.begins_from_hold", why=self._why_not(self._index, most)))
        self._left = min(2 * ceil(worst), most)
        self._offset = self._last - self._target
        return self._offset

    def _blend(self, offset: "NDArray[np.float64]", most: int, is_bounded: bool) -> None:
        """The newest value and what is left of the difference."""
        self._cycles += 1
        self._left -= 1
        offset *= self._left / (self._left + 1)
        value = self._target + offset
        worst, index = self._measure(value)
        if worst > 1.0 and is_bounded:
            value = self._cut(offset, most)
            worst = 1.0
        if worst > self._most_given:
            self._most_given, self._given = worst, float(abs(self._step[index]))
        self._data[:] = value
        if not self._left:
            self._offset = None

    def _cut(self, offset: "NDArray[np.float64]", most: int) -> "NDArray[np.float64]":
        """As far as one cycle may go, the rest to the difference."""
        np.clip(self._step, -self._limit, self._limit, out=self._step)
        value: NDArray[np.float64] = self._last + self._step
        np.subtract(value, self._target, out=offset)
        shares = np.abs(offset * self._share)
        index = int(shares.argmax())
        if shares[index] > most:
            self._step[index] = offset[index]
            self._cycles = 0
            raise LawBroken(Reason.of("runtime.begins_from_hold", why=self._why_not(index, most)))
        self._left = max(self._left, min(2 * ceil(float(shares[index])), most))
        return value

    @property
    def _unit_word(self) -> str:
        return "" if self.unit == "-" else f" {self.unit}"

    def _why_not(self, index: int, most: int) -> Reason:
        step, limit = float(abs(self._step[index])), float(self._limit[index])
        return Reason.of(
            "runtime.would_step",
            name=self.svar if self._data.size == 1 else f"{self.svar}[{index}]",
            step=step,
            unit=self._unit_word,
            limit=limit,
            seconds=BLENDED_NS * 1e-9,
            most=limit * most,
        )
