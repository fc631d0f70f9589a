"""A module's instance where it is confined: what its process answers to the task, without the process itself."""

from collections.abc import Callable
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np
from msgspec import structs

from onika.ring.device import DeviceOrder
from onika.ring.slots import Ring
from onika.runtime.command import BoundPort, DeviceGrant, Spawn
from onika.runtime.error import AskAgain, LawBroken, ModuleError
from onika.runtime.modules.binding import Binding, give_locals, instantiate
from onika.runtime.modules.binding_guard import BindingGuard
from onika.runtime.modules.code import load, raised, where
from onika.runtime.modules.cycle_result import signal_of
from onika.runtime.modules.module import Module
from onika.runtime.picture import picture_size
from onika.runtime.sandbox import sandbox_messages as messages
from onika.runtime.sandbox.port_copies import PortCopies, put, take
from onika.runtime.table import HEAD, plain
from onika.words.fault import Fault
from onika.words.reason import Reason, reason_of
from onika.words.shape import Shape

if TYPE_CHECKING:
    from numpy.typing import NDArray

_DEVICE = "sandbox:device"
_ORDERS = {DeviceOrder.HOLD: "hold", DeviceOrder.DRIVE: "drive", DeviceOrder.CLEAR: "clear"}
_LOOKED_AT_AFTER = frozenset(("init", "reinit", "on", "off"))
"""The entry points after which the module has to be still what was bound."""


class ConfinedInstance:
    """Answers one message after the other; values of ports and of the device lie in `memory`, which the task shares."""

    def __init__(self, memory: memoryview) -> None:
        self._memory = np.frombuffer(memory, np.uint8)
        self._spawn: Spawn | None = None
        self._class: type[Module] | None = None
        self._instance: Module | None = None
        self._binding: Binding | None = None
        self._guard: BindingGuard | None = None
        self._copies: PortCopies
        self._device: _PrivateDevice | None = None
        self._last_raised: BaseException | None = None

    def answer(self, order: messages.Load | messages.Bind | messages.Call) -> messages.Answer:
        """What is asked for; nothing is raised."""
        match order:
            case messages.Load():
                return self._load(order.spawn)
            case messages.Bind():
                return self._outcome(lambda: self._bind(order))
            case messages.Call():
                return self._call(order)

    def cycle(self, now: float, published: int) -> messages.Returned | None:
        """One cycle, as it is asked for thousands of times; None: nothing came of it."""
        instance = self._instance
        if instance is None:
            return self._outcome(_not_bound)
        take(self._copies.inputs)
        if self._device is not None:
            self._device.take(published)
        instance.now = now
        raised = None
        try:
            value = instance.cycle()
        except BaseException as wrong:  # whatever it is, it is said and does not end this process
            raised, value = self._raised(wrong), None
        put(self._copies.outputs)
        if raised is not None:
            return self._finished(raised)
        if value is None and not instance.warnings and self._device is None:
            return None
        return self._finished(self._signalled(value))

    # Inner

    def _load(self, spawn: Spawn) -> messages.Declared | messages.Refused:
        cls = load(spawn.source, spawn.path, spawn.module)
        if isinstance(cls, Fault):
            return messages.Refused(cls.sentence)
        self._spawn, self._class = spawn, cls
        shapes = {port.port: Shape.parse(port.shape) for port in spawn.ports}
        names = [declared.name or attribute for attribute, declared in cls.declared_ports.items()]
        places = messages.places_of(((name, shapes[name]) for name in names if name in shapes), spawn.device)
        outcome = self._outcome(lambda: self._bind(messages.Bind(places, {})))
        if outcome.raised is not None:
            return messages.Refused(outcome.raised.why)
        try:
            return messages.declared(cls)
        except ValueError as wrong:
            return messages.Refused(reason_of(wrong))

    def _bind(self, order: messages.Bind) -> None:
        if self._spawn is None or self._class is None:
            raise ValueError("expected a module that is loaded, found none")
        ports, end = [], HEAD
        for place in order.ports:
            ports.append(BoundPort(place.port, place.port, place.shape, end))
            end += Ring.footprint(place.size)
        spawn = structs.replace(self._spawn, ports=tuple(ports))
        views = {f"table:{spawn.subsystem}": memoryview(bytearray(end))}
        if spawn.device is not None:
            self._device = self._device or _PrivateDevice(spawn.device, self._memory)
            views[_DEVICE] = self._device.view
            spawn = structs.replace(spawn, device=self._device.grant)
        if self._instance is None:
            self._instance = instantiate(self._class, spawn, views)
        give_locals(self._instance, SimpleNamespace(**order.local))
        self._binding = Binding(self._instance, spawn, views, self._binding)
        self._guard = BindingGuard(self._instance)
        self._copies = PortCopies(self._binding, self._class.declared_ports, order.ports, self._memory)

    def _call(self, call: messages.Call) -> messages.Returned:
        instance = self._instance
        if instance is None:
            return self._outcome(_not_bound)
        take(self._copies.every if call.entry in messages.PREPARES else self._copies.inputs)
        if self._device is not None:
            self._device.take(call.published)
        instance.now, instance.dt = call.now, call.dt
        if call.in_force is not None:
            instance.in_force = call.in_force
        outcome = self._outcome(lambda: self._entry(instance, call), call.entry)
        put(self._copies.outputs)
        return self._finished(outcome)

    def _entry(self, instance: Module, call: messages.Call) -> Any:
        given = call.given
        match call.entry:
            case "on":
                return instance.on(SimpleNamespace(**given[0]))
            case "error":
                return self._last_raised is not None and bool(instance.error(self._last_raised))
            case "get":
                return plain(instance.get(given[0]))
            case "set":
                return instance.set(given[0], given[1])
            case "held":
                return instance.held(given[0])
            case "cycle" | "sync":
                return getattr(instance, call.entry)()
            case "init" | "reinit" | "off" | "kill" | "clear" | "hold":
                getattr(instance, call.entry)()
                return None
        raise ValueError(f"expected an entry point, found {call.entry!r}")

    def _outcome(self, work: Callable[[], Any], entry: str = "") -> messages.Returned:
        try:
            value = work()
            if entry in _LOOKED_AT_AFTER and self._guard is not None:
                self._guard.check()
            return self._signalled(value) if entry in ("cycle", "sync") else messages.Returned(value)
        except BaseException as wrong:  # as above
            return self._raised(wrong)

    def _signalled(self, value: object) -> messages.Returned:
        if value is None or (type(value) is int and not value):
            return messages.Returned()
        try:
            is_trigger = self._class is not None and self._class.trigger
            return messages.Returned(signal=messages.signal_row(signal_of(value, is_trigger=is_trigger)))
        except TypeError as wrong:
            return self._raised(wrong)

    def _raised(self, wrong: BaseException) -> messages.Returned:
        self._last_raised = wrong
        path, line, trace = where(self._spawn.path if self._spawn else "", wrong)
        module = self._spawn.module if self._spawn else ""
        why = wrong.args[0] if isinstance(wrong, AskAgain | ModuleError) and wrong.args else raised(wrong, module)
        if isinstance(wrong, PermissionError):
            why = Reason.of("runtime.sandbox_refuses", why=messages.as_said(why))
        return messages.Returned(raised=messages.Raised(_family(wrong), messages.as_said(why), path, line, trace))

    def _finished(self, outcome: messages.Returned) -> messages.Returned:
        """With what the module has warned of, and what it has told its device."""
        warnings: tuple[Any, ...] = ()
        if self._instance is not None:
            warnings = tuple(map(messages.as_said, self._instance.warnings))
            self._instance.warnings.clear()
        order = self._device.order() if self._device is not None else None
        return structs.replace(outcome, warnings=warnings, device=order)


