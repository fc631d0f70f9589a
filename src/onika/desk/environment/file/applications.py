"""Applications as files: how they are read, as far as they can be, written and taken over (requirements D04, X10)."""

from dataclasses import replace
from pathlib import Path

from onika.desk.environment.file.file_kind import READ_AGAIN, FileReading, place
from onika.desk.environment.outcome.on_file import is_running
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.remedy import unreadable
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.outcome.unread_faults import told
from onika.desk.environment.state.history import UndoStep
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import MOST_FLOWS, OpenApplication
from onika.desk.environment.state.open_file import DocumentKind
from onika.model.application import AppFlow, Application
from onika.model.flow_path import numbered
from onika.store.base_directory import BaseDirectory
from onika.store.opened_text import Faults, OpenedText
from onika.store.site import Site
from onika.wire import act, page
from onika.words.fault import Refusal
from onika.words.name import TASK_NAME
from onika.words.reason import NOTHING, Reason, reason_of

_NO_SYNTAX = Reason.of("run.definition_unread", file="OnikaUpperSetUp.dta")


def new(model: Model, command: act.NewApplication, outside: Services) -> Done | No:
    """Open a blank application; the value is its id."""
    del outside
    if model.syntax is None:
        return No(_NO_SYNTAX)
    if not 1 <= command.flows <= MOST_FLOWS:
        form = Reason.of("run.from_to", least=1, most=MOST_FLOWS)
        reason = Reason.of("run.application_flows", form=form, count=command.flows)
        return No(reason, fields={"flows": Reason.of("run.expected", form=form)})
    blank = Application(model.blank_name(), command.is_parallel, (AppFlow(()),) * command.flows)
    return _opened_beside(model, OpenApplication(_next_id(model), blank))


class Applications:
    """Applications as a kind of files."""

    def read(self, model: Model, path_or_name: str, outside: Services) -> FileReading[Application] | No:
        """An application by its path or name, with what could not be read of it."""
        if model.syntax is None:
            return No(_NO_SYNTAX)
        where = place(path_or_name, DocumentKind.APPLICATION, outside)
        if isinstance(where, No):
            return where
        base, name = where
        if not TASK_NAME.match(name):
            file = self.path(base, name).name
            return No(Reason.of("run.no_application_name", file=file))
        reading = self.read_again(model, base, name)
        if isinstance(reading, FileReading):
            return reading
        return No(unreadable(path_or_name, reading))

    def as_seen(self, _model: Model, opened: OpenApplication) -> OpenApplication:
        """As it is: an application holds all that is seen of it."""
        return opened

    def elsewhere(self, _model: Model, _opened: OpenApplication, _path: Path, _site: Site) -> tuple[Reason, ...]:
        """Nothing of its own: what its icons stand for is told of a run."""
        return ()

    def read_again(self, model: Model, base: BaseDirectory, name: str) -> FileReading[Application] | Faults:
        """An application of a base directory as far as its file can be read; the faults where that is nothing."""
        if model.syntax is None:
            return ()
        opened, faults = base.open_application(name, model.syntax)
        if opened is not None:
            return FileReading(base, opened, faults)
        opened, faults = base.salvage_application(name, model.syntax)
        if opened is None:
            return faults
        return FileReading(base, opened, faults, is_partial=True)

    def open(self, model: Model, reading: FileReading[Application]) -> Done:
        """It is open beside the others."""
        opened = OpenApplication(_next_id(model), reading.opened.value, base=reading.base.path)
        return _opened_beside(model, _taken_over(opened, reading))

    def loss(self, opened: OpenApplication, path: Path) -> Reason:
        """A file that could be read only in part is never overwritten without asking."""
        if not opened.is_partial or opened.opened is None or opened.opened.path != path:
            return NOTHING
        first = next(fault.text for fault in opened.file_faults if fault.level == "fault")
        return Reason.of("run.unread_lost", path=str(path), first=first)

    def path(self, base: BaseDirectory, name: str) -> Path:
        """The file of an application."""
        return base.application_file(name)

    def write(
        self, base: BaseDirectory, name: str, opened: OpenApplication, *, overwrites: bool
    ) -> OpenedText[Application] | Refusal | No:
        """Write it under a name; what no file can say is refused."""
        try:
            return base.save_application(replace(opened.value, name=name), opened.opened, overwrites=overwrites)
        except ValueError as wrong:
            return No(Reason.of("run.cannot_be_saved", name=name, why=reason_of(wrong)))

    def saved(self, model: Model, opened: OpenApplication, file: OpenedText[Application], base: Path) -> Done:
        """It was saved there; one that runs stays what it is, and its copy is open beside it."""
        if is_running(model, opened.id) and not (opened.opened and opened.opened.path == file.path):
            return _copied(model, opened, file, base)
        here = replace(opened, application=file.value, opened=file, base=base, has_changed_on_disk=False)
        return Done(model.with_application(replace(here, file_faults=(), is_partial=False)), value=str(file.path))

    def close(self, model: Model, opened: OpenApplication, _alive: str, *, discards: bool) -> Done | No:
        """Close it; none need be open."""
        del discards
        left = {doc: application for doc, application in model.applications.items() if doc != opened.id}
        return Done(replace(model, applications=left))

    def reread(self, model: Model, opened: OpenApplication, reading: FileReading[Application]) -> Done:
        """The steps of its file are taken over."""
        return Done(model.with_application(_taken_over(opened, reading)), label=READ_AGAIN, doc=opened.id)

    def refreshed(self, opened: OpenApplication, reading: FileReading[Application], step: int) -> OpenApplication:
        """With what its file says now, as a step with this number."""
        now = _taken_over(opened, reading)
        change = UndoStep(READ_AGAIN, "", opened.application, now.application, step)
        return replace(now, history=now.history.done(change))

    def is_in_use(self, model: Model, opened: OpenApplication) -> bool:
        """Whether it runs."""
        return is_running(model, opened.id)

    def at_fault(self, _faults: Faults) -> Reason:
        """It cannot be shown at all."""
        return Reason.of("run.unreadable_now")


