"""Bumpless transfer of a hardware task's inputs: after a reconfiguration none steps farther than it may (law 33, X04).

An actuator variable is a real variable that a hardware task reads each cycle. What a step in it may be is declared with
the port. While it is watched, the value of each cycle is compared with the one that was passed on before it. Where it
steps farther than it may, the task is given the old value, which goes over into the new one within cycles; where
that would take too long, the task has a fault, and its device holds.
"""

from collections.abc import Callable, Iterable
from math import prod
from typing import TYPE_CHECKING, Any

import numpy as np

from onika.runtime import news
from onika.runtime.declaration import Step
from onika.runtime.modules.binding import Binding
from onika.runtime.modules.module import Module
from onika.runtime.transfer.bumpless_channel import BLENDED_NS, BumplessChannel
from onika.words.reason import NOTHING, Reason

if TYPE_CHECKING:
    from numpy.typing import NDArray

WATCHED_NS = 50_000_000
"""So long after a reconfiguration inputs are watched, besides two periods of the task that came: until then what it
does has come through the tasks between it and the device."""
Tell = Callable[[news.Stepped], None]


def limit_of(module: Module, step: Step) -> Any:
    """What a step may be, as number or array: a product of numbers and of ports and parameters by name.

    Raises ValueError where it is no positive number.
    """
    if step is None:
        return None
    factors = step if isinstance(step, tuple) else (step,)
    attributes = {declared.name: name for name, declared in type(module).declared_ports.items()}
    values = [
        getattr(module, attributes.get(factor, factor)) if isinstance(factor, str) else factor for factor in factors
    ]
    limit = prod(np.asarray(value, dtype=np.float64) for value in values)
    if not np.all(limit > 0.0):  # NaN too
        product = " * ".join(map(str, factors))
        raise ValueError(Reason.of("runtime.step_not_positive", product=product, limit=str(limit)))
    return limit


class BumplessTransfer:
    """The actuator variables of one task."""

    def __init__(self, subsystem: str, task: str, bumpless_channels: Iterable[BumplessChannel], period_ns: int) -> None:
        self.tell: Tell = lambda _stepped: None
        self.channels = tuple(bumpless_channels)
        self.is_open = False
        self._address = subsystem, task
        self._period_ns = period_ns
        self._after = 0

    def change_rate(self, module: Module, period_ns: int) -> None:
        """Cycles come at another rate from now on: so much else may happen in one; raises ValueError as `limit_of`."""
        share = self._period_ns / period_ns
        self._period_ns = period_ns
        for channel in self.channels:
            channel.allow(limit_of(module, channel.step))
            channel.change_rate(share)

    def keep(self) -> None:
        """Before the inputs are copied in: what was passed on last."""
        for channel in self.channels:
            channel.keep()

    def come_from_hold(self, module: Module) -> bool:
        """Before the first inputs after a hold are passed on: whether they are near to what holds the device."""
        is_near = True
        for channel in self.channels:
            is_near &= channel.come_from(module.held(channel.port))
        return is_near

    def pass_on(self, now: int, is_watched: bool) -> None:
        """After the inputs were copied in: measure, blend; raises LawBroken for what cannot be blended."""
        self.is_open = True
        most = max(BLENDED_NS // self._period_ns, 1)
        self._after = 0 if is_watched else self._after + 1
        is_blending = False
        for channel in self.channels:
            is_blending |= channel.pass_on(now, most, self._after <= most)
        if not (is_watched or is_blending):
            self.close()

    def close(self) -> None:
        """Watching is over: tell what was seen."""
        self.is_open = False
        for channel in self.channels:
            seen = channel.take(*self._address)
            if seen is not None:
                self.tell(seen)

    def objection(self, svar: str, value: "NDArray[np.float64]") -> Reason:
        """Why the task cannot be given this value of a variable next; empty where it can, or where it does not read it.

        It is looked at before anybody sees it: what a task that comes on leaves in its outputs.
        """
        most = max(BLENDED_NS // self._period_ns, 1)
        task = self._address[1]
        return next(
            (channel.objection(value, most, task) for channel in self.channels if channel.svar == svar), NOTHING
        )


def bumpless_channels(module: Module, binding: Binding) -> tuple[BumplessChannel, ...]:
    """Those of a module's real inputs that do not step by nature; raises ValueError for a bad limit."""
    channels = []
    for port, declared, svar, data, ring in binding.read_each_cycle:
        limit = limit_of(module, declared.step)
        if limit is None or np.any(np.isfinite(limit)):
            channels.append(BumplessChannel(svar, port, declared, data, ring, limit))
    return tuple(channels)
