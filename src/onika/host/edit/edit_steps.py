"""The steps of which edits of a live subsystem are made: each sends commands and yields what it waits for.

A step is through when all tasks it is about have got there, have said why not, or are gone with their unit: whatever
happens, none waits for ever.
"""

from collections.abc import Collection, Generator, Iterable, Mapping, Sequence

from onika.host.edit.live_subsystem import LiveSubsystem, Wait
from onika.host.edit.task_spawner import plainly
from onika.model.lifecycle import State
from onika.runtime import command
from onika.runtime.wiring import WiredTask
from onika.wire.live import Turn

Step = Generator[Wait, None, None]
Newcomer = tuple[WiredTask, str]
"""A task to be born, and its unit."""
Lines = tuple[tuple[str, tuple[str, ...]], ...]


def on_now(live: LiveSubsystem) -> list[str]:
    """The tasks that are ON, or would be if somebody answered them."""
    return [name for name in live.members if live.state(name) in (State.ON, State.ASKING)]


def trouble(live: LiveSubsystem, names: Iterable[str]) -> str:
    """What went wrong with these, as one sentence; empty if nothing did."""
    return "; ".join(f"{name}: {live.trouble[name]}" for name in dict.fromkeys(names) if name in live.trouble)


def spawn(live: LiveSubsystem, new: Sequence[Newcomer]) -> Step:
    """Bring tasks to life; through when each is OFF, in trouble, or waits for a constant nobody supplies."""
    live.add(new)
    live.spawn_ready()
    names = [wired.name for wired, _ in new]
    yield (
        lambda: (
            not any(
                live.members[name].is_sent and live.state(name) is State.WAITING and name not in live.trouble
                for name in names
            )
        )
    )


def kill(live: LiveSubsystem, names: Sequence[str]) -> Step:
    """End tasks; those that were never born are only forgotten."""
    here = [name for name in names if name in live.members]
    for name in here:
        if live.members[name].is_sent and live.state(name) is not State.KILLED:
            live.send(name, command.Kill(live.name, name))
    yield lambda: all(not live.members[name].is_sent or live.state(name) is State.KILLED for name in here)
    live.remove(here)


def switch(
    live: LiveSubsystem, off: Sequence[str], on: Sequence[Turn], rates: tuple[tuple[str, float], ...] = ()
) -> Step:
    """Tasks off and on at one instant, or none of it; through when each was there or has said why not."""
    names = [turn.task for turn in on]
    wrong = _why_not(live, off, names, [name for name, _ in rates])
    live.trouble |= wrong
    if wrong or not (off or on or rates):
        return
    going = [name for name in off if live.state(name) in (State.ON, State.ASKING)]
    live.went.difference_update(going)
    live.came.difference_update(names)
    rate = dict(rates)
    launches = [command.Launch(turn.task, turn.arguments, rate.pop(turn.task, None)) for turn in on]
    live.switch([name for name in off if live.state(name) is not State.KILLED], launches, tuple(rate.items()))
    yield (
        lambda: (
            all(name in live.went for name in going)
            and all(name in live.came or name in live.trouble for name in names)
        )
    )


def _why_not(live: LiveSubsystem, off: Collection[str], on: Sequence[str], rates: Sequence[str]) -> Mapping[str, str]:
    """What can be seen to be wrong with a switch before it is sent out."""
    wrong = {name: f"on: {reason}" for name, reason in live.subsystem.clashes(off, on)}
    for name in (*rates, *on):
        entry = "on" if name in on else "rate"
        if live.state(name) is State.KILLED:
            wrong[name] = f"{entry}: it is gone"
        elif not live.members[name].is_sent:
            wrong[name] = f"{entry}: it {live.reasons.get(name) or 'is not born yet'}"
        elif name in on and name not in off and live.state(name) in (State.ON, State.ASKING):
            wrong[name] = f"on: it is {live.state(name).value} already"
    return wrong


def reinit(live: LiveSubsystem, name: str, local: Lines | None = None) -> Step:
    """Bind a task to what its shapes are now, then let it take over its constants: in ERROR, when it is cleared."""
    if live.state(name) is State.KILLED or not live.members[name].is_sent:
        return
    yield from _rebind(live, name, local)
    if name in live.trouble:
        return
    if live.state(name) is State.ERROR:
        live.stale.add(name)
    elif live.state(name) is State.OFF:
        yield from _tell(live, name, command.Reinit(live.name, name))


def clear(live: LiveSubsystem, name: str) -> Step:
    """Bring a task out of ERROR, with the constants as they are now."""
    yield from _rebind(live, name, None)
    live.trouble.pop(name, None)
    live.send(name, command.Clear(live.name, name))
    yield lambda: live.state(name) is not State.ERROR or name in live.trouble
    if name in live.stale and live.state(name) is State.OFF:
        live.stale.discard(name)
        yield from _tell(live, name, command.Reinit(live.name, name))


def _rebind(live: LiveSubsystem, name: str, local: Lines | None) -> Step:
    live.trouble.pop(name, None)
    try:
        ports = live.reshaping.ports(live.subsystem, name)
    except (KeyError, ValueError) as wrong:
        live.trouble[name] = f"reinit: {plainly(wrong)}"
        return
    if ports or local is not None:
        yield from _tell(live, name, command.Rebind(live.name, name, ports, local))


def _tell(live: LiveSubsystem, name: str, order: command.Command) -> Step:
    live.done.discard(name)
    live.trouble.pop(name, None)
    live.send(name, order)
    yield lambda: name in live.done or name in live.trouble or live.state(name) is State.KILLED
