"""The steps of which edits of a live subsystem are made: each sends commands and yields what it waits for.

A step is through when all tasks it is about have got there, have said why not, or are gone with their unit: whatever
happens, none waits for ever.
"""

from collections.abc import Collection, Generator, Mapping, Sequence

from onika.engine import orders
from onika.host.edit import failed_writers
from onika.host.execution.spawner import shape_fault
from onika.host.subsystems.live_subsystem import LiveSubsystem, Wait
from onika.model.lifecycle import State
from onika.runtime import command
from onika.runtime.wiring import WiredTask
from onika.wire.live import Turn
from onika.words.reason import Reason

Step = Generator[Wait, None, None]
Newcomer = tuple[WiredTask, str]
"""A task to be spawned, and its unit."""
Lines = tuple[tuple[str, tuple[str, ...]], ...]
Rates = tuple[tuple[str, float], ...]


def tasks_on(live: LiveSubsystem) -> list[str]:
    """The tasks that are ON, or would be if somebody answered them."""
    return [task for task in live.members if live.is_on(task)]


def spawn(live: LiveSubsystem, new: Sequence[Newcomer]) -> Step:
    """Bring tasks to life; through when each is OFF, in trouble, or waits for a constant nobody supplies."""
    live.add(new)
    live.executor.spawn_ready()
    tasks = [wired.name for wired, _ in new]
    yield lambda: not any(live.is_being_spawned(task) for task in tasks)


def kill(live: LiveSubsystem, tasks: Sequence[str]) -> Step:
    """End tasks; those that were never spawned are only forgotten."""
    here = [task for task in tasks if task in live.members]
    for task in here:
        live.executor.kill(task)
    yield lambda: not any(live.executor.is_alive(task) for task in here)
    live.remove(here)


def switch(live: LiveSubsystem, off: Sequence[str], on: Sequence[Turn], rates: Rates = ()) -> Step:
    """Tasks off and on at one instant, or none of it; through when each was there or has said why not."""
    coming = [turn.task for turn in on]
    objections = _objections(live, off, coming, [task for task, _ in rates])
    live.outcomes.fail_all(objections)
    if objections or not (off or on or rates):
        return
    going = [task for task in off if live.is_on(task)]
    live.outcomes.expect_switch(going, coming)
    live.executor.switch(_order(live, off, on, rates))
    yield lambda: _is_switched(live, going, coming)


def _order(live: LiveSubsystem, off: Sequence[str], on: Sequence[Turn], rates: Rates) -> orders.Switch:
    """The order for the executor; a rate of a task that comes on goes with its start."""
    kept_rates = dict(rates)
    starts = tuple(orders.Launch(turn.task, turn.arguments, kept_rates.pop(turn.task, None)) for turn in on)
    living = tuple(task for task in off if live.state(task) not in (State.KILLED, State.WAITING))
    return orders.Switch(0, living, starts, tuple(kept_rates.items()))


def _is_switched(live: LiveSubsystem, going: Sequence[str], coming: Sequence[str]) -> bool:
    outcomes = live.outcomes
    all_gone = all(outcomes.has_gone(task) for task in going)
    return all_gone and all(outcomes.has_come(task) or outcomes.has_trouble(task) for task in coming)


def _objections(
    live: LiveSubsystem, off: Collection[str], on: Sequence[str], rates: Sequence[str]
) -> Mapping[str, Reason]:
    """What can be seen to be wrong with a switch before it is sent out, by task."""
    whys = {**failed_writers.objections_to_switch(live, off, on), **dict(live.executor.subsystem.clashes(off, on))}
    objections = {task: _of_entry("on", why) for task, why in whys.items()}
    for task in (*rates, *on):
        entry = "on" if task in on else "rate"
        if live.state(task) is State.KILLED:
            objections[task] = _of_entry(entry, Reason.of("host.it_is_gone"))
        elif not live.members[task].is_sent:
            what = live.reason(task) or Reason.of("host.is_not_born_yet")
            objections[task] = _of_entry(entry, Reason.of("host.it_does", what=what))
        elif task in on and task not in off and live.is_on(task):
            objections[task] = _of_entry("on", Reason.of("host.it_is_already", state=live.state(task).value))
    return objections


def _of_entry(entry: str, why: Reason) -> Reason:
    return Reason.of("host.entry_failed", entry=entry, why=why)


def reinit(live: LiveSubsystem, task: str, local: Lines | None = None) -> Step:
    """Bind a task to what its shapes are now, then let it take over its constants: in ERROR, when it is cleared."""
    if not live.executor.is_alive(task):
        return
    yield from _rebind(live, task, local)
    if live.outcomes.has_trouble(task):
        return
    if live.state(task) is State.ERROR:
        live.desired.reinitialise_later(task)
    elif live.state(task) is State.OFF:
        yield from tell(live, task, command.Reinit(live.name, task))


def clear(live: LiveSubsystem, task: str) -> Step:
    """Bring a task out of ERROR, with the constants as they are now."""
    yield from _rebind(live, task, None)
    live.outcomes.excuse(task)
    live.executor.send(task, command.Clear(live.name, task))
    yield lambda: live.state(task) is not State.ERROR or live.outcomes.has_trouble(task)
    if live.desired.is_to_be_reinitialised(task) and live.state(task) is State.OFF:
        live.desired.is_reinitialised(task)
        yield from tell(live, task, command.Reinit(live.name, task))


def tell(live: LiveSubsystem, task: str, order: command.Command) -> Step:
    """Give a task a command that it answers; through when it has, refuses, or is gone."""
    live.outcomes.expect_answer(task)
    live.executor.send(task, order)
    yield (
        lambda: live.outcomes.has_answered(task) or live.outcomes.has_trouble(task) or live.state(task) is State.KILLED
    )


def _rebind(live: LiveSubsystem, task: str, local: Lines | None) -> Step:
    live.outcomes.excuse(task)
    try:
        ports = live.reshaping.ports(live.executor.subsystem, task)
    except (KeyError, ValueError) as error:
        live.outcomes.fail(task, _of_entry("reinit", shape_fault(error)))
        return
    if ports or local is not None:
        yield from tell(live, task, command.Rebind(live.name, task, ports, local))
