"""A module in a sandbox, as its task sees it: an instance with the same ports whose entry points are carried out there.

The sandbox gets the values of the ports before each call, and gives those of the outputs back; nothing else of the
runtime is in its reach (requirement X16).
"""

import struct
from types import SimpleNamespace
from typing import Any, ClassVar, Protocol

import numpy as np
from msgspec import MsgspecError

from onika.model.signal import Signal
from onika.runtime.command import DeviceGrant
from onika.runtime.error import AskAgain, LawBroken, ModuleError, RaisedElsewhere
from onika.runtime.modules.binding import Binding
from onika.runtime.modules.module import Module
from onika.runtime.sandbox import sandbox_messages as messages
from onika.runtime.sandbox.port_copies import PortCopies, put, take
from onika.words.reason import Reason, reason_of

LOADING_S = 10.0
"""So long a sandbox may take to load, bind or initialise a module."""
CALL_S = 0.8
"""So long any other call may take: less than makes a unit count as frozen."""
_MOST_WARNINGS = 100
"""Of one call; whoever warns more often floods nobody."""
NOTHING_CAME_OF_IT = b"\0"
CYCLE = struct.Struct("<cdQ")
"""The message for a cycle: the letter, the time, how often the device has published."""
CYCLE_LETTER = b"c"

_FAMILIES: dict[str, type[AskAgain | ModuleError]] = {
    "ask_again": AskAgain,
    "law_broken": LawBroken,
    "module_error": ModuleError,
}


class Sandbox(Protocol):
    """A process that can do nothing but compute, where one module is; it answers one message at a time."""

    @property
    def memory(self) -> memoryview:
        """What it shares with its task."""
        ...

    @property
    def is_heard(self) -> bool:
        """Whether it has something to say: an answer, or its end."""
        ...

    def answer(self, patience_s: float) -> bytes:
        """Its answer; raises LawBroken where none comes within the time, or it has ended: then it is gone."""
        ...

    def ask(self, message: bytes, patience_s: float) -> bytes:
        """Send it a message, and wait for its answer, as above."""
        ...

    def close(self) -> None:
        """End it."""
        ...


