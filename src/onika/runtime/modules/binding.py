"""A module instance bound to its task: buffers for its ports, its LOCAL parameters, its device (laws 2, 16)."""

import math
import random
from collections.abc import Callable, Mapping
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from onika.model import parameter
from onika.ring.device import DeviceSheet
from onika.ring.slots import Ring
from onika.runtime.command import DeviceGrant, Spawn
from onika.runtime.declaration import PortDeclaration, memory_slot, slot
from onika.runtime.device import Device
from onika.runtime.modules.module import Module
from onika.runtime.picture import picture_size
from onika.words.name import SVAR_NAME
from onika.words.reason import Reason
from onika.words.shape import Shape

if TYPE_CHECKING:
    from numpy.typing import NDArray

Views = Mapping[str, memoryview]
"""Shared memory by name: `table:SUBSYSTEM`, `bus:WORLD`."""


class CycleInput(NamedTuple):
    """What a port takes in before each cycle: variable, its ring, the bytes of the module's copy."""

    svar: str
    ring: Ring
    data: memoryview


class CycleOutput(NamedTuple):
    """What a port gives out after each cycle: variable, its ring, the bytes of the module's copy, its newest count."""

    svar: str
    ring: Ring
    data: memoryview
    own: list[int]


class Binding:
    """Ports of one instance: functions that copy in and out, and the rings behind them.

    Raises ValueError for a port without an entry, and then has changed nothing. Buffers of a `former` binding of the
    same instance hand on what they hold where the shape is the same.
    """

    def __init__(self, instance: Module, spawn: Spawn, views: Views, former: "Binding | None" = None) -> None:
        self.instance = instance
        self.values: list[tuple[str, Shape, NDArray[Any]]] = []
        self._shown: dict[str, NDArray[Any]] = {}
        self.rings: dict[str, Ring] = {}
        self._counts: list[tuple[str, memoryview]] = []
        self._real_inputs: list[tuple[str, memoryview]] = []
        self.read_each_cycle: list[tuple[str, PortDeclaration, str, NDArray[Any], Ring]] = []
        """The real inputs but constants: port, as declared, variable, buffer, ring."""
        self.cycle_inputs: list[CycleInput] = []
        self.cycle_outputs: list[CycleOutput] = []
        self._published: dict[str, NDArray[Any]] = {}
        self._real_outputs: list[tuple[str, memoryview]] = []
        self._copies: dict[str, list[Callable[[], Any]]] = {"init_in": [], "init_out": [], "in": [], "out": []}
        self.preloads: list[Callable[[], Any]] = []
        self.constants_out: list[Callable[[], Any]] = []
        self._on_out: list[tuple[NDArray[Any], Callable[[], Any]]] = []
        self._preloaded: list[bytes] = []
        self._looks: list[Callable[[], Any]] = []
        self._written: list[Ring] = []
        self.input_rings: list[Ring] = []
        self.first_values: list[tuple[str, Ring]] = []
        table = views[f"table:{spawn.subsystem}"]
        bound = {port.port: port for port in spawn.ports}
        for attribute, declared in type(instance).declared_ports.items():
            port = declared.port(attribute)
            if port.name not in bound:
                raise ValueError(Reason.of("runtime.entry_missing", port=port.name))
            entry = bound[port.name]
            shape = Shape.parse(entry.shape)
            ring = Ring(table, entry.offset, shape.size)
            self.rings[entry.svar] = ring
            self._counts.append((port.name, ring.words))
            self.values.append((port.name, shape, _buffer(shape)))
            self._bind(attribute, entry.svar, declared.kind.value, shape, ring)
        if former is not None:
            self._take_values(former)
        for attribute, shown in self._shown.items():
            setattr(instance, slot(attribute), shown)
            if shown.ndim == 1 and shown.flags.writeable:
                setattr(instance, memory_slot(attribute), shown.data)
        self.looks_at = tuple(dict.fromkeys([*self._copies["init_in"], *self._copies["in"]]))

    def _bind(self, attribute: str, svar: str, kind: str, shape: Shape, ring: Ring) -> None:
        flat = self.values[-1][2]
        data = flat.data.cast("B")
        is_flat = shape.type.is_text or not shape.dims
        shown = flat if is_flat else flat.reshape(shape.dims)  # type: ignore[arg-type]  # is_flat says they are there
        if kind.startswith("IN"):
            fetch = ring.refresher(data)
            shown = shown.view()
            shown.flags.writeable = False
            self._add(kind, "in", fetch)
            if kind != "INCONST":
                self.cycle_inputs.append(CycleInput(svar, ring, data))
            if kind == "INBOTH":
                self.first_values.append((svar, ring))
            if kind != "INCONST":
                self.input_rings.append(ring)
                if shape.type.is_real:
                    self._real_inputs.append((svar, flat.data))
                    declared = type(self.instance).declared_ports[attribute]
                    self.read_each_cycle.append((declared.name or attribute, declared, svar, flat, ring))
        else:
            signed = ring.signed_writer(data)
            self._add(kind, "out", signed.publish)
            if kind != "OUTCONST":
                self.cycle_outputs.append(CycleOutput(svar, ring, data, signed.own))
            self._looks.append(signed.look)
            self._written.append(ring)
            if kind == "OUTCONST":
                self.constants_out.append(signed.publish)
            else:
                self._on_out.append((flat, signed.publish))
            if shape.type.is_real and kind != "OUTCONST":
                self._real_outputs.append((svar, flat.data))
                self._published[svar] = flat
            if kind != "OUTCONST":
                self.preloads.append(ring.reader(data))
        self._shown[attribute] = shown

    def _take_values(self, former: "Binding") -> None:
        before = {name: (shape, data) for name, shape, data in former.values}
        for name, shape, data in self.values:
            if name in before and before[name][0] == shape:
                data[:] = before[name][1]

    def _add(self, kind: str, way: str, copy: Callable[[], Any]) -> None:
        if not kind.endswith("VAR"):
            self._copies[f"init_{way}"].append(copy)
        if not kind.endswith("CONST"):
            self._copies[way].append(copy)

    def copies(self, which: str) -> list[Callable[[], Any]]:
        """The copy functions of `init_in`, `init_out`, `in` or `out`."""
        return self._copies[which]

    def preload(self) -> None:
        """Own outputs from the table; what others wrote until now was their right."""
        for preload in self.preloads:
            preload()
        self.look()
        self._preloaded = [data.tobytes() for data, _ in self._on_out]

    def look(self) -> None:
        """From now on nobody else writes the outputs (the check of integrity tells if somebody does)."""
        for look in self._looks:
            look()

    def publish_changed(self) -> None:
        """The outputs that are not what was preloaded: what `on` has not written does not count as written (law 4)."""
        for (data, publish), before in zip(self._on_out, self._preloaded, strict=True):
            if data.tobytes() != before:
                publish()

    def seal(self) -> None:
        """Seal the outputs' present values, long ones too (requirement A12)."""
        for ring in self._written:
            ring.seal()

    def rest(self) -> None:
        """The outputs rest: seal their present values; until a task takes them up nobody writes them."""
        for ring in self._written:
            ring.rest()

    def not_finite(self) -> list[str]:
        """The variables among the real inputs that hold NaN or infinity (law 5)."""
        for _, values in self._real_inputs:
            if not math.isfinite(sum(values)):
                return [svar for svar, numbers in self._real_inputs if not math.isfinite(sum(numbers))]
        return []

    def real_outputs(self) -> dict[str, "NDArray[Any]"]:
        """The buffers of the real outputs but constants, by variable."""
        return self._published

    def not_finite_outputs(self) -> list[str]:
        """The variables among the real outputs whose newest value holds NaN or infinity."""
        return [svar for svar, values in self._real_outputs if not math.isfinite(sum(values))]

    def in_force(self) -> frozenset[str]:
        """The ports whose present value still steers something (law 3)."""
        return frozenset([port for port, words in self._counts if words[0] > words[1]])


