"""What a document's change means for its subsystem: who dies, who is born, who goes ON or OFF, and at which rate."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace

from onika.desk.environment.reconcile.task_plan import SpawnPlan, birth, is_hardware, rate_of
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.live import SubsystemFacts, TaskFacts
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.rules.order import Ports, rank
from onika.wire import live
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class Reconfiguration:
    """The tasks of a change by what happens to them; one that is in `kill` and in `spawn` is exchanged."""

    kill: tuple[str, ...] = ()
    spawn: tuple[SpawnPlan, ...] = ()
    off: tuple[str, ...] = ()
    on: tuple[live.Turn, ...] = ()
    rates: tuple[tuple[str, float], ...] = ()
    resting: tuple[str, ...] = ()
    """Hardware that is exchanged while it is ON, and stays OFF until somebody turns it on (as in law 12)."""
    faults: tuple[Reason, ...] = field(default=(), compare=False)
    """Why tasks cannot be born."""

    @property
    def is_nothing(self) -> bool:
        """Whether nothing happens."""
        return self == Reconfiguration()

    @property
    def names(self) -> frozenset[str]:
        """Whom it touches."""
        born = (newcomer.task.name for newcomer in self.spawn)
        return frozenset(
            (*self.kill, *born, *self.off, *(turn.task for turn in self.on), *(name for name, _ in self.rates))
        )

    @property
    def wakes(self) -> bool:
        """Whether somebody comes to life or goes ON, which a stopped runtime does not allow."""
        return bool(self.spawn or self.on)

    def change(self, subsystem: str, holds: bool = False) -> live.Change:
        """As it is asked of a runtime; `holds`: everything may go OFF for a moment."""
        code = {newcomer.code.digest: newcomer.code for newcomer in self.spawn}
        spawn = tuple(newcomer.task for newcomer in self.spawn)
        return live.Change(subsystem, self.kill, spawn, tuple(code.values()), self.off, self.on, self.rates, holds)


def reconfiguration(
    before: Content,
    after: Content,
    subsystem_facts: SubsystemFacts,
    libraries: OpenLibraries,
    changed: Collection[str],
    units: Collection[str],
) -> Reconfiguration:
    """From one content to another, with some tasks of the libraries changed, beside what is known to live."""
    difference = _Difference(before, after, subsystem_facts, libraries, changed, units)
    stay = [name for name in after.wanted if difference.stays(name)]
    rates = _rates(stay, before, after, libraries)
    exchanged = difference.exchanged(stay, rates)
    births = difference.births(exchanged)

    resting = difference.resting(exchanged)
    off = difference.turned_off(stay, births)
    on = _in_order(difference.turned_on(births, resting), after, libraries)

    groups = after.configuration  # a runtime spawns who supplies a constant before who needs it, whatever they say
    in_order = [births[name] for name in groups.in_group_order(births)]
    return Reconfiguration(
        kill=difference.killed(births),
        spawn=tuple(newcomer for newcomer in in_order if isinstance(newcomer, SpawnPlan)),
        off=tuple(reversed(groups.in_group_order(reversed(off)))),
        on=tuple(live.Turn(name, subsystem_facts.turns.get(name, "")) for name in on),
        rates=tuple((name, hz) for name, hz in rates if name not in births),
        resting=resting,
        faults=tuple(reason for reason in births.values() if not isinstance(reason, SpawnPlan)),
    )


@dataclass(frozen=True, slots=True)
class _Difference:
    """Questions about one task between two contents, beside what lives."""

    before: Content
    after: Content
    facts: SubsystemFacts
    libraries: OpenLibraries
    changed: Collection[str]
    units: Collection[str]

    def lives(self, name: str) -> bool:
        """Whether the subsystem has it."""
        return name in self.facts.tasks

    def exchanged(self, stay: Collection[str], rates: Collection[tuple[str, float]]) -> list[str]:
        """Who stays by its name while another one takes its place."""
        unborn = {name for name, _ in rates if self.is_unborn(name)}
        return [name for name in stay if name in unborn or self.is_exchanged(name)]

    def births(self, exchanged: Collection[str]) -> dict[str, SpawnPlan | Reason]:
        """Who is to be born, each with its plan, or why it cannot be."""
        new = [name for name in self.after.wanted if name not in self.before.wanted]
        again = [name for name in self.after.wanted if self.comes_again(name)]
        names = [name for name in (*new, *exchanged, *again) if name in self.libraries.tasks]
        return {name: _birth(name, self.after, self.libraries, self.units) for name in names}

    def resting(self, exchanged: Collection[str]) -> tuple[str, ...]:
        """The hardware among those that are exchanged that was ON: it stays OFF."""
        were_on = [name for name in exchanged if self.before.wanted[name]]
        return tuple(name for name in were_on if is_hardware(self.libraries.tasks[name], self.libraries))

    def turned_off(self, stay: Collection[str], births: Collection[str]) -> list[str]:
        """Who goes OFF, and is not born anew."""
        were_on = [name for name in stay if self.before.wanted[name] and name not in births]
        return [name for name in were_on if not self.after.wanted[name]]

    def killed(self, births: Collection[str]) -> tuple[str, ...]:
        """Who dies: it is wanted no more, or another one takes its place."""
        gone = [name for name in self.before.wanted if name not in self.after.wanted or name in births]
        return tuple(filter(self.lives, gone))

    def turned_on(self, births: Collection[str], resting: Collection[str]) -> list[str]:
        """Who comes ON."""
        wanted = [name for name, is_on in self.after.wanted.items() if is_on and name not in resting]
        return [name for name in wanted if name in births or self.comes_on(name)]

    def stays(self, name: str) -> bool:
        """Whether it was wanted, is wanted, and lives."""
        return name in self.before.wanted and self.lives(name)

    def is_unborn(self, name: str) -> bool:
        """Whether it waits to be born: it has no rate to change yet."""
        return self.facts.state_of(name) == "WAITING"

    def is_exchanged(self, name: str) -> bool:
        """Whether another one takes its place: its task has changed, or it is to live on another unit."""
        placed = self.after.placed(name)
        is_changed = (name if placed is None else placed.file) in self.changed
        return is_changed or self._is_otherwise(name) or self._moves(name)

    def comes_again(self, name: str) -> bool:
        """Whether it was wanted, does not live any more, and is turned on."""
        is_absent = name in self.before.wanted and not self.lives(name)
        return is_absent and self.after.wanted[name] and self._is_turned(name)

    def comes_on(self, name: str) -> bool:
        """Whether one that lives is to go ON and is not."""
        return self.lives(name) and not self.facts.tasks[name].is_moving and self._is_turned(name)

    def _is_turned(self, name: str) -> bool:
        return name in self.facts.turns or not self.before.wanted.get(name, False)

    def _is_otherwise(self, name: str) -> bool:
        """Whether the configuration says other things of it than before."""
        old, new = self.before.placed(name), self.after.placed(name)
        return old is not None and new is not None and (old.own, old.rmod) != (new.own, new.rmod)

    def _moves(self, name: str) -> bool:
        placed = self.after.placed(name)
        here = self.facts.tasks[name].rtpu
        return placed is not None and bool(here) and placed.rtpu in self.units and placed.rtpu != here


def with_facts(subsystem_facts: SubsystemFacts, what: Reconfiguration, units: Collection[str]) -> SubsystemFacts:
    """What is known while it is under way: who is to be born is shown at once."""
    first = next(iter(units), "")
    spawning: dict[str, TaskFacts] = {}
    for newcomer in what.spawn:
        task = newcomer.task
        unit = task.rtpu if task.rtpu in units else first
        spawning[task.name] = TaskFacts("SPAWNING", rtpu=unit, hz=task.frequency)
    rates = {
        name: replace(subsystem_facts.tasks[name], hz=hz) for name, hz in what.rates if name in subsystem_facts.tasks
    }
    return replace(subsystem_facts, tasks={**subsystem_facts.tasks, **rates, **spawning}, turns={})


def _birth(name: str, after: Content, libraries: OpenLibraries, units: Collection[str]) -> SpawnPlan | Reason:
    placed = after.placed(name)
    if placed is None:
        raise ValueError(f"expected {name}, which is wanted, on the canvas, found {after.names}")
    return birth(placed, libraries, units)


def _rates(names: list[str], before: Content, after: Content, libraries: OpenLibraries) -> list[tuple[str, float]]:
    signs = []
    for name in names:
        old, new, task = before.placed(name), after.placed(name), libraries.tasks.get(name)
        if old is None or new is None or task is None or old.frequency == new.frequency:
            continue
        hz = rate_of(new, task)
        if hz is not None:
            signs.append((name, hz))
    return signs


def _in_order(names: list[str], after: Content, libraries: OpenLibraries) -> list[str]:
    """Producers before consumers, but the tasks of a supermodule in its order (C17)."""
    if len(names) < 2:
        return names
    tasks: Mapping[str, Ports] = {name: Ports.of(libraries.tasks[name]) for name in names if name in libraries.tasks}
    hardware = [name for name in tasks if is_hardware(libraries.tasks[name], libraries)]
    place = rank(list(tasks.values()), hardware)
    return after.configuration.in_group_order(sorted(names, key=lambda name: place.get(name, len(place))))
