"""Edits of a live subsystem as transactions: prepare, commit at one instant, then kill the old (laws 12, 22).

Each is a generator for `LiveSubsystem.begin`: it goes step by step (`edit_steps`), and returns why it came to nothing.
What was prepared is taken back then, and what was ON is ON again.
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace

from onika.host.edit import failed_writers, tight_units
from onika.host.edit.edit_steps import Lines, Newcomer, Step, clear, kill, reinit, spawn, switch, tasks_on, tell
from onika.host.subsystems.live_subsystem import LiveSubsystem, Transaction
from onika.model.lifecycle import State
from onika.model.rules.order import constant_order
from onika.model.rules.reconfiguration import TaskExchange, dependents
from onika.runtime import command
from onika.runtime.table import TableEntry
from onika.runtime.wiring import WiredTask
from onika.wire.live import Turn
from onika.words.reason import NOTHING, Reason

StatedConstants = Mapping[str, int]
"""The constants that a robot module states before it lives."""


@dataclass(frozen=True, slots=True)
class Edit:
    """What an accepted change is to do."""

    exchange: TaskExchange
    new: tuple[Newcomer, ...] = ()
    off: tuple[str, ...] = ()
    on: tuple[Turn, ...] = ()
    rates: tuple[tuple[str, float], ...] = ()
    constants: Mapping[str, StatedConstants] = field(default_factory=dict)
    """By newcomer."""
    latitude: tight_units.Latitude = tight_units.NO_LATITUDE


class _Before:
    """How things were before a transaction, to go back to."""

    def __init__(self, live: LiveSubsystem, new: Collection[Newcomer]) -> None:
        self.on = {task: live.desired.line(task) for task in tasks_on(live)}
        """Tasks that are ON, with their argument lines."""
        self.placements = live.placements
        self.waiting = [task for task, member in live.members.items() if not member.is_sent]
        self.desired = live.desired.copy()
        self.killed: list[str] = []
        supplied = {svar for wired, _ in new for svar in wired.outconst if svar not in wired.outvar}
        self.constants: list[tuple[TableEntry, bytes]] = [
            (entry, live.table.ring(svar).read())
            for svar, entry in live.table.entries.items()
            if svar in supplied and live.table.ring(svar).count
        ]
        """What newcomers write as soon as they are spawned, and others have written before."""

    def newcomers(self, tasks: Collection[str]) -> list[Newcomer]:
        """These tasks, to be spawned again."""
        return [(wired, rtpu) for wired, rtpu in self.placements if wired.name in tasks]

    def rate(self, task: str) -> float:
        """The rate a task had."""
        planned = next(wired.task.frequency for wired, _ in self.newcomers([task]))
        return self.desired.rate(task) or planned or 0.0


def change(live: LiveSubsystem, edit: Edit) -> Transaction:
    """Carry out a change whole, or not at all."""
    exchange, born = edit.exchange, [wired.name for wired, _ in edit.new]
    before = _Before(live, edit.new)
    before.killed = list(exchange.kill_first)
    yield from switch(live, exchange.kill_first, ())
    yield from kill(live, exchange.kill_first)
    for task, values in edit.constants.items():
        live.desired.state_constants(task, values)
    yield from spawn(live, edit.new)
    held = yield from tight_units.make_room(live, edit.new, edit.latitude)
    cause = live.outcomes.trouble(born)
    is_committed = not cause
    if is_committed:
        again = exchange.reinit  # those born in this change too: a supplier of theirs may have learnt something since
        old = [name for name in exchange.kill if name not in exchange.kill_first]
        edit = _with_held(live, edit, held)
        yield from _commit(live, edit, [*edit.off, *old], again, before.on)
        cause = live.outcomes.trouble([*(turn.task for turn in edit.on), *again, *(name for name, _ in edit.rates)])
    if not cause:
        yield from kill(live, old)
        _remember(live, edit)
        return NOTHING
    yield from _take_back(live, edit, before, is_committed)
    return cause


def reinitialise(
    live: LiveSubsystem, task: str, wired: WiredTask | None, constants: StatedConstants | None = None
) -> Transaction:
    """Initialise a task anew, with the parameters of `wired` where given, then all that read its constants.

    Where shapes change, hardware tasks stay OFF until somebody turns them on again (law 12). Where a task refuses its
    new constants the old parameters count again; without any, it is in ERROR and the others go on as they were.
    """
    if wired is None and live.state(task) is State.ERROR:
        return Reason.of("host.of_task", task=task, why=Reason.of("host.clear_it_first"))
    before = _Before(live, ())
    former = live.members[task].wired
    chain = _chain(live, task)
    errors = [name for name in chain if live.state(name) is State.ERROR]
    on = [Turn(name, line) for name, line in before.on.items() if name in chain]
    yield from switch(live, [turn.task for turn in on], ())
    if wired is not None:
        _rewire(live, wired, constants)
    cause = yield from _initialise(live, chain, {} if wired is None else {task: wired.task.local})
    back = on if cause else _to_return(live, on)
    if cause and wired is not None:
        _rewire(live, former, before.desired.constants_of(task))
        yield from _restore_chain(live, chain, errors, former.task.local)
    yield from switch(live, (), [turn for turn in back if live.state(turn.task) is State.OFF])
    return cause or live.outcomes.trouble([turn.task for turn in back])


def _chain(live: LiveSubsystem, task: str) -> list[str]:
    """A task, then all that read its constants, suppliers first."""
    others = [placed.ports for placed in live.placed() if placed.name != task]
    return [task, *dependents(others, live.members[task].wired.outconst)]


def _restore_chain(live: LiveSubsystem, chain: Sequence[str], errors: Collection[str], local: Lines) -> Step:
    """Initialise a task, with its former parameters, and its readers anew; who was in ERROR before stays there."""
    task = chain[0]
    for name in chain:
        yield from _restore(live, name, name not in errors, local if name == task else None)


def swap(
    live: LiveSubsystem, task: str, wired: WiredTask, latitude: tight_units.Latitude = tight_units.NO_LATITUDE
) -> Transaction:
    """Exchange the code of a living task; where it fails the old one stays (law 21)."""
    member = live.members[task]
    before, member.wired = member.wired, wired
    if not member.is_sent:
        return NOTHING  # it is born with the new code
    order = live.executor.spawner.order(live.executor.subsystem, task)
    yield from tell(live, task, command.Swap(order))
    if live.outcomes.found_no_gap(task):
        yield from tight_units.exchange(live, task, order, latitude)
    if not live.outcomes.has_answered(task):
        member.wired = before
    return live.outcomes.trouble([task])


def clearing(live: LiveSubsystem, task: str) -> Transaction:
    """Bring a task out of ERROR, unless what fed it is still in it."""
    objection = failed_writers.objection_to_clear(live, task)
    if objection:
        return objection
    yield from clear(live, task)
    return live.outcomes.trouble([task])


def close(live: LiveSubsystem) -> Transaction:
    """Kill every task; then the subsystem is no more."""
    yield from switch(live, tasks_on(live), ())
    yield from kill(live, list(live.members))
    live.close()
    return NOTHING


def rest(live: LiveSubsystem) -> Transaction:
    """Everything off: whoever held the subsystem is gone (X12)."""
    yield from switch(live, tasks_on(live), ())
    live.desired.turn_everything_off()
    return NOTHING


# Parts of them


def _with_held(live: LiveSubsystem, edit: Edit, held: Collection[Turn]) -> Edit:
    """With whoever went OFF for a moment to come ON again."""
    others = {*edit.off, *edit.exchange.kill, *(turn.task for turn in edit.on)}
    back = _to_return(live, [turn for turn in held if turn.task not in others])
    return replace(edit, on=(*back, *edit.on))


def _commit(
    live: LiveSubsystem, edit: Edit, off: Sequence[str], again: Sequence[str], on_before: Mapping[str, str]
) -> Step:
    """Off and on at one instant; where constants were exchanged, their consumers are initialised anew in between."""
    if not again:
        yield from switch(live, off, edit.on, edit.rates)
        return
    wanted_on = {turn.task for turn in edit.on}
    gone = {*off, *(wired.name for wired, _ in edit.new)}  # a newcomer may bear the name of one that was ON
    back = [Turn(name, on_before[name]) for name in again if name in on_before and name not in gone]
    yield from switch(live, [*off, *(turn.task for turn in back)], (), edit.rates)
    for name in again:
        yield from reinit(live, name)
    if not live.outcomes.trouble(again):
        yield from switch(
            live, (), [*_to_return(live, [turn for turn in back if turn.task not in wanted_on]), *edit.on]
        )


def _to_return(live: LiveSubsystem, turns: Sequence[Turn]) -> list[Turn]:
    """Who comes on again by itself: all, but after a change of shapes no hardware before somebody says so (law 12)."""
    if not live.reshaping.has_changed:
        return list(turns)
    for turn in turns:
        if live.members[turn.task].wired.sheet.hardware:
            live.desired.turn_off(turn.task)
            live.warn(turn.task, Reason.of("host.shapes_changed"))
    return [turn for turn in turns if not live.members[turn.task].wired.sheet.hardware]


def _initialise(live: LiveSubsystem, chain: Sequence[str], local: Mapping[str, Lines]) -> Transaction:
    """One after the other, up to the first that refuses; why it does."""
    for name in chain:
        yield from reinit(live, name, local.get(name))
        if live.outcomes.has_trouble(name):
            return live.outcomes.trouble([name])
    return NOTHING


def _take_back(live: LiveSubsystem, edit: Edit, before: _Before, is_committed: bool) -> Step:
    """As it was: the new ones die, the old ones live, and what was ON comes on again."""
    live.outcomes.begin()
    yield from switch(live, [name for name in tasks_on(live) if name not in before.on], ())
    awake = [name for name in before.waiting if name not in before.killed and live.members[name].is_sent]
    yield from kill(live, [*(wired.name for wired, _ in edit.new), *awake])
    live.desired.take_back_constants(before.desired)
    if not is_committed:
        live.reshaping.undo()
    for entry, value in before.constants:
        if live.table.entries.get(entry.name) == entry:
            live.table.ring(entry.name).write(value)
            live.table.ring(entry.name).seal()
    yield from spawn(live, before.newcomers([*before.killed, *awake]))
    live.rewire(before.newcomers(live.members))
    if is_committed:
        yield from _relearn(live, edit)
    yield from _come_back(live, edit, before)
    live.desired.take_back(before.desired)


def _relearn(live: LiveSubsystem, edit: Edit) -> Step:
    """Old tasks and those that read their constants take over what counts again, suppliers first."""
    stale = {*edit.exchange.kill, *edit.exchange.reinit} - {*edit.exchange.kill_first}
    if not (edit.exchange.reinit or live.reshaping.has_changed):
        return
    yield from switch(live, [name for name in tasks_on(live) if name in stale], ())
    for name in constant_order([placed.ports for placed in live.placed()])[0]:
        if name in stale:
            yield from _restore(live, name, name in edit.exchange.reinit)


def _restore(live: LiveSubsystem, name: str, may_clear: bool, local: Lines | None = None) -> Step:
    """Initialise a task anew; one that is in ERROR for what is taken back comes out of it."""
    live.outcomes.excuse(name)
    yield from reinit(live, name, local)
    if may_clear and live.state(name) is State.ERROR:
        yield from clear(live, name)


def _come_back(live: LiveSubsystem, edit: Edit, before: _Before) -> Step:
    """Rates as they were, and ON whoever was."""
    on = [Turn(name, line) for name, line in before.on.items() if live.state(name) is State.OFF]
    changed = [name for name, _ in edit.rates] + [
        name for name in before.killed if before.desired.rate(name) is not None
    ]
    here = [name for name in changed if live.state(name) in (State.ON, State.OFF, State.ASKING, State.ERROR)]
    yield from switch(live, (), on, tuple((name, before.rate(name)) for name in dict.fromkeys(here)))


def _rewire(live: LiveSubsystem, wired: WiredTask, constants: StatedConstants | None) -> None:
    """A task with other parameters."""
    live.desired.state_constants(wired.name, constants)
    live.rewire([(wired if other.name == wired.name else other, rtpu) for other, rtpu in live.placements])


def _remember(live: LiveSubsystem, edit: Edit) -> None:
    """What is wanted from now on; what has done its job meanwhile is not."""
    for task in edit.off:
        live.desired.turn_off(task)
    for turn in edit.on:
        if live.is_on(turn.task):
            live.desired.turn_on(turn.task, turn.arguments)
    for task, hz in edit.rates:
        live.desired.set_rate(task, hz)
