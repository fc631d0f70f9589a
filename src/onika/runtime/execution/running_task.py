"""A running task: one instance of a module, its state, its cycle and its counters (laws 2 to 5)."""

from collections.abc import Callable, Iterable
from time import perf_counter_ns
from types import SimpleNamespace

from msgspec import structs

from onika.model.lifecycle import LifecycleInput, State, after
from onika.model.rules.order import Ports
from onika.model.signal import Signal, off
from onika.runtime.command import BoundPort, Spawn
from onika.runtime.counters import Counters
from onika.runtime.device import Device
from onika.runtime.error import ModuleError
from onika.runtime.modules.binding import Binding, Views, give_locals, instantiate, locals_of
from onika.runtime.modules.binding_guard import BindingGuard
from onika.runtime.modules.module import Module
from onika.runtime.modules.sheet import sheet_of
from onika.runtime.partner.absence import without_partner
from onika.runtime.partner.partner import Partner
from onika.runtime.period import SLOWEST_GRID_NS, period_of
from onika.runtime.sandbox.sandboxed_module import SandboxedModule
from onika.runtime.scheduler import TaskSlot
from onika.runtime.transfer.input_guard import InputGuard
from onika.runtime.user_input import UserInput
from onika.words.reason import Reason, reason_of

CHECKED_EVERY = 1023
"""Once in 1024 cycles, so that it costs nothing, a task is looked at: whether its module is still what was bound.

A task below a kilohertz is looked at about once a second; each is when it comes on, and when it has gone off.
"""


