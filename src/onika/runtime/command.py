"""What the runner tells an RTPU, one datagram each; the RTPU answers with news."""

import msgspec
from msgspec import Struct


class BoundPort(Struct, frozen=True):
    """A port of a task and the entry it is bound to; the shape is resolved."""

    port: str
    svar: str
    shape: str
    offset: int


class DeviceGrant(Struct, frozen=True):
    """A device that a task may use: where its rings lie, and the epoch of the claim."""

    segment: str
    name: str
    state: tuple[str, ...]
    command: tuple[str, ...]
    identity: dict[str, tuple[float, ...] | str]
    epoch: int
    state_offset: int
    command_offset: int | None


class Spawn(Struct, frozen=True, tag=True):
    """Bring a task to life and initialise it."""

    subsystem: str
    task: str
    module: str
    path: str
    source: str
    task_type: str
    frequency: float | None
    local: tuple[tuple[str, tuple[str, ...]], ...]
    ports: tuple[BoundPort, ...]
    rank: int
    seed: int
    device: DeviceGrant | None


class Launch(Struct, frozen=True):
    """A task to turn ON, its argument line and, where it changes, its rate."""

    task: str
    arguments: str = ""
    frequency: float | None = None


class Switch(Struct, frozen=True, tag=True):
    """Turn tasks off and on with no cycle in between; then `forget` no longer steers anything (law 3)."""

    subsystem: str
    off: tuple[str, ...]
    forget: tuple[str, ...]
    on: tuple[Launch, ...]
    rates: tuple[tuple[str, float], ...] = ()


class Answer(Struct, frozen=True, tag=True):
    """The user's answer to a task that is ASKING, as an argument line."""

    subsystem: str
    task: str
    line: str


class Clear(Struct, frozen=True, tag=True):
    """Bring a task out of ERROR."""

    subsystem: str
    task: str


class Get(Struct, frozen=True, tag=True):
    """Ask a module for something by name."""

    subsystem: str
    task: str
    name: str


class Set(Struct, frozen=True, tag=True):
    """Tell a module a new value of something by name."""

    subsystem: str
    task: str
    name: str
    value: str


class Kill(Struct, frozen=True, tag=True):
    """End a task."""

    subsystem: str
    task: str


class Report(Struct, frozen=True, tag=True):
    """Ask for the status of every task; counters begin anew with it (requirement A17)."""


class Stop(Struct, frozen=True, tag=True):
    """Everything off at once, devices in hold (law 27)."""

    cause: str


class Fail(Struct, frozen=True, tag=True):
    """Devices are gone for this reason: every task that has one and is ON goes to ERROR (law 17)."""

    cause: str


class Quit(Struct, frozen=True, tag=True):
    """End the processing unit."""


Command = Spawn | Switch | Answer | Clear | Get | Set | Kill | Report | Stop | Fail | Quit

encode = msgspec.msgpack.Encoder().encode
decode = msgspec.msgpack.Decoder(Command).decode
