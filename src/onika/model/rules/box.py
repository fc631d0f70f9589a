"""The box of a task icon: how large it is and where its pins sit (dissertation §5.2.1, requirement C02)."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from onika.model.port import PortKind
from onika.model.preferences import Preferences
from onika.model.rules import uses
from onika.model.task import Task

WIDTH = 136
"""Pixels; all boxes are of one width, so that they stand in columns."""

_HEAD = 42
"""Pixels above the first pin's row: the name, and the state beneath it."""

_FOOT = 22
"""Pixels below the last pin's row: the rate and the arrow of data flow."""


@dataclass(frozen=True, slots=True)
class Pin:
    """A pin; `y` lies below the box's upper edge."""

    name: str
    """The coded name."""
    svar: str
    kind: PortKind
    y: int


@dataclass(frozen=True)
class TaskBox:
    """What a task icon measures, in pixels."""

    width: int
    height: int
    pins: tuple[Pin, ...]

    @cached_property
    def uses(self) -> dict[str, uses.Uses]:
        """What its task counts at the loci of its variables."""
        return uses.of_task((pin.svar, pin.kind) for pin in self.pins)

    def reach(self, pin: Pin, x: int, y: int, in_left: bool) -> tuple[int, int]:
        """Where a pin is when the box's corner stands at (x, y)."""
        is_left = pin.kind.is_input == in_left
        return (x if is_left else x + self.width, y + pin.y)

    def outward(self, pin: Pin, in_left: bool) -> int:
        """In which direction of x its line leaves: -1 to the left, 1 to the right."""
        return -1 if pin.kind.is_input == in_left else 1


def box_of(task: Task, preferred: Preferences) -> TaskBox:
    """The box of a task: it grows by steps until its pins are far enough apart."""
    inputs, outputs = _sides(task)
    rows = max(len(inputs), len(outputs), 1)
    inner = -(-rows * preferred.min_pin_separation // preferred.step_size) * preferred.step_size
    height = max(_HEAD + inner + _FOOT, preferred.min_size)
    return TaskBox(WIDTH, height, (*_pins(inputs, task, preferred), *_pins(outputs, task, preferred)))


def _sides(task: Task) -> tuple[list[tuple[str, PortKind]], list[tuple[str, PortKind]]]:
    """Inputs and outputs in the file's order, constants first."""
    kinds = list(task.kinds().items())
    return [port for port in kinds if port[1].is_input], [port for port in kinds if not port[1].is_input]


def _pins(side: list[tuple[str, PortKind]], task: Task, preferred: Preferences) -> Iterator[Pin]:
    names = task.svars(tuple(name for name, _ in side))
    apart = preferred.min_pin_separation
    for row, ((name, kind), svar) in enumerate(zip(side, names, strict=True)):
        yield Pin(name, svar, kind, _HEAD + apart // 2 + apart * row)
