"""Variables that nobody writes are written by hand: by whoever holds the subsystem, value by value (law 27)."""

from math import inf, isfinite

import numpy as np

from onika.host.subsystems.live_subsystem import LiveSubsystem
from onika.runtime.wiring import WiredTask
from onika.wire import live as asked, request
from onika.words.reason import NOTHING, Reason
from onika.words.shape import Shape
from onika.words.value import ValueType

_LARGEST_FLOAT = float(np.finfo(ValueType.FLOAT.code).max)


def write(live: LiveSubsystem, order: asked.Write) -> request.Response:
    """Write a variable at once, or say why it cannot be written by hand; then nothing is changed."""
    refusal = _refusal(live, order.name)
    if refusal:
        return request.Refused(refusal)
    shape = live.table.entries[order.name].shape
    wrong = _wrong(order.values, shape)
    if wrong:
        return request.Refused(Reason.of("host.hand_value", name=order.name, shape=str(shape), why=wrong))
    ring = live.table.ring(order.name)
    ring.write(np.array(order.values).astype(shape.type.code).tobytes())
    ring.seal()
    return request.Done()


def _refusal(live: LiveSubsystem, name: str) -> Reason:
    """Why a variable belongs to somebody, or steers a device without a task between."""
    if name not in live.table.entries:
        return Reason.of("host.not_read", subsystem=live.name, names=(name,))
    if live.is_busy:
        return Reason.of("host.hand_changing", subsystem=live.name)
    writers = tuple(wired.name for wired in live.wired if name in (*wired.outconst, *wired.outvar))
    if writers:
        return Reason.of("host.hand_written", name=name, tasks=writers)
    if any(name in wired.inconst or name in _dimensions(wired) for wired in live.wired):
        return Reason.of("host.hand_constant", name=name)
    hardware = tuple(wired.name for wired in live.wired if wired.sheet.hardware and name in wired.invar)
    if hardware:
        return Reason.of("host.hand_device", name=name, tasks=hardware)
    if live.table.entries[name].shape.type.is_text:
        return Reason.of("host.hand_text", name=name)
    return NOTHING


def _dimensions(wired: WiredTask) -> set[str]:
    return {name for port in wired.ports for name in port.shape.names}


def _wrong(values: tuple[float, ...], shape: Shape) -> Reason:
    """What is wrong with values for a variable of numbers."""
    if len(values) != shape.count:
        return Reason.of("host.hand_count", expected=shape.count, given=len(values))
    for value in values:
        if not isfinite(value):
            return Reason.of("host.hand_infinite")
        if not shape.type.fits(_whole(value)) or abs(value) > _largest(shape.type):
            return Reason.of("host.hand_kind", kind=shape.type.value, value=value)
    return NOTHING


def _largest(kind: ValueType) -> float:
    """What is larger would be infinite where it is kept."""
    return _LARGEST_FLOAT if kind is ValueType.FLOAT else inf


def _whole(value: float) -> float | int:
    return int(value) if value.is_integer() else value
