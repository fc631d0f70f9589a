"""What a person has to do after a fault; nothing that moves comes back by itself (requirements E08, X24)."""

from onika.host.diagnosis.stop_cause import Cause, CauseKind
from onika.host.diagnosis.stop_choice import choices
from onika.host.foresight.outlook import Outlook
from onika.model.lifecycle import State
from onika.ring.device import DriveState
from onika.words.reason import NOTHING, Reason

DEVICES = "device server"
"""The name under which the loss of the device server is told."""
_KINDS = {DriveState.PRESSED: CauseKind.PRESSED, DriveState.TRIPPED: CauseKind.TRIPPED}


def after_task(outlook: Outlook, _subject: str) -> tuple[Reason, ...]:
    """What it takes until the tasks work again that have failed or ended."""
    return (*_steering(outlook), *_beginning_anew(outlook), *_clearing(outlook), *after_unit(outlook, ""))


def after_unit(outlook: Outlook, _subject: str) -> tuple[Reason, ...]:
    """A unit that is gone does not come back by itself: a person starts it anew, a device server with the runtime."""
    lost = [effect.subject for effect in outlook.effects if effect.kind == "unit"]
    units = tuple(name for name in lost if name != DEVICES)
    anew = (Reason.of("foresight.do_start_anew", units=units),) if units else ()
    return (*anew, Reason.of("foresight.do_start_devices")) if DEVICES in lost else anew


def after_run(outlook: Outlook, _subject: str) -> tuple[Reason, ...]:
    """What it takes until runs go on."""
    return (*_steering(outlook), *_beginning_anew(outlook))


def _steering(outlook: Outlook) -> tuple[Reason, ...]:
    """Where a flow stands at an error: the choices that its user then has, as they are offered there."""
    offered: list[Reason] = []
    for number, run in enumerate(outlook.situation.runs):
        positions = outlook.positions(number)
        for position in positions:
            if position.state != "stopped" or outlook.is_over(number):
                continue
            task = next(iter(position.failed), "")
            cause = Cause(_kind(outlook, position.subsystem, task), NOTHING, position.subsystem, task)
            lines = choices(cause, run.flows, positions)
            offered += [
                Reason.of("foresight.do_choose", command=command, meaning=meaning) for command, meaning in lines
            ]
    return tuple(dict.fromkeys(offered))


def _kind(outlook: Outlook, subsystem: str, task: str) -> CauseKind:
    facts = outlook.situation.tasks.get((subsystem, task))
    drive = None if facts is None else outlook.drives.get(facts.device)
    if drive is None:
        return CauseKind.ERROR
    return _KINDS.get(drive.shown, CauseKind.ERROR)


def _beginning_anew(outlook: Outlook) -> tuple[Reason, ...]:
    runs = outlook.situation.runs
    ended = tuple(run.application for number, run in enumerate(runs) if outlook.is_over(number))
    return (Reason.of("foresight.do_run_again", applications=ended),) if ended else ()


def _clearing(outlook: Outlook) -> tuple[Reason, ...]:
    """By hand: whoever holds tasks in ERROR clears them and turns them on, writers before the device that they feed."""
    tasks = outlook.situation.tasks
    failures = [effect.subject for effect in outlook.effects if effect.after == State.ERROR.value]
    by_hand = {
        "/".join(address): tasks[address].wired.sheet.hardware
        for address, state in outlook.states.items()
        if state is State.ERROR and outlook.situation.run_of(address[0]) is None
    }
    in_order = [*(task for task in by_hand if task not in failures), *filter(by_hand.__contains__, failures)]
    failed = tuple(sorted(dict.fromkeys(in_order), key=by_hand.__getitem__))
    return (Reason.of("foresight.do_clear", tasks=failed),) if failed else ()
