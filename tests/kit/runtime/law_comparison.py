"""Some sample tasks run by the law's reference and by the executive: both accounts have to be the same."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Self

from kit.labs.sample_task import SampleTask, law_task, source
from kit.runtime.executive_rig import ExecutiveRig
from kit.worlds.mass_world import MassWorld
from onika.model.lifecycle import State
from onika.runtime import command, news
from oracle.law_task import LawSwap
from oracle.reference import Reference, Request as Lawful


@dataclass(frozen=True)
class Exchanged:
    """A request: this probe in place of the one of its name."""

    probe: SampleTask


Plain = command.Switch | command.Clear | command.Kill | command.Rank | command.Reinit
Request = Plain | Exchanged
Probes = Sequence[SampleTask]
Timed = Sequence[tuple[int, Request]]
Reactions = Mapping[str, Sequence[Request]]
"""By task: what is asked for when it gives a signal."""


class TracedRig(ExecutiveRig):
    """Instances that come later write into the one trace too, where they belong."""

    trace: list[Any] | None = None

    def do(self, order: command.Command) -> Self:
        """As a rig does."""
        before = len(self.trace or ())
        super().do(order)
        if self.trace is not None:
            for task in self.executive.tasks.values():
                module: Any = task.module
                if module.trace is not self.trace:
                    self.trace[before:before] = module.trace
                    module.trace = self.trace
        return self

    def of(self, request: Request) -> command.Command:
        """A request as a command."""
        return command.Swap(self.order_of(request.probe)) if isinstance(request, Exchanged) else request

    def order_of(self, probe: SampleTask) -> command.Spawn:
        """The command for a probe."""
        kind = "periodic" if probe.is_periodic else "aperiodic"
        return self.spawn_of(
            probe.name, source(probe), frequency=probe.frequency, kind=kind, rank=probe.rank, device=probe.device
        )


def _to_law(request: Request) -> Lawful:
    return LawSwap(law_task(request.probe)) if isinstance(request, Exchanged) else request


@dataclass(frozen=True)
class Account:
    """All that one of the two tells."""

    trace: list[str]
    """What the probes saw, as text: in that NaN is equal to itself."""
    words: list[tuple[int, str, str]]
    states: Mapping[str, State]
    """Of those that live."""
    missed: dict[str, int]
    world: bytes


def by_law(
    probes: Probes, requests: Timed, until: int, react: Reactions = MappingProxyType({})
) -> tuple[Account, Reference]:
    """What the reference makes of them; itself, to be looked at."""
    world = MassWorld()
    reference = Reference(
        [law_task(probe) for probe in probes], world, lambda task, _: list(map(_to_law, react.get(task, [])))
    )
    reference.run(until, [(at, _to_law(order)) for at, order in requests])
    states = {name: state for name, state in reference.states.items() if state is not State.KILLED}
    missed = {name: reference.missed[name] for name in states}
    return Account(list(map(repr, reference.trace)), reference.told, states, missed, world.fingerprint()), reference


def by_executive(
    probes: Probes,
    requests: Timed,
    until: int,
    react: Reactions = MappingProxyType({}),
    steady: int | None = None,
) -> Account:
    """What the executive makes of them; by sweeps after so many `steady` instants."""
    world, trace = MassWorld(), list[Any]()

    def reply(message: news.News) -> list[command.Command]:
        if isinstance(message, news.Finished) or (isinstance(message, news.Changed) and message.signal):
            return list(map(rig.of, react.get(message.task, [])))
        return []

    costs = {} if steady else {probe.name: probe.cost for probe in probes}
    rig = TracedRig(world, costs=costs, react=reply, steady=steady)
    for probe in probes:
        rig.do(rig.order_of(probe))
        module: Any = rig.task(probe.name).module
        trace += module.trace
        module.trace = trace
    rig.trace = trace
    rig.run(until, [(at, rig.of(order)) for at, order in requests])
    tasks = {name: task for (_, name), task in rig.executive.tasks.items()}
    states = {name: task.state for name, task in tasks.items()}
    missed = {name: task.slot.missed for name, task in tasks.items()}
    return Account(list(map(repr, trace)), _words(rig), states, missed, world.fingerprint())


def _words(rig: ExecutiveRig) -> list[tuple[int, str, str]]:
    """What a rig heard, in the words of the reference."""
    rows: list[tuple[int, str, str]] = []
    for at, entry in rig.news:
        match entry:
            case news.Changed():
                rows.append((at, entry.task, f"signal {entry.signal}" if entry.signal else entry.state))
            case news.Initialised() if (at, entry.task, "ERROR") in rows:
                rows.append((at, entry.task, "OFF"))
            case news.Initialised() if any(before[1:] == (entry.task, "ERROR") for before in rows):
                rows.append((at, entry.task, "OFF"))
            case news.Reinitialised():
                rows.append((at, entry.task, "reinit"))
            case news.Swapped():
                rows.append((at, entry.task, "swapped"))
            case news.Finished():
                rows.append((at, entry.task, "signal FINISH"))
            case news.Failed():
                rows.append((at, entry.task, "ERROR"))
            case news.Refused():
                rows.append((at, entry.task, f"refused {entry.command}"))
    return rows
