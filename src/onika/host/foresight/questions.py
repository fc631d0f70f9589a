"""Every question that can be asked of a runtime about faults, and its answers (requirement X24).

Asking looks, and moves nothing: what is asked of the drives is answered when their process has said it, and nothing
waits for that.
"""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Protocol

from onika.host.foresight import process_faults, task_faults, user_faults
from onika.host.foresight.answer import foresight
from onika.host.foresight.fault_kind import FaultKind
from onika.host.foresight.planned import planned
from onika.host.foresight.present import present
from onika.host.foresight.situation import SessionFacts, Situation
from onika.host.loading.plan_preparation import Preparation
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.ring.drive import DriveMode
from onika.wire import request
from onika.wire.foresight import Foreseen, Foresight, WhatIf
from onika.words.reason import Reason

FAULTS: tuple[FaultKind, ...] = (
    user_faults.STOP,
    user_faults.BUTTON,
    user_faults.DRIVE,
    user_faults.LINK,
    user_faults.HOLDER,
    user_faults.ENVIRONMENT,
    user_faults.BROWSER,
    task_faults.FAILS,
    task_faults.LATE,
    task_faults.HANGS,
    task_faults.NAN,
    task_faults.PARTNER,
    process_faults.UNIT_KILLED,
    process_faults.UNIT_FROZEN,
    process_faults.DEVICES_KILLED,
    process_faults.DEVICES_FROZEN,
    process_faults.RUNTIME_KILLED,
    process_faults.RUNTIME_FROZEN,
    process_faults.DISK,
)

Answer = Callable[[request.Response], None]
Modes = Mapping[str, DriveMode]


class AskedDriver(Protocol):
    """Where drives say how they stand."""

    def ask_modes(self, answer: Callable[[Modes], None]) -> None:
        """Say it as soon as that is there; never waits."""
        ...


class Questions:
    """Answers `WhatIf`; `sessions` says who is there, `records` which application is recorded."""

    def __init__(
        self,
        subsystems: Subsystems,
        driver: AskedDriver,
        sessions: Callable[[], Mapping[str, SessionFacts]],
        records: Callable[[], str],
    ) -> None:
        self._subsystems = subsystems
        self._driver = driver
        self._sessions = sessions
        self._records = records

    def ask(self, session: str, message: WhatIf, prepared: Preparation | None, answer: Answer) -> None:
        """Answer when the drives have said how they stand; of a plan at once."""
        if not message.is_planned:
            self._driver.ask_modes(partial(self._answer, message, answer))
        elif prepared is None:
            answer(request.Refused(Reason.of("host.no_plan")))
        else:
            units = {wish: self._subsystems.unit(wish) for wish in _wishes(prepared)}
            begin = request.Begin(on_loss=message.on_loss, on_error=message.on_error)
            situation = planned(prepared, session, begin, units, self._sessions())
            answer(respond(message, situation))

    def _answer(self, message: WhatIf, answer: Answer, modes: Modes) -> None:
        answer(respond(message, present(self._subsystems, modes, self._sessions(), self._records())))


def respond(message: WhatIf, situation: Situation) -> request.Response:
    """What can be asked, or the answers to what was asked."""
    if not message.fault:
        return Foreseen(tuple(_asked(fault, subject) for fault in FAULTS for subject in fault.subjects(situation)))
    fault = next((fault for fault in FAULTS if fault.name == message.fault), None)
    if fault is None:
        names = tuple(fault.name for fault in FAULTS)
        return request.Refused(Reason.of("foresight.no_such_fault", names=names, fault=message.fault))
    subjects = fault.subjects(situation)
    if message.subject and message.subject not in subjects:
        return request.Refused(Reason.of("foresight.not_concerned", subjects=subjects, subject=message.subject))
    if not subjects:
        return request.Refused(Reason.of("foresight.cannot_come", fault=message.fault))
    if not message.subject and len(subjects) > 1:
        return request.Refused(Reason.of("foresight.say_whom", fault=message.fault, subjects=subjects))
    return Foreseen((foresight(fault, message.subject or subjects[0], situation),))


def _asked(fault: FaultKind, subject: str) -> Foresight:
    return Foresight(fault.name, subject, fault.question(subject))


def _wishes(prepared: Preparation) -> set[str]:
    return {wired.task.rtpu for tasks in prepared.flows for wired in tasks}