def _next_id(model: Model) -> str:
    return DocumentKind.APPLICATION.id(model.opened + 1)


def open_program(model: Model, application: Application, puzzle: str) -> Done:
    """Open a program that is in no file, whose runs are judged by a puzzle; the value is its id."""
    program, last = numbered(application, 0)
    taken = {file.name for file in model.open_files}
    names = (application.name, *(f"{application.name}-{number}" for number in range(2, len(taken) + 3)))
    name = next(name for name in names if name not in taken)
    return _opened_beside(model, OpenApplication(_next_id(model), replace(program, name=name), last, puzzle=puzzle))


def _opened_beside(model: Model, opened: OpenApplication) -> Done:
    """With one more application, whose id is the value."""
    return Done(replace(model.with_application(opened), opened=model.opened + 1), value=opened.id)


def _taken_over(here: OpenApplication, reading: FileReading[Application]) -> OpenApplication:
    """With what stands in its file; every step gets a number that was never used here."""
    application, last = numbered(reading.opened.value, here.last_number)
    return replace(
        here,
        application=application,
        last_number=last,
        opened=replace(reading.opened, value=application),
        has_changed_on_disk=False,
        file_faults=told(application, reading.faults, is_partial=reading.is_partial),
        is_partial=reading.is_partial,
    )


def _copied(model: Model, opened: OpenApplication, file: OpenedText[Application], base: Path) -> Done:
    """The copy of one that runs is open beside it, to be changed; what runs stays what it is."""
    copy = OpenApplication(_next_id(model), file.value, opened.last_number, opened=file, base=base)
    text = Reason.of("run.copy_open", copy=copy.name, name=opened.name)
    done = _opened_beside(model, copy)
    return replace(done, value=str(file.path), says=(page.Say("info", text, copy.id),))