class _PrivateDevice:
    """A device as the module sees it: rings of its own, filled with what the task has read."""

    def __init__(self, grant: DeviceGrant, memory: "NDArray[np.uint8]") -> None:
        state, command, picture = messages.device_sizes(grant)
        self.view = memoryview(
            bytearray(Ring.footprint(state) + Ring.footprint(command) + Ring.footprint(picture or 1))
        )
        self._state = memoryview(bytearray(state))
        at_command, at_picture = Ring.footprint(state), Ring.footprint(state) + Ring.footprint(command)
        self.grant = structs.replace(
            grant,
            segment=_DEVICE,
            state_offset=0,
            command_offset=None if grant.command_offset is None else at_command,
            picture_offset=at_picture,
        )
        self._place = memory[messages.DEVICE_AT : messages.DEVICE_AT + state]
        self._write = Ring(self.view, 0, state).writer(self._state)
        self._commands = Ring(self.view, at_command, command)
        self._told = 0
        self._published = -1
        self._picture = memoryview(bytearray(picture))
        self._picture_place = memory[messages.DEVICE_AT + state : messages.DEVICE_AT + state + picture]
        self._show = Ring(self.view, at_picture, picture_size(grant.picture)).writer(self._picture) if picture else None

    def take(self, published: int) -> None:
        """Show the module what the task has read, where that is new."""
        if published == self._published:
            return
        self._published = published
        self._state[:] = self._place.data
        self._write()
        if self._show is not None:
            self._picture[:] = self._picture_place.data
            self._show()

    def order(self) -> messages.DeviceOrderGiven | None:
        """What the module has last told its device since the last call."""
        if self._commands.count == self._told:
            return None
        self._told = self._commands.count
        numbers = np.frombuffer(self._commands.read())
        return messages.DeviceOrderGiven(_ORDERS[DeviceOrder(int(numbers[1]))], tuple(numbers[2:].tolist()))


def _family(wrong: BaseException) -> str:
    if isinstance(wrong, AskAgain):
        return "ask_again"
    if isinstance(wrong, LawBroken):
        return "law_broken"
    return "module_error" if isinstance(wrong, ModuleError) else ""


def _not_bound() -> None:
    raise ValueError("expected a module that is bound, found none")
