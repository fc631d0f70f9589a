"""What is said between a task and its module in a sandbox (requirement X16). Values of ports lie in shared memory."""

import re
from collections.abc import Iterable
from typing import Any

import numpy as np
from msgspec import Struct, msgpack

from onika.model.signal import Signal, SignalKind
from onika.runtime.command import DeviceGrant, Spawn
from onika.runtime.declaration import Step
from onika.runtime.modules.module import Module
from onika.runtime.modules.sheet import sheet_of
from onika.runtime.picture import picture_size
from onika.wire.sheet import ModuleSheet
from onika.words.reason import NOTHING, KeyedSentence, Reason, as_reason
from onika.words.shape import Shape

_ARRAY = 1
"""The code of an array among the kinds of msgpack."""
_PLAIN_NUMBERS = re.compile(r"[<>|=]?[?biuf][0-9]*\Z")


class Declared(Struct, frozen=True, tag=True):
    """The class was loaded: what it declares, and of each port its name in Python and its step."""

    sheet: ModuleSheet
    attributes: tuple[str, ...]
    steps: tuple[Step, ...]


class Refused(Struct, frozen=True, tag=True):
    """The class could not be loaded, or the process could not be confined."""

    reason: Reason


class Load(Struct, frozen=True, tag=True):
    """Load the module of this task."""

    spawn: Spawn


class PortPlace(Struct, frozen=True):
    """Where the values of a port lie in the shared memory: bytes; its shape is resolved."""

    port: str
    shape: str
    offset: int
    size: int


class Bind(Struct, frozen=True, tag=True):
    """Make an instance, or bind the one there is anew: its ports and its parameters."""

    ports: tuple[PortPlace, ...]
    local: dict[str, Any]


class Call(Struct, frozen=True, tag=True):
    """Call an entry point with the values that lie in the shared memory."""

    entry: str
    now: float
    dt: float
    published: int = 0
    """How often its device has published."""
    given: tuple[Any, ...] = ()
    in_force: frozenset[str] | None = None
    """Before `on`: the ports whose value still steers something."""


class Raised(Struct, frozen=True):
    """What an entry point has raised."""

    family: str
    """`ask_again`, `module_error`, `law_broken`, or nothing for any other."""
    why: Reason
    path: str
    line: int
    trace: str


class DeviceOrderGiven(Struct, frozen=True):
    """What the module has last told its device: `drive`, `hold` or `clear`, and the values to drive it to."""

    order: str
    values: tuple[float, ...] = ()


class Returned(Struct, frozen=True, tag=True):
    """What came of a call."""

    value: Any = None
    signal: tuple[str, int, bool, int, Reason] | None = None
    raised: Raised | None = None
    warnings: tuple[Reason, ...] = ()
    device: DeviceOrderGiven | None = None


Answer = Declared | Refused | Returned

PREPARES = frozenset(("init", "reinit", "on"))
"""The entry points before which all ports are shown; before others only the inputs of cycles: outputs are its own."""

_LINE = 64

DEVICE_AT = _LINE
"""Where in the shared memory what the device publishes lies; its picture, and the ports, lie behind."""


def device_sizes(grant: DeviceGrant | None) -> tuple[int, int, int]:
    """Bytes of what a device publishes, of what it is told, and of its picture; 0 where there is none."""
    if grant is None:
        return 0, 0, 0
    picture = picture_size(grant.picture) if grant.picture else 0
    return 8 * len(grant.state), 8 * (2 + len(grant.command)), picture


def places_of(ports: Iterable[tuple[str, Shape]], grant: DeviceGrant | None) -> tuple[PortPlace, ...]:
    """Where the values of ports lie: one behind the other, behind those of the device; shapes are resolved."""
    state, _, picture = device_sizes(grant)
    places, offset = [], _aligned(DEVICE_AT + state + picture)
    for name, shape in ports:
        places.append(PortPlace(name, str(shape), offset, shape.size))
        offset = _aligned(offset + shape.size)
    return tuple(places)


def _aligned(offset: int) -> int:
    return -(-offset // _LINE) * _LINE


def declared(cls: type[Module]) -> Declared:
    """What a class declares; raises ValueError where its declarations contradict each other."""
    ports = cls.declared_ports
    return Declared(sheet_of(cls), tuple(ports), tuple(port.step for port in ports.values()))


def as_said(sentence: object) -> Reason:
    """What a module says as a reason."""
    return as_reason(sentence) if isinstance(sentence, Reason | KeyedSentence) else Reason.plain(str(sentence))


def signal_row(signal: Signal) -> tuple[str, int, bool, int, Reason]:
    """A signal as it travels."""
    text = signal.text if isinstance(signal.text, Reason) else Reason.plain(str(signal.text))
    return signal.kind.value, int(signal.flow), bool(signal.loop), int(signal.number), text


def signal_of_row(row: tuple[str, int, bool, int, Reason]) -> Signal:
    """The signal of a row; raises ValueError where there is no such kind."""
    kind, flow, loop, number, text = row
    return Signal(SignalKind(kind), flow, loop, number, text or NOTHING)


def _packed(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        head = f"{value.dtype.str} {' '.join(map(str, value.shape))}".encode()
        return msgpack.Ext(_ARRAY, head + b"\n" + value.tobytes())
    if isinstance(value, np.generic):
        return value.item()
    raise TypeError(f"expected numbers, texts or arrays, found {type(value).__name__}")


def _unpacked(code: int, data: memoryview) -> Any:
    head, _, body = bytes(data).partition(b"\n")
    dtype, *dims = head.decode().split()
    if code != _ARRAY or not _PLAIN_NUMBERS.match(dtype):
        raise ValueError(f"expected an array of numbers, found {code} {dtype}")
    return np.frombuffer(body, np.dtype(dtype)).reshape([int(dim) for dim in dims]).copy()


encode = msgpack.Encoder(enc_hook=_packed).encode
decode_order = msgpack.Decoder(Load | Bind | Call, ext_hook=_unpacked).decode
decode_answer = msgpack.Decoder(Declared | Refused | Returned, ext_hook=_unpacked).decode