class SandboxedModule(Module):
    """The base of the class that is made for each such task."""

    _sandbox: ClassVar[Sandbox]
    _grant: ClassVar[DeviceGrant | None]

    def __init__(self) -> None:
        super().__init__()
        self._places: tuple[messages.PortPlace, ...] = ()
        self._is_bound_there = True
        self._is_new = True
        self._copies: PortCopies
        self._memory = np.frombuffer(self._sandbox.memory, np.uint8)

    def bound_to(self, binding: Binding) -> None:
        """Its ports are bound, or bound anew: where their values lie in the memory that the sandbox sees."""
        self._is_bound_there = self._is_new  # at first it has bound its ports itself, when it was loaded
        self._is_new = False
        self._places = messages.places_of(((name, shape) for name, shape, _ in binding.values), self._grant)
        self._copies = PortCopies(binding, self.declared_ports, self._places, self._memory)

    # Entry points, carried out there

    def init(self) -> None:
        """Initialise there."""
        self._call("init", LOADING_S)

    def reinit(self) -> None:
        """The same, after constants or ports have changed."""
        self._bind()
        self._call("reinit", LOADING_S)

    def on(self, inputs: SimpleNamespace) -> None:
        """With the user's input; what is in force goes along."""
        self._call("on", given=(vars(inputs),), in_force=self.in_force)

    def cycle(self) -> Signal | None:
        """Inputs there, one cycle, outputs back."""
        put(self._copies.inputs)
        published = self._show_device() if self._grant is not None else 0
        answer = self._sandbox.ask(CYCLE.pack(CYCLE_LETTER, self.now, published), CALL_S)
        if answer == NOTHING_CAME_OF_IT:
            take(self._copies.outputs)
            return None
        return self._signal(self._taken(answer))

    def sync(self) -> Signal | None:
        """The event has come."""
        return self._signal(self._call("sync"))

    def fileno(self) -> int:
        """None: descriptors do not leave a sandbox."""
        raise ModuleError(Reason.of("runtime.sandbox_no_descriptor"))

    def off(self) -> None:
        """The task goes off."""
        self._call("off")

    def kill(self) -> None:
        """The task ends, and its sandbox with it."""
        try:
            self._call("kill")
        finally:
            self._sandbox.close()

    def error(self, fault: BaseException) -> bool:
        """Whether it mends what was raised there."""
        return isinstance(fault, ModuleError | RaisedElsewhere) and self._call("error").value is True

    def clear(self) -> None:
        """Whether it comes out of ERROR."""
        self._call("clear")

    def get(self, name: str) -> Any:
        """A value as plain numbers, texts and lists."""
        return self._call("get", given=(name,)).value

    def set(self, name: str, value: str) -> None:
        """Change something."""
        self._call("set", given=(name, value))

    def hold(self) -> None:
        """A cycle that commands nothing."""
        self._call("hold")

    def held(self, name: str) -> Any:
        """What this input would have to be for the device to stay."""
        return self._call("held", given=(name,)).value

    # Inner

    def _bind(self) -> None:
        if self._is_bound_there:
            return
        self._is_bound_there = True
        local = {name: getattr(self, name) for name in self.declared_locals}
        self._taken(self._sandbox.ask(messages.encode(messages.Bind(self._places, local)), LOADING_S))

    def _call(
        self,
        entry: str,
        patience_s: float = CALL_S,
        given: tuple[Any, ...] = (),
        in_force: frozenset[str] | None = None,
    ) -> messages.Returned:
        put(self._copies.every if entry in messages.PREPARES else self._copies.inputs)
        published = self._show_device() if self._grant is not None else 0
        call = messages.Call(entry, self.now, self.dt, published, given, in_force)
        return self._taken(self._sandbox.ask(messages.encode(call), patience_s))

    def _show_device(self) -> int:
        """What the device publishes, for the sandbox to see; how often it has published."""
        published, newest = self.device.newest()
        end = messages.DEVICE_AT + newest.nbytes
        self._memory[messages.DEVICE_AT : end] = newest.view(np.uint8)
        if self._grant is not None and self._grant.picture:
            picture = self.device.picture().reshape(-1)
            self._memory[end : end + picture.size] = picture
        return published

    def _taken(self, answer: bytes) -> messages.Returned:
        """What came of a call: outputs, warnings, what the device is told; raises what was raised there."""
        returned = _decoded(answer)
        take(self._copies.outputs)
        self.warnings.extend(returned.warnings[:_MOST_WARNINGS])
        if returned.device is not None:
            self._tell_device(returned.device)
        if returned.raised is not None:
            raise _exception(returned.raised)
        return returned

    def _tell_device(self, given: messages.DeviceOrderGiven) -> None:
        match given.order:
            case "drive":
                self.device.write(given.values)
            case "clear":
                self.device.clear()
            case _:
                self.device.hold()

    def _signal(self, returned: messages.Returned) -> Signal | None:
        if returned.signal is None:
            return None
        try:
            return messages.signal_of_row(returned.signal)
        except ValueError as wrong:
            raise LawBroken(Reason.of("runtime.sandbox_answer", why=reason_of(wrong))) from None


def _exception(raised: messages.Raised) -> AskAgain | ModuleError | RaisedElsewhere:
    wrong = _FAMILIES.get(raised.family, RaisedElsewhere)(raised.why)
    wrong.raised_at = raised.path, raised.line, raised.trace
    return wrong


def _decoded(answer: bytes) -> messages.Returned:
    message = message_of(answer)
    if isinstance(message, messages.Refused):
        raise LawBroken(message.reason)
    if not isinstance(message, messages.Returned):
        raise LawBroken(Reason.of("runtime.sandbox_answer", why=type(message).__name__))
    return message


def message_of(answer: bytes) -> messages.Answer:
    """An answer as a message; raises LawBroken for what is none: the sandbox is not believed."""
    try:
        message: messages.Answer = messages.decode_answer(answer)
    except (MsgspecError, ValueError, TypeError, KeyError) as wrong:
        raise LawBroken(Reason.of("runtime.sandbox_answer", why=str(wrong)[:200])) from None
    return message
