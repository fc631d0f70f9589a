"""What is wrong with the file of an application, as it was read: each fault at the step where it stands (B07)."""

from collections.abc import Iterable

from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.outcome.remedy import plain
from onika.desk.environment.state.open_application import OpenApplication
from onika.model.application import Application
from onika.model.flow_path import spots
from onika.wire.view import FaultView, Remedy, ShowSaveAs, ShowStep
from onika.words.fault import Fault


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
    show = tuple(Remedy("Show where", show=ShowStep(step)) for step in where)
    reason = f"{opened.name} could not be read whole: {lost[0].text}" if lost else f"{opened.name} was not read whole"
    return No(f"{reason}; mend it and save it first", (*show, Remedy("Save as…", show=ShowSaveAs())))


def _view(fault: Fault, lines: list[tuple[int, int]], is_partial: bool) -> FaultView:
    line = fault.place.line
    before = [number for at, number in lines if at <= line]
    where = f"line {line} of its file: " if line else ""
    text = f"{where}{fault.reason}"
    step = before[-1] if before and line else 0
    if is_partial and not fault.is_note:
        return FaultView(plain(text), "fault", step)
    return FaultView(plain(f"{text}; {fault.instead}"), "warning", step)