def instantiate(cls: type[Module], spawn: Spawn, views: Views) -> Module:
    """A fresh instance with time, chance, device and parameters; raises ValueError for a bad LOCAL line."""
    instance = cls()
    Module.__init__(instance)  # once more: a class with an __init__ of its own may have forgotten it
    instance.dt = 1.0 / spawn.frequency if spawn.frequency else 0.0
    instance.random = random.Random(f"{spawn.seed}/{spawn.subsystem}/{spawn.task}")  # noqa: S311 - simulation, no secret
    if spawn.device is not None:
        instance.device = attach(spawn.device, views)
    give_locals(instance, locals_of(cls, dict(spawn.local)))
    return instance


def give_locals(instance: Module, parameters: SimpleNamespace) -> None:
    """Set the parameters on an instance."""
    for name, value in vars(parameters).items():
        setattr(instance, name, value)


def attach(grant: DeviceGrant, views: Views) -> Device:
    """The task's end of a granted device."""
    view = views[grant.segment]
    sheet = DeviceSheet(grant.name, grant.state, grant.command, grant.identity, grant.picture)
    state = Ring(view, grant.state_offset, 8 * len(sheet.state))
    picture = Ring(view, grant.picture_offset, picture_size(grant.picture)) if grant.picture else None
    if grant.command_offset is None:
        return Device(sheet, grant.epoch, state, None, picture)
    command = Ring(view, grant.command_offset, 8 * (2 + len(sheet.command)))
    return Device(sheet, grant.epoch, state, command)


def locals_of(cls: type[Module], lines: Mapping[str, tuple[str, ...]]) -> SimpleNamespace:
    """The parameters a class declares, from the lines of a LOCAL block; raises ValueError that says what is wrong."""
    constants = SimpleNamespace()
    for name, declared in cls.declared_locals.items():
        if name in lines:
            setattr(constants, name, parameter.parse(name, declared.shape, lines[name]))
        elif declared.default is None:
            line = {"name": name, "shape": str(declared.shape), "meaning": declared.meaning}
            raise ValueError(Reason.of("runtime.local_missing", **line))
        else:
            setattr(constants, name, declared.default)
    return constants


def _buffer(shape: Shape) -> "NDArray[Any]":
    return np.zeros(shape.count * (shape.type.size if shape.type.is_text else 1), dtype=shape.type.code)


def undeclared(instance: Module) -> list[str]:
    """Attributes that look like state variables but are no port or parameter: typing mistakes that write nothing."""
    declared_locals = set(type(instance).declared_locals)
    return sorted(
        name for name in vars(instance) if SVAR_NAME.match(name) and len(name) > 1 and name not in declared_locals
    )
