"""What is wrong with the file of an application, as it was read: each fault at the step where it stands (B07)."""

from collections.abc import Iterable

from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.state.open_application import OpenApplication
from onika.model.application import Application
from onika.model.flow_path import spots
from onika.wire.view import FaultView, Remedy, ShowSaveAs, ShowStep
from onika.words.fault import Fault
from onika.words.reason import Reason


def told(application: Application, faults: Iterable[Fault], *, is_partial: bool) -> tuple[FaultView, ...]:
    """The faults as a page shows them; `is_partial`: what they are about could not be read, and is not here."""
    lines = sorted((spot.step.line, number) for number, spot in spots(application).items() if spot.step.line)
    return tuple(_view(one, lines, is_partial) for one in faults)


def not_run(opened: OpenApplication) -> No | None:
    """Why an application of which not everything could be read is not run; None: it is whole."""
    if not opened.is_partial:
        return None
    lost = [one for one in opened.file_faults if one.level == "fault"]
    where = [one.step for one in lost if one.step][:1]
    show = tuple(Remedy(Reason.of("run.show_where"), show=ShowStep(step)) for step in where)
    if lost:
        reason = Reason.of("run.application_unread", name=opened.name, why=lost[0].text)
    else:
        reason = Reason.of("run.application_unread_in_part", name=opened.name)
    return No(reason, (*show, Remedy(Reason.of("run.save_as"), show=ShowSaveAs())))


def _view(fault: Fault, lines: list[tuple[int, int]], is_partial: bool) -> FaultView:
    line = fault.place.line
    before = [number for at, number in lines if at <= line]
    reason = Reason.of("run.at_line", line=line, reason=fault.reason) if line else fault.reason
    step = before[-1] if before and line else 0
    if is_partial and not fault.is_note:
        return FaultView(reason, "fault", step)
    return FaultView(Reason.of("run.fault_instead", reason=reason, instead=fault.instead), "warning", step)