class RunningTask:
    """Carries out entry points in the order of the law; its owner decides when, and what an exception means."""

    def __init__(self, spawn: Spawn, cls: type[Module], views: Views) -> None:
        self.spawn = spawn
        self.tid = 0
        self.activation = 0
        self.line = ""
        self.state = State.WAITING
        self.module = instantiate(cls, spawn, views)
        self.binding = self._bound(spawn, views, None)
        self.binding_guard = BindingGuard(self.module)
        self.hardware = cls.hardware
        self.passive = cls.passive
        self.trigger = cls.trigger
        self.period_ns = SLOWEST_GRID_NS if spawn.frequency is None else period_of(spawn.frequency)
        self.slot = TaskSlot(self.key, self.period_ns)
        self.counters, self.last_profile = Counters(), Counters()
        self.is_first = False
        self.is_looked_at = False
        """Whether its first cycle was one after which its module was looked at."""
        self.goes_on = False
        self.is_initialised = False
        self.init_took_ns = 0
        self.warnings = self.module.warnings
        self.is_periodic = spawn.task_type == "periodic"
        self.is_synchronous = spawn.task_type == "synchronous"
        self.address = (spawn.subsystem, spawn.task)
        """Subsystem and name."""
        self.frequency = spawn.frequency
        """The present rate in hertz."""
        self._reads = self.binding.copies("in")
        self._writes = self.binding.copies("out")
        self.check_mask = _cycles_to_check(spawn.frequency)
        """The bits of the number of cycles that are 0 when the module is looked at."""
        self._views = views
        self.watch_words = views[f"table:{spawn.subsystem}"][:8].cast("q")
        """Up to when inputs of hardware of its subsystem are watched (law 33)."""
        declared = (port.port(name) for name, port in cls.declared_ports.items())
        self._moved = tuple((port.name, port.kind.is_input) for port in declared if port.kind.at_cycle)
        """The ports whose values move in every cycle, as loaded: a sick module may change what it declares."""
        self._wanted = cls.declared_inputs
        self._input: UserInput | None = None
        self.input_guard = self._make_input_guard() if cls.hardware else None
        """Of a hardware task: how it is given its inputs."""

    @property
    def device(self) -> Device | None:
        """The task's device, if it has one."""
        if self.spawn.device is not None:
            return self.module.device
        return None

    @property
    def partner(self) -> Partner | None:
        """The outside program that the task talks with, if it has one."""
        return self.module.partner

    @property
    def is_owed(self) -> bool:
        """Whether its partner owes it an answer."""
        partner = self.module.partner
        return partner is not None and partner.is_awaited

    @property
    def is_settled(self) -> bool:
        """Whether something has come of its question that it has not been told yet."""
        partner = self.module.partner
        return partner is not None and partner.is_settled

    @property
    def asks(self) -> bool:
        """Whether it asks at its rate, and goes on with the answer: synchronous with a partner."""
        return self.is_synchronous and self.module.partner is not None

    @property
    def is_on(self) -> bool:
        """Whether it is ON."""
        return self.state is State.ON

    @property
    def is_driving(self) -> bool:
        """Whether it is ON and passes its inputs on to its device."""
        return self.is_on and self.input_guard is not None and not self.input_guard.is_waiting

    @property
    def key(self) -> tuple[int, int, str]:
        """Its place among tasks with the same deadline (law 1)."""
        return -type(self.module).crit, self.spawn.rank, f"{self.spawn.subsystem}/{self.spawn.task}"

    @property
    def data_flow(self) -> Ports:
        """The variables that it reads and writes in every cycle."""
        bound = {port.port: port.svar for port in self.spawn.ports}
        reads = tuple(bound[name] for name, is_input in self._moved if is_input)
        writes = tuple(bound[name] for name, is_input in self._moved if not is_input)
        return Ports(self.spawn.task, invar=reads, outvar=writes)

    def step(self, step: LifecycleInput) -> None:
        """Change state as the table of lifecycles says."""
        self.state = after(self.state, step)

    # Entry points, in the order of the law

    def init(self) -> None:
        """Constants in, `init`, constants out."""
        self.prepare(self.module.init)
        self.publish_constants()

    def reinit(self) -> None:
        """Constants in, `reinit`, constants out; where it raises, the task counts as not initialised."""
        self.is_initialised = False
        self.prepare(self.module.reinit)
        self.publish_constants()

    def prepare(self, entry: Callable[[], None]) -> None:
        """All of `init` or `reinit` but what others see of it."""
        for svar, ring in self.binding.first_values:
            if not ring.count:
                self.module.warn(Reason.of("runtime.never_written", svar=svar))
        for read in self.binding.copies("init_in"):
            read()
        began = perf_counter_ns()
        entry()
        self.init_took_ns = perf_counter_ns() - began
        if self.module.partner is not None:
            self.module.partner.task = f"{self.spawn.subsystem}/{self.spawn.task}"
        self.no_strays()
        if self._wanted:
            self._input = UserInput(sheet_of(type(self.module)).inputs, self._constants())
        if self.input_guard is not None:
            self.input_guard.prepare()
        self.is_initialised = True

    def publish_constants(self, first_values: bool = True) -> None:
        """Constants out; first values too, unless a cycle has written them long since."""
        self.binding.look()
        for write in self.binding.copies("init_out") if first_values else self.binding.constants_out:
            write()
        self.binding.seal()

    def rebind(self, ports: Iterable[BoundPort], local: tuple[tuple[str, tuple[str, ...]], ...] | None) -> None:
        """Bind these ports anew and take other parameters; raises ValueError and then has changed nothing."""
        bound = {port.port: port for port in (*self.spawn.ports, *ports)}
        spawn = structs.replace(self.spawn, ports=tuple(bound.values()))
        if local is not None:
            spawn = structs.replace(spawn, local=local)
        parameters = locals_of(type(self.module), dict(spawn.local))
        self.binding = self._bound(spawn, self._views, self.binding)
        former, self.binding_guard = self.binding_guard.known, BindingGuard(self.module)
        self.binding_guard.known = former
        if local is not None:
            give_locals(self.module, parameters)
        self.spawn = spawn
        self._reads, self._writes = self.binding.copies("in"), self.binding.copies("out")
        if self.input_guard is not None:
            self.input_guard.bind(self.binding)
        self.is_initialised = False

    def clear(self) -> None:
        """`clear`, and `init` where that has not succeeded yet."""
        self.module.clear()
        if not self.is_initialised:
            self.init()

    def change_rate(self, frequency: float) -> int:
        """Another rate in hertz from the next cycle on; the new period. Raises ValueError where there is none."""
        self.period_ns = period_of(frequency)
        self.frequency = frequency
        self.module.dt = 1.0 / frequency
        self.check_mask = _cycles_to_check(frequency)
        if self.input_guard is not None:
            self.input_guard.change_rate(self.period_ns)
        return self.period_ns

    def on(self, now: int, inputs: SimpleNamespace) -> None:
        """All inputs in, own outputs preloaded, `on`, out."""
        self.begin(now, inputs)
        self.publish()

    def begin(self, now: int, inputs: SimpleNamespace) -> None:
        """All of `on` but what others see of it."""
        self.look()
        if self.module.partner is not None:
            self.module.partner.begin()
        if self.input_guard is not None:
            if self.device is None:
                raise ModuleError(Reason.of("runtime.no_device"))
            self.input_guard.begin(now)
        self.module.on(inputs)

    def look(self) -> None:
        """All inputs in, own outputs preloaded from the table."""
        for read in self.binding.looks_at:
            read()
        self.binding.preload()
        self.module.in_force = self.binding.in_force()

    def publish(self) -> None:
        """Outputs that `on` changed out."""
        self.binding.publish_changed()
        self.is_first, self.is_looked_at = True, False

    def cycle(self, now: int) -> Signal | None:
        """Copy in, cycle, copy out, times."""
        began = perf_counter_ns()
        if self.input_guard is None:
            for read in self._reads:
                read()
            self.module.now = now * 1e-9
            signal = self.module.cycle()
        elif self.input_guard.take_in(now):
            signal = self.module.cycle()
        else:
            self.module.hold()
            signal = None
        for write in self._writes:
            write()
        took, counters = perf_counter_ns() - began, self.counters
        if not counters.cycles & self.check_mask:
            self.no_strays()
            self.is_looked_at = True
        counters.total_ns += took  # as Counters.add, without a call: this runs thousands of times a second
        counters.cycles += 1
        if took > counters.most_ns:  # noqa: PLR1730 - a call of max would cost as much again
            counters.most_ns = took
        if took < counters.least_ns or counters.cycles == 1:
            counters.least_ns = took
        return signal

    def event(self, now: int) -> Signal | None:
        """The event of a synchronous task has come: as a cycle, through `sync`.

        Where it has a partner, the event may be nothing yet, and what comes of a question may be that it has none: then
        a passive task falls silent, and any other has a fault.
        """
        began = perf_counter_ns()
        if self.module.partner is not None:
            try:
                if not self.module.partner.has_answered():
                    return None
            except ModuleError as missing:
                if without_partner(self.passive) is LifecycleInput.FAIL:
                    raise
                self.module.warn(Reason.of("runtime.goes_off", why=reason_of(missing)))
                return off()
        for read in self._reads:
            read()
        self.module.now = now * 1e-9
        signal = self.module.sync()
        for write in self._writes:
            write()
        self.counters.add(perf_counter_ns() - began)
        return signal

    def off(self) -> None:
        """`off`; a device is put in hold; outputs are not published; is the module still what was bound?"""
        self.leave()
        self.no_strays()

    def leave(self) -> None:
        """All of `off` but the look at what has become of the module."""
        try:
            self.module.off()
        finally:
            self.hold()
            self.binding.rest()
            if self.module.partner is not None:
                self.module.partner.rest()

    def hold(self) -> None:
        """Put the task's device in hold, whatever its module thinks."""
        if self.spawn.device is not None:
            self.module.device.hold()
        if self.input_guard is not None:
            self.input_guard.rest()

    def part(self) -> None:
        """The task is gone: so are the connection to its partner and the program it started."""
        if self.module.partner is not None:
            self.module.partner.close()

    def parse(self, line: str) -> SimpleNamespace:
        """The user input of an argument line; raises ValueError where it cannot be used."""
        if self._input is None:
            return SimpleNamespace()
        return self._input.parse(line)

    @property
    def input(self) -> UserInput | None:
        """What the task asks for, once it is initialised."""
        return self._input

    def no_strays(self) -> None:
        """Raises Strayed where the module is no more what was bound, or writes what is no port."""
        self.binding_guard.check()

    # Inner

    def _bound(self, spawn: Spawn, views: Views, former: Binding | None) -> Binding:
        binding = Binding(self.module, spawn, views, former)
        if isinstance(self.module, SandboxedModule):
            self.module.bound_to(binding)
        return binding

    def _make_input_guard(self) -> InputGuard:
        table = self._views[f"table:{self.spawn.subsystem}"]
        input_guard = InputGuard(self.spawn.subsystem, self.spawn.task, self.module, self.period_ns, table)
        input_guard.bind(self.binding)
        return input_guard

    def _constants(self) -> dict[str, object]:
        cls = type(self.module)
        return {
            declared.port(attribute).name: getattr(self.module, attribute)
            for attribute, declared in cls.declared_ports.items()
            if declared.kind.at_init and declared.kind.is_input
        }


def _cycles_to_check(frequency: float | None) -> int:
    """A mask of the number of cycles: between two checks lies about a second; no rate: each cycle is checked."""
    if frequency is None:
        return 0
    return min((1 << int(frequency).bit_length()) - 1, CHECKED_EVERY)
