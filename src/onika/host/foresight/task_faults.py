"""Faults of tasks: one fails, is late, does not return, has no partner any more, or writes what is no number."""

from onika.host.foresight.fault_kind import FaultKind
from onika.host.foresight.outlook import Outlook
from onika.host.foresight.process_faults import freeze_unit
from onika.host.foresight.remedies import after_task
from onika.host.foresight.situation import Address, ForeseenTask, Situation
from onika.model.lifecycle import LifecycleInput, State
from onika.runtime.partner.absence import without_partner
from onika.runtime.wiring import upstream
from onika.words.reason import Reason

_PATIENCE_S = 1.0
"""How long a partner may take where a task does not say it."""


def _address(subject: str) -> Address:
    subsystem, _, name = subject.rpartition("/")
    return subsystem, name


def _on(situation: Situation) -> list[ForeseenTask]:
    return [facts for facts in situation.tasks.values() if facts.state is State.ON]


def _tasks_on(situation: Situation) -> tuple[str, ...]:
    return tuple("/".join(facts.address) for facts in _on(situation))


def _fail(outlook: Outlook, subject: str) -> None:
    address = _address(subject)
    outlook.fail(address, Reason.of("foresight.task_fails", task=subject), outlook.situation.tasks[address].period_ms)


def _last_values(outlook: Outlook, subject: str) -> tuple[Reason, ...]:
    """Who goes on with what the task has written last."""
    address = _address(subject)
    written = outlook.situation.tasks[address].wired.outvar
    notes = []
    for other in outlook.on_in([address[0]]):
        names = [name for name in outlook.situation.tasks[other].wired.invar if name in written]
        if names and other != address:
            notes.append(Reason.of("foresight.last_value", task="/".join(other), names=tuple(names)))
    return tuple(notes)


def _mending(outlook: Outlook, subject: str) -> tuple[Reason, ...]:
    return (Reason.of("foresight.error_entry"), *_last_values(outlook, subject))


def _be_late(_outlook: Outlook, _subject: str) -> None:
    """Missed periods are counted and skipped, never caught up (law 1): nobody's state changes."""


def _late(outlook: Outlook, subject: str) -> tuple[Reason, ...]:
    facts = outlook.situation.tasks[_address(subject)]
    return (Reason.of("foresight.skipped", period_ms=facts.period_ms), *_last_values(outlook, subject))


def _hang(outlook: Outlook, subject: str) -> None:
    freeze_unit(outlook, outlook.situation.tasks[_address(subject)].unit)


def _variables(situation: Situation) -> tuple[str, ...]:
    """The variables of numbers that tasks write in every cycle."""
    ports = [(facts.subsystem, port) for facts in _on(situation) for port in facts.wired.ports]
    names = [
        f"{subsystem}/{port.svar}"
        for subsystem, port in ports
        if port.kind.at_cycle and not port.kind.is_input and port.shape.type.is_real
    ]
    return tuple(dict.fromkeys(names))


def _write_nan(outlook: Outlook, subject: str) -> None:
    """The input guard of hardware lets nothing in that is not finite (law 5); other tasks read what is written."""
    subsystem, variable = _address(subject)
    cause = Reason.of("foresight.nan", variable=subject)
    tasks = [facts for facts in _on(outlook.situation) if facts.subsystem == subsystem]
    written_ms = max((facts.period_ms for facts in tasks if variable in facts.wired.outvar), default=0.0)
    for facts in tasks:
        if facts.wired.sheet.hardware and variable in facts.wired.invar:
            outlook.fail(facts.address, cause, written_ms + facts.period_ms)


def _passed_on(outlook: Outlook, subject: str) -> tuple[Reason, ...]:
    """The hardware that it reaches only through others, if they pass it on."""
    subsystem, variable = _address(subject)
    wired = [facts.wired for facts in _on(outlook.situation) if facts.subsystem == subsystem]
    return tuple(
        Reason.of("foresight.passed_on", task=f"{subsystem}/{task.name}", variable=variable)
        for task in wired
        if task.sheet.hardware and variable not in task.invar and variable in upstream(wired, task.invar)
    )


def _talkers(situation: Situation) -> tuple[str, ...]:
    return tuple("/".join(facts.address) for facts in _on(situation) if facts.has_partner)


def _lose_partner(outlook: Outlook, subject: str) -> None:
    address = _address(subject)
    facts = outlook.situation.tasks[address]
    at_ms = facts.period_ms + 1000.0 * _patience_s(facts)
    is_synchronous = facts.wired.task.type == "synchronous"
    if is_synchronous and without_partner(facts.wired.sheet.passive) is LifecycleInput.OFF:
        outlook.turn_off(address, at_ms, "OFF")
    else:
        outlook.fail(address, Reason.of("foresight.partner", task=subject), at_ms)


def _patience_s(facts: ForeseenTask) -> float:
    words = next((words for key, words in facts.wired.task.local if key == "PATIENCE" and words), None)
    try:
        return _PATIENCE_S if words is None else float(words[0])
    except ValueError:
        return _PATIENCE_S


FAILS = FaultKind(
    "task", _tasks_on, lambda task: Reason.of("foresight.task_fails", task=task), _fail, after_task, _mending
)
LATE = FaultKind("late", _tasks_on, lambda task: Reason.of("foresight.task_late", task=task), _be_late, notes=_late)
HANGS = FaultKind("hangs", _tasks_on, lambda task: Reason.of("foresight.task_hangs", task=task), _hang, after_task)
NAN = FaultKind(
    "nan", _variables, lambda name: Reason.of("foresight.nan", variable=name), _write_nan, after_task, _passed_on
)
PARTNER = FaultKind(
    "partner",
    _talkers,
    lambda task: Reason.of("foresight.partner", task=task),
    _lose_partner,
    after_task,
    _last_values,
)
