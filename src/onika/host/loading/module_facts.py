"""What is learnt of module code by executing it: sheets, constants, reach. Called in the loader's process only."""

from collections.abc import Callable, Iterable, Mapping
from contextlib import AbstractContextManager, nullcontext
from time import perf_counter_ns
from typing import Any

import numpy as np

from onika.host.units.world_registry import (
    faults_of,
    is_of_files,
    is_simulated,
    open_world,
    world_faults,
)
from onika.host.units.world_sources import WorldSources
from onika.runtime.bus import World
from onika.runtime.modules.binding import locals_of
from onika.runtime.modules.code import line_in, load, sayable, traceback_text
from onika.runtime.modules.module import Module
from onika.runtime.modules.sheet import sheet_of
from onika.wire.plan import Code
from onika.wire.sheet import ModuleSheet
from onika.wire.world_source import WorldSource
from onika.words.fault import Fault, Place
from onika.words.module_sentence import of_sentence
from onika.words.reason import NOTHING, Reason, as_reason, reason_of

_SLOW_NS = 300_000_000

Lines = tuple[tuple[str, tuple[str, ...]], ...]


class ModuleFacts:
    """Executes module code in this process."""

    def __init__(self, watch: Callable[[], AbstractContextManager[None]] = nullcontext) -> None:
        self._worlds: dict[str, World] = {}
        self._sources = WorldSources()
        self._watch = watch

    def sheet(self, code: Code) -> ModuleSheet | Fault:
        """The sheet of a module's class."""
        cls = self._load(code)
        if isinstance(cls, Fault):
            return cls
        try:
            return sheet_of(cls)
        except ValueError as wrong:
            return self._fault(code, Reason.of("host.declarations_disagree", why=traceback_text(wrong)), wrong)

    def cost_ns(self, code: Code) -> int:
        """How long the module takes to load once more, when its libraries are there; the quickest of three times."""
        times = []
        for _ in range(3):
            began = perf_counter_ns()
            self._load(code)
            times.append(perf_counter_ns() - began)
            if times[-1] > _SLOW_NS:
                break  # it is too slow to be loaded in a gap in any case
        return min(times)

    def expect(self, codes: tuple[Code, ...]) -> None:
        """Answers are made at once, nothing is prepared."""

    def constants(self, code: Code, local: Lines) -> dict[str, Any] | Fault:
        """A robot module's constants from its LOCAL lines and its device, as plain lists and numbers."""
        cls = self._load(code)
        if isinstance(cls, Fault):
            return cls
        try:
            lines = dict(local)
            devices = lines.get("DEVICE", ())
            identity = self._identity(devices[0]) if devices else None
            constants = cls.constants(locals_of(cls, lines), identity or {})
            return {name: _plain(value) for name, value in constants.items()}
        except Exception as wrong:
            return self._fault(code, Reason.of("host.constants_failed", why=traceback_text(wrong)), wrong)

    def offer(self, worlds: Iterable[WorldSource]) -> None:
        """These worlds are files."""
        for files in self._sources.take(worlds):
            self._worlds.pop(files.world, None)

    def world_faults(self, world: str) -> tuple[Fault, ...]:
        """All that is wrong with the files of a world; nothing where it is made of none."""
        files = self._sources.find(world)
        if files is None or not is_of_files(world, files):
            return ()
        try:
            return faults_of(self._world(files.world))
        except Exception:
            return self._why_unopened(world, files)

    def _why_unopened(self, world: str, files: WorldSource) -> tuple[Fault, ...]:
        try:
            return world_faults(files)
        except Exception as wrong:
            return (Fault(Place(world), reason_of(wrong), Reason.of("host.no_device_used")),)

    def devices(self, world: str) -> tuple[str, ...] | Fault:
        """The devices of a world."""
        try:
            return tuple(sheet.name for sheet in self._world(world).devices())
        except Exception as wrong:
            return Fault(Place(world), reason_of(wrong), Reason.of("host.no_device_used"))

    def is_simulated(self, world: str) -> bool | Fault:
        """Whether a world is simulated; it is not opened for that."""
        try:
            return is_simulated(world, self._sources.find(world))
        except Exception as wrong:
            return Fault(Place(world), reason_of(wrong), Reason.of("host.no_device_used"))

    def resolve(
        self, code: Code, constants: dict[str, Any], targets: list[tuple[str, list[Any]]]
    ) -> list[Reason | None] | Fault:
        """Why each target is out of reach, or None."""
        cls = self._load(code)
        if isinstance(cls, Fault):
            return cls
        try:
            reasons = cls.resolve(constants, list(targets))
            return [None if reason is None else _module_reason(reason, code) for reason in reasons]
        except Exception as wrong:
            return self._fault(code, Reason.of("host.reach_failed", why=traceback_text(wrong)), wrong)

    def poses(
        self, code: Code, constants: dict[str, Any], targets: list[list[Any]]
    ) -> list[list[float]] | Fault | None:
        """The Cartesian targets that joint targets are for a robot module; None: it knows of no poses."""
        cls = self._load(code)
        if isinstance(cls, Fault):
            return cls
        try:
            poses = cls.poses(constants, list(targets))
            if poses is None:
                return None
            return [[float(number) for number in pose] for pose in poses]
        except Exception as wrong:
            return self._fault(code, Reason.of("host.poses_failed", why=traceback_text(wrong)), wrong)

    def postures(
        self, code: Code, constants: dict[str, Any], poses: list[list[float]]
    ) -> list[list[float] | Reason] | Fault | None:
        """Joint values for Cartesian targets, each nearest to those before it, or why there are none."""
        cls = self._load(code)
        if isinstance(cls, Fault):
            return cls
        try:
            postures = cls.postures(constants, list(poses))
            if postures is None:
                return None
            return [_posture(posture, code) for posture in postures]
        except Exception as wrong:
            return self._fault(code, Reason.of("host.postures_failed", why=traceback_text(wrong)), wrong)

    def fits(self, code: Code, constants: dict[str, Any], device: str) -> Reason | Fault:
        """Why a device is not the one that a hardware module means; NOTHING: nothing is wrong."""
        cls = self._load(code)
        if isinstance(cls, Fault):
            return cls
        try:
            identity = self._identity(device)
            if identity is None:
                return NOTHING
            return _module_reason(cls.fits(constants, dict(identity)) or NOTHING, code)
        except Exception as wrong:
            return self._fault(code, Reason.of("host.fit_failed", why=traceback_text(wrong)), wrong)

    def company(self, world: str, devices: tuple[str, ...], *, is_of_flow: bool = False) -> tuple[Reason, ...] | Fault:
        """Why these devices of a world cannot be used together, or are odd in one flow; none: nothing is said."""
        try:
            ask = getattr(self._world(world), "remarks" if is_of_flow else "objections", None)
            return () if ask is None else tuple(as_reason(remark) for remark in ask(devices))
        except Exception:
            return ()  # a world that cannot be opened is told with its devices

    def _load(self, code: Code) -> type[Module] | Fault:
        with self._watch():
            return load(code.source, code.path, code.module)

    def _identity(self, device: str) -> Mapping[str, Any] | None:
        """What a device says of itself; None where there is none such, as is told elsewhere."""
        world, _, name = device.partition(":")
        try:
            devices = self._world(world).devices()
        except Exception:
            return None
        return next((device.identity for device in devices if device.name == name), None)

    def _world(self, name: str) -> World:
        """A world that is only looked at: nothing is claimed in it, and it never passes any time."""
        if name not in self._worlds:
            self._worlds[name] = open_world(name, files=self._sources.find(name))
        return self._worlds[name]

    def _fault(self, code: Code, reason: Reason, wrong: Exception) -> Fault:
        place = Place(code.path, line_in(code.path, wrong))
        return Fault(place, reason, Reason.of("host.module_not_used", module=code.module))


def _posture(posture: Any, code: Code) -> list[float] | Reason:
    """The values of a posture, or why there is none."""
    if isinstance(posture, str | Reason):
        return _module_reason(posture, code)
    return [float(value) for value in posture]


def _module_reason(sentence: str | Reason, code: Code) -> Reason:
    return sayable(of_sentence(sentence, {}), code.module)


def _plain(value: Any) -> Any:
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, list | tuple):
        return [_plain(element) for element in value]
    return value
