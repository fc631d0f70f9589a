"""The answer to a fault that could come, in a sentence made of what an outlook has found (requirement X24)."""

from collections.abc import Iterable, Sequence

from onika.host.foresight.fault_kind import FaultKind
from onika.host.foresight.outlook import Outlook
from onika.host.foresight.situation import Situation
from onika.model.lifecycle import State
from onika.ring.device import DriveState
from onika.wire.foresight import Effect, Foresight
from onika.words.reason import Reason


def foresight(fault: FaultKind, subject: str, situation: Situation) -> Foresight:
    """What follows from a fault, found on a copy of the situation."""
    outlook = Outlook(situation)
    fault.unfold(outlook, subject)
    effects = tuple(sorted(outlook.effects, key=lambda effect: effect.within_ms))
    parts = (*_drives(outlook, effects), *_tasks(effects), *_others(effects), *_run_that_goes_on(outlook, effects))
    said = parts or (Reason.of("foresight.nothing_changes"),)
    return Foresight(
        fault.name,
        subject,
        fault.question(subject),
        Reason.of("foresight.answer", parts=(*said, *_told(effects))),
        effects,
        fault.to_do(outlook, subject),
        fault.notes(outlook, subject),
    )


def _drives(outlook: Outlook, effects: Sequence[Effect]) -> Iterable[Reason]:
    """What the drives do: they come first, for they move."""
    changes = [effect for effect in effects if effect.kind == "drive"]
    for state in (DriveState.HELD, DriveState.PRESSED, DriveState.TRIPPED):
        of_state = [effect for effect in changes if effect.after == state.name]
        if of_state:
            yield _of_drives(state, _subjects(of_state), max(effect.within_ms for effect in of_state))
    gone = _subjects(effect for effect in changes if effect.after == "GONE")
    if gone:
        yield Reason.of("foresight.drives_gone", devices=gone)
    moving = tuple(
        device
        for device, drive in outlook.drives.items()
        if drive.shown is DriveState.DRIVEN and device not in {effect.subject for effect in changes}
    )
    if moving:
        yield Reason.of("foresight.drives_driven", devices=moving)


def _of_drives(state: DriveState, devices: tuple[str, ...], ms: float) -> Reason:
    if state is DriveState.HELD:
        return Reason.of("foresight.drives_hold", devices=devices, ms=ms)
    if state is DriveState.PRESSED:
        return Reason.of("foresight.drives_pressed", devices=devices, ms=ms)
    return Reason.of("foresight.drives_trip", devices=devices, ms=ms)


def _tasks(effects: Sequence[Effect]) -> Iterable[Reason]:
    """What becomes of tasks in the end, and of those that were in ERROR on the way."""
    changes = [effect for effect in effects if effect.kind == "task"]
    last = {effect.subject: effect for effect in changes}
    failed = _subjects(effect for effect in changes if effect.after == State.ERROR.value)
    if failed:
        ms = max(effect.within_ms for effect in changes if effect.after == State.ERROR.value)
        yield Reason.of("foresight.tasks_fail", tasks=failed, ms=ms)
    off = [effect for effect in last.values() if effect.after == State.OFF.value]
    if off:
        yield Reason.of("foresight.tasks_off", tasks=_subjects(off), ms=max(effect.within_ms for effect in off))
    ended = [effect for effect in last.values() if effect.after == State.KILLED.value]
    if ended:
        ms = max(effect.within_ms for effect in ended)
        yield Reason.of("foresight.tasks_end", count=len(ended), ms=ms)


def _others(effects: Sequence[Effect]) -> Iterable[Reason]:
    """What becomes of flows, runs, subsystems, units, the runtime and a recording."""
    seen = {effect.subject for effect in effects if effect.kind == "run"}
    for effect in effects:
        if effect.kind not in ("task", "drive", "flow") or (effect.kind == "flow" and not seen):
            yield effect.text


def _run_that_goes_on(outlook: Outlook, effects: Sequence[Effect]) -> Iterable[Reason]:
    ended = {effect.subject for effect in effects if effect.kind == "run"}
    standing = {effect.subject for effect in effects if effect.kind == "flow"}
    for run in outlook.situation.runs:
        if run.application not in ended and not standing & set(run.subsystems):
            yield Reason.of("foresight.run_goes_on", application=run.application)


def _told(effects: Sequence[Effect]) -> tuple[Reason, ...]:
    """By when everybody who attends has been told all of it."""
    told = [effect.within_ms for effect in effects if effect.told]
    if told:
        return (Reason.of("foresight.all_told", ms=max(told)),)
    if effects:
        return (Reason.of("foresight.nobody_told"),)
    return ()


def _subjects(effects: Iterable[Effect]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(effect.subject for effect in effects))
