"""What is done where a newcomer, or new code, found no gap between the cycles of its unit (law 21).

A newcomer that named no unit is born on another one. Else it is done at once where nothing that cycles on the unit can
have a part in driving a device: what cycles there is late for a moment. Else, where that was asked for, in a moment of
hold: all tasks of the subsystem go OFF, their devices hold, and they come ON again.
"""

from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from msgspec import structs

from onika.host.edit.edit_steps import Newcomer, Step, kill, spawn, switch, tasks_on, tell
from onika.host.subsystems.live_subsystem import LiveSubsystem, Wait
from onika.runtime import command
from onika.wire.live import Turn
from onika.words.reason import Reason

Way = Generator[Wait, None, tuple[Turn, ...]]
"""A step that returns whoever has gone OFF for it."""


def _always(_unit: str) -> bool:
    return True


@dataclass(frozen=True, slots=True)
class Latitude:
    """What an edit may do where there is no gap."""

    spare: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """By newcomer that named no unit, the other units on which it may live; hardware stays where it is."""
    is_driven: Callable[[str], bool] = _always
    """Whether a device may be driven by what cycles on a unit."""
    holds: bool = False
    """Whether everything may go OFF for a moment."""


NO_LATITUDE = Latitude()
"""Nothing of it."""


def make_room(live: LiveSubsystem, new: Sequence[Newcomer], latitude: Latitude) -> Way:
    """Have newcomers born that found no gap, each in the first way that there is; returns whoever is OFF for that."""
    held: tuple[Turn, ...] = ()
    ways = {newcomer[0].name: _ways(live, newcomer, latitude) for newcomer in new}
    while True:
        tight = [name for name in ways if live.outcomes.found_no_gap(name)]
        way = next((step for name in tight for step in ways[name]), None)
        if way is None:
            return held
        held += yield from way
        yield lambda: not any(live.is_being_spawned(name) for name in ways if name in live.members)


def exchange(live: LiveSubsystem, task: str, order: command.Spawn, latitude: Latitude) -> Step:
    """Exchange the code of a living task that found no gap, at once or in a moment of hold, where that may be."""
    unit = live.members[task].rtpu
    at_once = command.Swap(structs.replace(order, cost_ns=0))
    if not latitude.is_driven(unit):
        yield from tell(live, task, at_once)
        _warn(live, task, Reason.of("host.swapped_at_once", unit=unit))
    elif latitude.holds:
        on = yield from _hold(live)
        yield from tell(live, task, command.Swap(order))
        yield from switch(live, (), [turn for turn in on if not live.is_on(turn.task)])
        _warn(live, task, Reason.of("host.swapped_in_hold", tasks=tuple(turn.task for turn in on)))


def _ways(live: LiveSubsystem, newcomer: Newcomer, latitude: Latitude) -> Iterator[Way]:
    """The ways in which a newcomer may be born, tried one after the other."""
    wired, home = newcomer
    for unit in latitude.spare.get(wired.name, ()):
        told = Reason.of("host.spawned_elsewhere", unit=unit, former=home)
        yield _again(live, (wired, unit), told)
    if not latitude.is_driven(home):
        live.executor.spawner.hurry(wired.name)
        yield _again(live, newcomer, Reason.of("host.spawned_at_once", unit=home))
    elif latitude.holds:
        yield _in_hold(live, newcomer)


def _again(live: LiveSubsystem, newcomer: Newcomer, notice: Reason) -> Way:
    """Born once more, on this unit, OFF; it is told."""
    task = newcomer[0].name
    yield from kill(live, [task])
    live.outcomes.excuse(task)
    yield from spawn(live, [newcomer])
    _warn(live, task, notice)
    return ()


def _in_hold(live: LiveSubsystem, newcomer: Newcomer) -> Way:
    """Everything that is ON goes OFF, devices hold, and the newcomer is born."""
    on = yield from _hold(live)
    yield from _again(live, newcomer, Reason.of("host.spawned_in_hold", tasks=tuple(turn.task for turn in on)))
    return on


def _hold(live: LiveSubsystem) -> Way:
    on = tuple(Turn(name, live.desired.line(name)) for name in tasks_on(live))
    yield from switch(live, [turn.task for turn in on], ())
    return on


def _warn(live: LiveSubsystem, task: str, notice: Reason) -> None:
    if not live.outcomes.has_trouble(task):
        live.warn(task, notice)
