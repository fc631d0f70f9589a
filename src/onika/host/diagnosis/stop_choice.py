"""The choices at a stop: what can be done with a flow that stands still, and what it does (requirements E08, X06).

Only what the engine would not refuse is offered. Where the run ends there is nothing to choose.
"""

from collections.abc import Sequence

from onika.host.diagnosis.stall import last_of, waiting_for
from onika.host.diagnosis.stop_cause import Cause, CauseKind, is_of_pressed_button
from onika.wire.plan import PlannedFlow
from onika.wire.steer import Position
from onika.words.reason import Reason

Choice = tuple[str, Reason]
"""A command as it is typed, and what it does."""


def choices(cause: Cause, flows: Sequence[PlannedFlow], positions: Sequence[Position]) -> tuple[Choice, ...]:
    """What can be done, the likeliest first."""
    if cause.ends or cause.kind in (CauseKind.USER, CauseKind.LOST):
        return ()
    places = {position.subsystem: position for position in positions}
    names = {flow.subsystem: flow for flow in flows}
    choices: list[Choice] = []
    standing = _standing(cause, positions)
    for name in standing:
        if name in names and name in places:
            choices += _of_stopped(names[name], places[name], cause, len(flows) > 1)
    waiting = dict(waiting_for(standing[0], positions)) if standing else {}
    for name in dict.fromkeys((*_stuck(cause, positions), *waiting)):
        if name in places:
            choices += _of_waiting(places[name])
    return (*choices, ("abort", Reason.of("host.ends_the_run")))


def _standing(cause: Cause, positions: Sequence[Position]) -> list[str]:
    """The flows that stand at an error: the one meant, or the one that a deserted flow waits for."""
    if cause.kind is CauseKind.DEADLOCK:
        return []
    name = last_of(cause.subsystem, positions) if cause.kind is CauseKind.DESERTED else cause.subsystem
    return [position.subsystem for position in positions if position.subsystem == name and position.state == "stopped"]


def _stuck(cause: Cause, positions: Sequence[Position]) -> list[str]:
    if cause.kind is CauseKind.DESERTED:
        return [cause.subsystem]
    if cause.kind is not CauseKind.DEADLOCK:
        return []
    behind = [name for name, _ in waiting_for(cause.subsystem, positions)]
    awaited = {name for position in positions if position.state == "waiting" for name in position.waits_for}
    return [cause.subsystem, *(name for name in behind if name in awaited)]


def _of_stopped(flow: PlannedFlow, at: Position, cause: Cause, is_one_of_several: bool) -> list[Choice]:
    whom = f" {flow.subsystem}" if is_one_of_several else ""
    failed = at.failed or ((cause.task,) if cause.kind is not CauseKind.REFUSED and cause.task else ())
    clears = Reason.of("host.clears", tasks=tuple(failed)) if failed else Reason.of("host.tries_again")
    count = len(flow.actions)
    if not 0 <= at.action < count:
        return [(f"clear{whom}", _once_possible(cause, Reason.of("host.and_goes_on", what=clears)))]
    name = flow.actions[at.action].name
    meanings = [
        (f"clear{whom}", Reason.of("host.and_repeats", what=clears, action=name)),
        (f"next{whom}", Reason.of("host.but_leaves", action=name)),
    ]
    if count > 1:
        meanings.append((f"skip{whom} N", Reason.of("host.but_goes_on_with", count=count)))
    return [(command, _once_possible(cause, meaning)) for command, meaning in meanings]


def _once_possible(cause: Cause, meaning: Reason) -> Reason:
    """What a choice does, behind what has to be done before it at the drive."""
    if cause.kind is CauseKind.PRESSED or (cause.kind is CauseKind.REFUSED and is_of_pressed_button(cause.text)):
        return Reason.of("host.once_let_go", meaning=meaning)
    if cause.kind is CauseKind.TRIPPED:
        return Reason.of("host.once_free", meaning=meaning)
    return meaning


def _of_waiting(at: Position) -> list[Choice]:
    """A flow that waits for nested ones is not offered: whether it may pass depends on where they are."""
    if at.state != "waiting":
        return []
    return [(f"pass {at.subsystem}", Reason.of("host.goes_on_alone", flows=at.waits_for))]
