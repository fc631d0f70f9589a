"""Edits of a live subsystem as transactions: prepare, commit at one instant, then kill the old (laws 12, 22).

Each is a generator for `LiveSubsystem.begin`: it sends commands, yields what it waits for, and returns why it came to
nothing. What was prepared is taken back then, and what was ON is ON again.
"""

from collections.abc import Collection, Generator, Iterable, Sequence
from dataclasses import dataclass, field

from onika.host.live import LiveSubsystem, Transaction, Wait
from onika.model.lifecycle import State
from onika.model.rules.reconfiguration import Exchange, dependents
from onika.runtime import command
from onika.runtime.wiring import WiredTask
from onika.wire.live import Turn

Step = Generator[Wait, None, None]
Newcomer = tuple[WiredTask, str]
"""A task to be born, and its unit."""
Lines = tuple[tuple[str, tuple[str, ...]], ...]


@dataclass(frozen=True, slots=True)
class Edit:
    """What an accepted change is to do."""

    exchange: Exchange
    new: tuple[Newcomer, ...] = ()
    off: tuple[str, ...] = ()
    on: tuple[Turn, ...] = ()
    rates: tuple[tuple[str, float], ...] = ()


@dataclass(slots=True)
class _Before:
    """What to go back to."""

    on: dict[str, str]
    """Tasks that are ON, with their argument lines."""
    killed: list[Newcomer] = field(default_factory=list)


def change(live: LiveSubsystem, edit: Edit) -> Transaction:
    """Carry out a change whole, or not at all."""
    exchange, born = edit.exchange, [wired.name for wired, _ in edit.new]
    before = _Before({name: live.wanted.get(name, "") for name in _on(live)})
    yield from _kill_first(live, exchange, before)
    yield from _spawn(live, edit.new)
    trouble = _trouble(live, born)
    if not trouble:
        old = [name for name in exchange.kill if name not in exchange.kill_first]
        yield from _commit(live, edit, [*edit.off, *old], _on(live))
        trouble = _trouble(
            live, [*(turn.task for turn in edit.on), *exchange.reinit, *(name for name, _ in edit.rates)]
        )
        if not trouble:
            yield from _kill(live, old)
            _remember(live, edit)
            return ""
    yield from _take_back(live, edit, born, before)
    return trouble


def reinit(live: LiveSubsystem, task: str, wired: WiredTask | None) -> Transaction:
    """Initialise a task anew, with the parameters of `wired` where given, then all that read its constants.

    Where shapes change, hardware tasks stay OFF until somebody turns them on again (law 12).
    """
    others = dependents([one.ports for one in live.placed() if one.name != task], live.members[task].wired.outconst)
    chain = [task, *others]
    on = [name for name in _on(live) if name in chain]
    lines = {name: live.wanted.get(name, "") for name in on}
    yield from _switch(live, chain, ())
    if wired is not None:
        live.rewire([(wired if name == task else one.wired, one.rtpu) for name, one in live.members.items()])
    for name in chain:
        yield from _reinit(live, name, wired.task.local if wired is not None and name == task else None)
        if live.trouble.get(name):
            return f"{name}: {live.trouble[name]}; {', '.join(chain)} stay OFF"
    back = _to_return(live, [Turn(name, lines[name]) for name in on])
    yield from _switch(live, (), back)
    return _trouble(live, [turn.task for turn in back])


def swap(live: LiveSubsystem, task: str, wired: WiredTask) -> Transaction:
    """Exchange the code of a living task; where it fails the old one stays (law 21)."""
    member = live.members[task]
    before, member.wired = member.wired, wired
    live.done.discard(task)
    live.send(task, command.Swap(live.spawn_order(task)))
    yield lambda: task in live.done or task in live.trouble or live.state(task) is State.KILLED
    if task not in live.done:
        member.wired = before
    return _trouble(live, [task]) or ("" if task in live.done else "the task is gone")


def clear(live: LiveSubsystem, task: str) -> Transaction:
    """Bring a task out of ERROR."""
    live.send(task, command.Clear(live.name, task))
    yield lambda: live.state(task) is not State.ERROR or task in live.trouble
    return _trouble(live, [task])


def close(live: LiveSubsystem) -> Transaction:
    """Kill every task."""
    yield from _switch(live, _on(live), ())
    yield from _kill(live, list(live.members))
    return ""


# Steps


def _kill_first(live: LiveSubsystem, exchange: Exchange, before: _Before) -> Step:
    """Old tasks that cannot live beside the new ones (decision 14)."""
    before.killed = [(live.members[name].wired, live.members[name].rtpu) for name in exchange.kill_first]
    yield from _switch(live, exchange.kill_first, ())
    yield from _kill(live, exchange.kill_first)


def _spawn(live: LiveSubsystem, new: Sequence[Newcomer]) -> Step:
    """Bring tasks to life; through when each is OFF, in trouble, or waits for a constant nobody supplies."""
    live.add(new)
    live.spawn_ready()
    names = [wired.name for wired, _ in new]
    yield (
        lambda: (
            all(
                live.state(name) is not State.WAITING or name in live.trouble or not live.members[name].is_sent
                for name in names
            )
            and not _is_coming(live, names)
        )
    )


def _is_coming(live: LiveSubsystem, names: Iterable[str]) -> bool:
    """Whether one of these is on its way to life."""
    return any(
        live.members[name].is_sent and live.state(name) is State.WAITING and name not in live.trouble for name in names
    )


