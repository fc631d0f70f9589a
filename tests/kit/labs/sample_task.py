"""A sample task that can be written both ways, as the law sees it and as the source of a module."""

from dataclasses import dataclass

from onika.model.signal import Signal, finish, off
from oracle.law_task import Entry, LawTask, Moment

MS = 1_000_000
_TAKE = """
    @traced
    def take(self, old):
        self.n, self.k = old.n, old.k
        self.first("take")
"""


@dataclass(frozen=True)
class SampleTask:
    """What a probe does: counts its cycles, adds its inputs to its outputs, and misbehaves where it is told to."""

    name: str
    period: int = 10 * MS
    crit: int = 0
    rank: int = 0
    cost: int = 0
    device: str = ""
    inconst: tuple[str, ...] = ()
    outconst: tuple[str, ...] = ()
    invar: tuple[str, ...] = ()
    outvar: tuple[str, ...] = ()
    is_periodic: bool = True
    finish_after: int = 0  # cycles since on
    off_after: int = 0
    fail_at: int = 0  # cycles in all
    nan_at: int = 0
    mends: bool = False
    fails_in: str = ""  # the first time this entry is called
    takes: bool = False  # goes on where the code before it stood
    is_idle_on: bool = False  # `on` leaves the outputs as they were preloaded

    @property
    def frequency(self) -> float:
        """In hertz."""
        return 1e9 / self.period


def law_task(probe: SampleTask) -> LawTask:
    """The probe as the law sees it."""

    def first(moment: Moment, entry: str) -> None:
        tries = moment.memory.setdefault("tries", set())
        if probe.fails_in == entry and entry not in tries:
            tries.add(entry)
            raise ValueError(entry)

    def init(moment: Moment) -> None:
        moment.memory.update(n=0, k=0)
        first(moment, "init")
        for name in probe.outconst:
            moment.outputs[name] = 100.0 + sum(moment.inputs[constant] for constant in probe.inconst)

    def on(moment: Moment) -> None:
        moment.memory["k"] = 0
        first(moment, "on")
        for name in () if probe.is_idle_on else probe.outvar:
            moment.outputs[name] = moment.outputs[name] + 1.0 if name in moment.in_force else moment.now / MS

    def cycle(moment: Moment) -> Signal | None:
        memory = moment.memory
        memory["n"] += 1
        memory["k"] += 1
        if memory["n"] == probe.fail_at:
            raise ValueError("cycle")
        move(moment)
        if memory["k"] == probe.finish_after:
            return finish(flow=memory["n"], loop=True)
        return off() if memory["k"] == probe.off_after else None

    def move(moment: Moment) -> None:
        total = sum(moment.inputs[variable] for variable in probe.invar)
        here = moment.device.read()[0] if moment.device else 0.0
        for name in probe.outvar:
            moment.outputs[name] = (moment.outputs[name] + total + moment.memory["k"] + here) % 1009.0
            if moment.memory["n"] == probe.nan_at:
                moment.outputs[name] = float("nan")
        if moment.device:
            moment.device.write((total,))

    def leave(moment: Moment) -> None:
        first(moment, "off")

    def take(moment: Moment) -> None:
        moment.memory.update(n=moment.former["n"], k=moment.former["k"])
        first(moment, "take")

    code: dict[str, Entry] = {
        "init": init,
        "on": on,
        "cycle": cycle,
        "hold": move,
        "off": leave,
        "error": lambda _: probe.mends,
    }
    code |= {"take": take} if probe.takes else {}
    return LawTask(
        probe.name, code, probe.period, probe.is_periodic, probe.crit, probe.rank, probe.cost, bool(probe.finish_after),
        bool(probe.device), False, probe.device, probe.inconst, probe.outconst, probe.invar, probe.outvar,
    )  # fmt: skip


def source(probe: SampleTask) -> str:
    """The probe as the source of a module, which writes down what it sees as the reference does."""
    kinds: dict[str, str] = {}
    for name in probe.inconst:
        kinds[name] = "InBoth" if name in probe.invar else "InConst"
    for name in probe.outconst:
        kinds[name] = "OutBoth" if name in probe.outvar else "OutConst"
    for name in probe.invar:
        kinds.setdefault(name, "InVar")
    for name in probe.outvar:
        kinds.setdefault(name, "OutVar")
    ports = "\n    ".join(f'{name} = {kind}("double")' for name, kind in kinds.items())
    return f"""
from onika.module import InBoth, InConst, InVar, Module, OutBoth, OutConst, OutVar, finish, off
from oracle.law_task import Traced

MS = 1_000_000


def traced(entry):
    def call(self, *given):
        try:
            return entry(self, *given)
        finally:
            inputs = {{name: getattr(self, name) for name in {probe.inconst + probe.invar}}}
            outputs = {{name: getattr(self, name) for name in {probe.outconst + probe.outvar}}}
            self.trace.append(Traced(round(self.now * 1e9), {probe.name!r}, entry.__name__, inputs, outputs))
    return call


class Probe(Module):
    trigger = {bool(probe.finish_after)}
    hardware = {bool(probe.device)}
    crit = {probe.crit}
    {ports}

    def __init__(self):
        self.trace = []
        self.tries = set()

    def first(self, entry):
        if {probe.fails_in!r} == entry and entry not in self.tries:
            self.tries.add(entry)
            raise ValueError(entry)

    @traced
    def init(self):
        self.n = self.k = 0
        self.first("init")
        for name in {probe.outconst}:
            setattr(self, name, 100.0 + sum(getattr(self, one) for one in {probe.inconst}))

    @traced
    def on(self, inputs):
        self.k = 0
        self.first("on")
        for name in {() if probe.is_idle_on else probe.outvar}:
            setattr(self, name, getattr(self, name) + 1.0 if self.continues(name) else round(self.now * 1e9) / MS)

    @traced
    def cycle(self):
        self.n += 1
        self.k += 1
        if self.n == {probe.fail_at}:
            raise ValueError("cycle")
        self.move()
        if self.k == {probe.finish_after}:
            return finish(flow=self.n, loop=True)
        return off() if self.k == {probe.off_after} else None

    def move(self):
        total = sum(getattr(self, one) for one in {probe.invar})
        here = self.device.read()[0] if {bool(probe.device)} else 0.0
        for name in {probe.outvar}:
            value = (getattr(self, name) + total + self.k + here) % 1009.0
            setattr(self, name, float("nan") if self.n == {probe.nan_at} else value)
        if {bool(probe.device)}:
            self.device.write((total,))

    @traced
    def hold(self):
        self.move()
{_TAKE if probe.takes else ""}

    @traced
    def off(self):
        self.first("off")

    @traced
    def error(self, fault):
        return {probe.mends}

    @traced
    def clear(self):
        pass

    @traced
    def kill(self):
        pass
"""
