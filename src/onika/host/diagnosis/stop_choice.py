"""The choices at a stop: what can be done with a flow that stands still, and what it does (requirements E08, X06).

Only what the engine would not refuse is offered. Where the run ends there is nothing to choose.
"""

from collections.abc import Sequence

from onika.host.diagnosis.stall import last_of, waiting_for
from onika.host.diagnosis.stop_cause import Cause, CauseKind
from onika.wire.plan import PlannedFlow
from onika.wire.steer import Position

Choice = tuple[str, str]
"""A command as it is typed, and what it does."""

_ABORT = ("abort", "ends the run: all tasks are killed, every drive holds")
_BEFORE = {
    CauseKind.PRESSED: "once the panic button is let go: ",
    CauseKind.TRIPPED: "once the way is free, for the arm may stand elsewhere now: ",
}


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
    return (*choices, _ABORT)


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
    clears = f"clears {' and '.join(failed)}" if failed else "tries again"
    is_pressed = cause.kind is CauseKind.REFUSED and "panic button" in cause.text
    before = _BEFORE.get(CauseKind.PRESSED if is_pressed else cause.kind, "")
    if not 0 <= at.action < len(flow.actions):
        return [(f"clear{whom}", f"{before}{clears} and goes on")]
    name = flow.actions[at.action].name
    found = [
        (f"clear{whom}", f"{before}{clears} and repeats {name} with the same target"),
        (f"next{whom}", f"{before}the same, but leaves {name} and goes on with what follows it"),
    ]
    if len(flow.actions) > 1:
        found.append((f"skip{whom} N", f"{before}the same, but goes on with action N of 1 to {len(flow.actions)}"))
    return found


def _of_waiting(at: Position) -> list[Choice]:
    """A flow that waits for nested ones is not offered: whether it may pass depends on where they are."""
    if at.state != "waiting":
        return []
    others = " and ".join(at.waits_for)
    return [(f"pass {at.subsystem}", f"lets it go on alone; safe only if it needs nothing of {others}")]