def _commit(live: LiveSubsystem, edit: Edit, off: Sequence[str], on_now: Collection[str]) -> Step:
    """Off and on at one instant; where constants were exchanged, their consumers are initialised anew in between."""
    again = edit.exchange.reinit
    if not again:
        yield from _switch(live, off, edit.on, edit.rates)
        return
    back = [Turn(name, live.wanted.get(name, "")) for name in again if name in on_now and name not in off]
    yield from _switch(live, [*off, *(turn.task for turn in back)], (), edit.rates)
    for name in again:
        yield from _reinit(live, name)
    if not _trouble(live, again):
        asked = {turn.task for turn in edit.on}
        yield from _switch(live, (), [*_to_return(live, [one for one in back if one.task not in asked]), *edit.on])


def _to_return(live: LiveSubsystem, turns: Sequence[Turn]) -> list[Turn]:
    """Who comes on again by itself: all, but after a change of shapes no hardware before somebody says so (law 12)."""
    if not live.reshaping.has_changed:
        return list(turns)
    for turn in turns:
        if live.members[turn.task].wired.sheet.hardware:
            live.wanted.pop(turn.task, None)
            live.warn(turn.task, "shapes have changed: it stays OFF until it is turned on")
    return [turn for turn in turns if not live.members[turn.task].wired.sheet.hardware]


def _reinit(live: LiveSubsystem, name: str, local: Lines | None = None) -> Step:
    """Bind a task to what its shapes are now, then let it take over its constants; one that failed waits for clear."""
    if not live.members[name].is_sent:
        return
    ports = live.reshaping.ports(live.subsystem, name)
    if ports or local is not None:
        live.done.discard(name)
        live.send(name, command.Rebind(live.name, name, ports, local))
        yield lambda: name in live.done or name in live.trouble
    if name not in live.trouble and live.state(name) is State.OFF:
        live.done.discard(name)
        live.send(name, command.Reinit(live.name, name))
        yield lambda: name in live.done or name in live.trouble


def _switch(
    live: LiveSubsystem, off: Sequence[str], on: Sequence[Turn], rates: tuple[tuple[str, float], ...] = ()
) -> Step:
    """Tasks off and on at one instant; through when each has got there or said why not."""
    rate = dict(rates)
    launches = [command.Launch(turn.task, turn.arguments, rate.pop(turn.task, None)) for turn in on]
    clashes = live.subsystem.clashes(off, [turn.task for turn in on])
    live.trouble |= {name: f"on: {reason}" for name, reason in clashes}
    unborn = {turn.task: live.reasons.get(turn.task, "") for turn in on if not live.members[turn.task].is_sent}
    live.trouble |= {name: f"on: it {reason}" for name, reason in unborn.items()}
    if clashes or unborn or not (off or on or rates):
        return
    live.switch(off, launches, tuple(rate.items()))
    yield (
        lambda: (
            all(live.state(name) not in (State.ON, State.ASKING) for name in off)
            and all(live.state(turn.task) in (State.ON, State.ASKING) or turn.task in live.trouble for turn in on)
        )
    )


def _kill(live: LiveSubsystem, names: Sequence[str]) -> Step:
    """End tasks; those that were never born are only forgotten."""
    here = [name for name in names if name in live.members]
    for name in here:
        if live.members[name].is_sent:
            live.send(name, command.Kill(live.name, name))
    yield lambda: all(not live.members[name].is_sent or live.state(name) is State.KILLED for name in here)
    live.remove(here)


def _take_back(live: LiveSubsystem, edit: Edit, born: Sequence[str], before: _Before) -> Step:
    """As it was: the new ones die, the old ones live, and what was ON comes on again."""
    trouble = dict(live.trouble)
    live.trouble.clear()
    yield from _switch(live, [name for name in _on(live) if name not in before.on], ())
    yield from _kill(live, born)
    yield from _spawn(live, before.killed)
    again = [name for name in edit.exchange.reinit if live.state(name) in (State.OFF, State.ON, State.ASKING)]
    yield from _switch(live, again, ())
    olds = [name for name in edit.exchange.kill if name in live.members and live.state(name) is State.OFF]
    for name in [*olds, *again] if again else []:
        yield from _reinit(live, name)
    on = [Turn(name, line) for name, line in before.on.items() if live.state(name) is State.OFF]
    yield from _switch(live, (), on)
    live.trouble = trouble | live.trouble


def _remember(live: LiveSubsystem, edit: Edit) -> None:
    """What is wanted from now on."""
    for name in edit.off:
        live.wanted.pop(name, None)
    live.wanted |= {turn.task: turn.arguments for turn in edit.on}
    live.rates |= dict(edit.rates)


def _on(live: LiveSubsystem) -> list[str]:
    return [name for name in live.members if live.state(name) in (State.ON, State.ASKING)]


def _trouble(live: LiveSubsystem, names: Iterable[str]) -> str:
    """What went wrong with these, as one sentence; empty if nothing did."""
    return "; ".join(f"{name}: {live.trouble[name]}" for name in dict.fromkeys(names) if name in live.trouble)


def rest(live: LiveSubsystem) -> Transaction:
    """Everything off: whoever held the subsystem is gone (X12)."""
    yield from _switch(live, _on(live), ())
    live.wanted.clear()
    return ""
