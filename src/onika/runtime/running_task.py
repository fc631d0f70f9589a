"""A running task: one instance of a module, its state, its cycle and its counters (laws 2 to 5)."""

import traceback
from time import perf_counter_ns
from types import SimpleNamespace

from onika.model.lifecycle import State, Step, after
from onika.model.signal import Signal
from onika.runtime.agenda import Slot
from onika.runtime.binding import Binding, Views, instantiate, undeclared
from onika.runtime.code import told
from onika.runtime.command import Spawn
from onika.runtime.device import SILENCE_NS, Device
from onika.runtime.module import Module, ModuleError
from onika.runtime.sheet import sheet_of
from onika.runtime.user_input import UserInput


class Counters:
    """What is counted since the last status."""

    __slots__ = ("cycles", "least_ns", "most_ns", "since_ns", "total_ns", "warnings")

    def __init__(self, now: int) -> None:
        self.since_ns = now
        self.cycles = 0
        self.warnings = 0
        self.total_ns = 0
        self.least_ns = 0
        self.most_ns = 0

    def add(self, took_ns: int) -> None:
        """One more cycle."""
        self.total_ns += took_ns
        if took_ns > self.most_ns:  # noqa: PLR1730 - a call of max would cost more than the rest of this function
            self.most_ns = took_ns
        if took_ns < self.least_ns or not self.cycles:
            self.least_ns = took_ns
        self.cycles += 1


class RunningTask:
    """Carries out entry points in the order of the law; its owner decides when, and what an exception means."""

    def __init__(self, spawn: Spawn, cls: type[Module], views: Views, now: int) -> None:
        self.spawn = spawn
        self.state = State.WAITING
        self.module = instantiate(cls, spawn, views)
        self.binding = Binding(self.module, spawn, views)
        self.hardware = cls.hardware
        self.passive = cls.passive
        self.trigger = cls.trigger
        self.period_ns = round(1e9 / spawn.frequency) if spawn.frequency else 1_000_000_000
        name = f"{spawn.subsystem}/{spawn.task}"
        self.slot = Slot((-cls.crit, spawn.rank, name), self.period_ns)
        self.counters = Counters(now)
        self.is_first = False
        self.warnings = self.module.warnings
        self.is_periodic = spawn.task_type == "periodic"
        self._reads = self.binding.copies("in")
        self._writes = self.binding.copies("out")
        self._work = self.module.cycle
        self._wanted = cls.declared_inputs
        self._input: UserInput | None = None
        self._waits_for_fresh = False
        self._marks: list[int] = []

    @property
    def device(self) -> Device | None:
        """The task's device, if it has one."""
        return self.module.device if self.spawn.device is not None else None

    def step(self, step: Step) -> None:
        """Change state as the table of lifecycles says."""
        self.state = after(self.state, step)

    # Entry points, in the order of the law

    def init(self) -> None:
        """Constants in, `init`, constants out."""
        for read in self.binding.copies("init_in"):
            read()
        self.module.init()
        self._no_strays()
        for write in self.binding.copies("init_out"):
            write()
        if self._wanted:
            self._input = UserInput(sheet_of(type(self.module)).inputs, self._constants())

    def on(self, now: int, inputs: SimpleNamespace) -> None:
        """All inputs in, own outputs preloaded, `on`, out."""
        self.module.now = now * 1e-9
        for read in self.binding.copies("init_in"):
            read()
        for read in self._reads:
            read()
        for preload in self.binding.preloads:
            preload()
        self.module.in_force = self._in_force()
        if self.hardware:
            self._begin_hold(now)
        self.module.on(inputs)
        self._no_strays()
        for write in self._writes:
            write()
        self.is_first = True

    def cycle(self, now: int) -> Signal | None:
        """Copy in, cycle, copy out, times."""
        began = perf_counter_ns()
        for read in self._reads:
            read()
        self.module.now = now * 1e-9
        signal = self._hardware_cycle(now) if self.hardware else self._work()
        for write in self._writes:
            write()
        self.counters.add(perf_counter_ns() - began)
        return signal

    def event(self, now: int) -> Signal | None:
        """The event of a synchronous task has come: as a cycle, through `sync`."""
        began = perf_counter_ns()
        for read in self._reads:
            read()
        self.module.now = now * 1e-9
        signal = self.module.sync()
        for write in self._writes:
            write()
        self.counters.add(perf_counter_ns() - began)
        return signal

    def off(self) -> None:
        """`off`; a device is put in hold; outputs are not published."""
        try:
            self.module.off()
        finally:
            self.hold()

    def hold(self) -> None:
        """Put the task's device in hold, whatever its module thinks."""
        if self.device is not None:
            self.device.hold()

    def parse(self, line: str) -> SimpleNamespace:
        """The user input of an argument line; raises ValueError where it cannot be used."""
        if self._input is None:
            return SimpleNamespace()
        return self._input.parse(line)

    @property
    def input(self) -> UserInput | None:
        """What the task asks for, once it is initialised."""
        return self._input

    def strays(self) -> str:
        """What is wrong with attributes that look like ports and are none; empty if there are none."""
        names = undeclared(self.module)
        return f"{', '.join(names)} is no port of this module: declare it or use another name" if names else ""

    def where(self, wrong: BaseException) -> tuple[str, int, str]:
        """File and line in which the module's code raised, and the traceback from there on."""
        frames = traceback.extract_tb(wrong.__traceback__)
        own = [index for index, frame in enumerate(frames) if frame.filename == self.spawn.path]
        if not own:
            return self.spawn.path, 0, told(wrong)
        lines = traceback.format_list(frames[own[0] :])
        return self.spawn.path, frames[own[-1]].lineno or 0, "".join([*lines, told(wrong)])

    # Hardware

    def _begin_hold(self, now: int) -> None:
        device = self.device
        if device is None:
            raise ModuleError("a hardware task needs a device")
        self._marks = [ring.count for ring in self.binding.input_rings]
        self._waits_for_fresh = bool(self._marks)
        device.holding(self._waits_for_fresh)
        device.listen_from(now)

    def _hardware_cycle(self, now: int) -> Signal | None:
        device = self.module.device
        if device.silent_ns(now) > SILENCE_NS:
            raise ModuleError(f"device {device.sheet.name} has published nothing for {SILENCE_NS // 1_000_000} ms")
        bad = self.binding.not_finite()
        if bad:
            raise ModuleError(f"expected finite inputs, found NaN or infinity in {', '.join(bad)}")
        if self._waits_for_fresh:
            rings = self.binding.input_rings
            self._waits_for_fresh = any(ring.count == mark for ring, mark in zip(rings, self._marks, strict=True))
            device.holding(self._waits_for_fresh)
            if self._waits_for_fresh:
                self.module.hold()
                return None
        return self._work()

    # Inner

    def _constants(self) -> dict[str, object]:
        cls = type(self.module)
        return {
            declared.port(attribute).name: getattr(self.module, attribute)
            for attribute, declared in cls.declared_ports.items()
            if declared.kind.at_init and declared.kind.is_input
        }

    def _in_force(self) -> frozenset[str]:
        live = self.binding.in_force()
        return frozenset(one.port for one in self.spawn.ports if one.svar in live)

    def _no_strays(self) -> None:
        strays = self.strays()
        if strays:
            raise ModuleError(strays)
