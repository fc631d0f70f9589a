"""A task as the law sees it: plain records and functions, which the reference interprets (laws 1 to 6)."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from onika.model.signal import Signal
from onika.ring.device import DeviceOrder

Values = dict[str, Any]


class DeviceHandle:
    """A task's hand on its device: the state published last, and the command that acts from the next step on."""

    def __init__(self, published: Mapping[str, tuple[float, ...]], device: str) -> None:
        self._published = published
        self._device = device
        self.order: tuple[DeviceOrder, tuple[float, ...]] | None = None
        self.is_holding = False

    def read(self) -> tuple[float, ...]:
        """The state without the world's time and the drive's state."""
        return self._published[self._device][2:]

    def write(self, values: tuple[float, ...]) -> None:
        """Command values; law 4: a hold while inputs are not fresh. Law 5: raises ValueError for NaN or infinity."""
        if self.is_holding:
            self.hold()
        elif not all(map(math.isfinite, values)):
            self.hold()
            raise ValueError("expected finite commands")
        else:
            self.order = (DeviceOrder.DRIVE, values)

    def hold(self) -> None:
        """Command a hold."""
        self.order = (DeviceOrder.HOLD, ())


@dataclass(slots=True)
class Moment:
    """What an entry point sees: its inputs, its own outputs to write into, its memory, its device."""

    now: int
    period: int
    inputs: Values
    outputs: Values
    memory: Values
    in_force: frozenset[str] = frozenset()
    device: DeviceHandle | None = None
    former: Values = field(default_factory=dict)
    """During `take`: the memory of the code that worked until now."""


Entry = Callable[[Moment], Signal | bool | None]


@dataclass(frozen=True, slots=True)
class LawTask:
    """A task: its entry points by name (any may be missing), its variables, what orders it, what a cycle costs (ns).

    An INBOTH stands in `inconst` and `invar`, an OUTBOTH in `outconst` and `outvar`. `error` returns whether it mended.
    """

    name: str
    code: Mapping[str, Entry]
    period: int = 10_000_000
    is_periodic: bool = True
    crit: int = 0
    rank: int = 0
    cost: int = 0
    trigger: bool = False
    hardware: bool = False
    passive: bool = False
    device: str = ""
    inconst: tuple[str, ...] = ()
    outconst: tuple[str, ...] = ()
    invar: tuple[str, ...] = ()
    outvar: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Traced:
    """One call of an entry point, as it stood when the call was over."""

    at: int
    task: str
    entry: str
    inputs: Values
    outputs: Values


@dataclass(frozen=True, slots=True)
class LawSwap:
    """Law 21: this task's code in place of that of the task of its name."""

    task: LawTask
