"""Configurations as files: how they are read, written, taken over and left (requirements C06, C21)."""

from dataclasses import replace
from pathlib import Path

from onika.desk.environment.file.elsewhere import differences
from onika.desk.environment.file.file_kind import READ_AGAIN, FileReading, place
from onika.desk.environment.outcome.other_tasks import with_other_tasks
from onika.desk.environment.outcome.outcome import Done, No, Order
from onika.desk.environment.outcome.remedy import unreadable
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.history import UndoStep
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_file import DocumentKind
from onika.model.configuration import Configuration
from onika.model.rules import loci
from onika.store.base_directory import BaseDirectory
from onika.store.opened_text import Faults, OpenedText
from onika.store.site import Site
from onika.wire import act, live
from onika.wire.view import Remedy
from onika.words.fault import Refusal
from onika.words.reason import NOTHING, Reason

_MANY = 3
"""Tasks of which only the number is said."""


def new(model: Model, _asked: act.New, _outside: Services) -> Done | No:
    """Open a blank configuration."""
    return opened_beside(model, None, None, model.blank())


def read(path_or_name: str, outside: Services) -> FileReading[Configuration] | No:
    """A configuration by the path of its file, or by its name on the search path."""
    where = place(path_or_name, DocumentKind.CONFIGURATION, outside)
    if isinstance(where, No):
        return where
    reading = _read(*where)
    if isinstance(reading, FileReading):
        return reading
    return No(unreadable(path_or_name, reading))


def opened_beside(
    model: Model, base: BaseDirectory | None, opened: OpenedText[Configuration] | None, configuration: Configuration
) -> Done:
    """With one more document, whose id is the value."""
    number = model.opened + 1
    doc = DocumentKind.CONFIGURATION.id(number)
    document = Document(doc, Content(configuration), opened=opened, base=base.path if base else None)
    return Done(replace(model.with_document(document), opened=number), value=document.id)


class Configurations:
    """Configurations as a kind of files."""

    def read(self, _model: Model, path_or_name: str, outside: Services) -> FileReading[Configuration] | No:
        """A configuration by its path or name."""
        return read(path_or_name, outside)

    def read_again(self, _model: Model, base: BaseDirectory, name: str) -> FileReading[Configuration] | Faults:
        """A configuration of a base directory."""
        return _read(base, name)

    def open(self, model: Model, reading: FileReading[Configuration]) -> Done:
        """It is open beside the others; where only a blank one was open, in its place."""
        opened = _with_loci(model, reading.opened)
        done = opened_beside(model, reading.base, opened, opened.value)
        blank = [document for document in model.documents.values() if _is_untouched(document)]
        if len(model.documents) == 1 and blank:
            done = replace(done, model=done.model.without(blank[0].id))  # as everywhere: it makes room
        return done

    def as_seen(self, model: Model, document: Document) -> Document:
        """With what was changed of its tasks in the libraries and is not saved there."""
        configuration = model.libraries.as_seen(document.content.configuration)
        return document.having(replace(document.content, configuration=configuration))

    def elsewhere(self, model: Model, document: Document, path: Path, site: Site) -> tuple[Reason, ...]:
        """Tasks of which other files count there, or none."""
        return tuple(differences(model, document.content.configuration, path, site).values())

    def loss(self, _document: Document, _path: Path) -> Reason:
        """Nothing is lost: configurations are read whole, or not at all."""
        return NOTHING

    def path(self, base: BaseDirectory, name: str) -> Path:
        """The file of a configuration."""
        return base.configuration_file(name)

    def write(
        self, base: BaseDirectory, name: str, document: Document, *, overwrites: bool
    ) -> OpenedText[Configuration] | Refusal | No:
        """Write it under a name."""
        return base.save_configuration(replace(document.value, name=name), document.opened, overwrites=overwrites)

    def saved(self, model: Model, document: Document, opened: OpenedText[Configuration], base: Path) -> Done:
        """It was saved there."""
        content = replace(document.content, configuration=opened.value)
        document = replace(document, content=content, opened=opened, base=base, has_changed_on_disk=False)
        return Done(model.with_document(document), value=str(opened.path))

    def close(self, model: Model, document: Document, alive: str, *, discards: bool) -> Done | No:
        """Close it; a configuration is always open. Tasks that live are ended or left, as `alive` says."""
        subsystem_facts = document.live if document.live and document.live.state == "live" else None
        moving = [task for task, facts in subsystem_facts.tasks.items() if facts.is_moving] if subsystem_facts else []
        if moving and alive == "ask":
            return _asked_about(document, moving, discards=discards)
        left = model.without(document.id)
        done = Done(left) if left.documents else opened_beside(left, None, None, left.blank())
        if subsystem_facts is None or not subsystem_facts.tasks or alive == "leave":
            return done
        return replace(done, orders=(Order(live.Close(subsystem_facts.subsystem)),))

    def reread(self, model: Model, document: Document, reading: FileReading[Configuration]) -> Done:
        """The tasks of its file are placed; what lives follows."""
        document = replace(document, opened=reading.opened, has_changed_on_disk=False)
        return with_other_tasks(model, document, reading.opened.value, READ_AGAIN)

    def refreshed(self, document: Document, reading: FileReading[Configuration], step: int) -> Document:
        """With what its file says now, as a step with this number."""
        content = Content(reading.opened.value)
        history = document.history.done(UndoStep(READ_AGAIN, "", document.content, content, step))
        return replace(document, content=content, history=history, opened=reading.opened, has_changed_on_disk=False)

    def is_in_use(self, _model: Model, document: Document) -> bool:
        """Whether its tasks live."""
        return document.live is not None

    def at_fault(self, faults: Faults) -> Reason:
        """What is wrong with it now."""
        return Reason.of("run.now_at_fault", faults=tuple(fault.sentence for fault in faults))


def _with_loci(model: Model, opened: OpenedText[Configuration]) -> OpenedText[Configuration]:
    """With a locus for each variable where the file has none at all: they are only drawn, and may be left out."""
    configuration = opened.value
    if configuration.loci:
        return opened
    boxes = model.libraries.within(configuration).boxes(tuple(placed.task for placed in configuration.placed))
    return replace(opened, value=loci.settled(configuration, boxes, configuration))


def _read(base: BaseDirectory, name: str) -> FileReading[Configuration] | Faults:
    opened, faults = base.open_configuration(name)
    if opened is None:
        return faults
    return FileReading(base, opened, faults)


def _asked_about(document: Document, moving: list[str], *, discards: bool) -> No:
    """Nobody would see any more what goes on moving."""
    if len(moving) < _MANY:
        reason = Reason.of("run.are_on", names=tuple(moving), name=document.name)
    else:
        reason = Reason.of("run.many_are_on", count=len(moving), name=document.name)
    end = Remedy(Reason.of("run.end_and_close"), act.Close(document.id, discards, "end"))
    leave = Remedy(Reason.of("run.leave_and_close"), act.Close(document.id, discards, "leave"))
    return No(reason, (end, leave))


def _is_untouched(document: Document) -> bool:
    return document.opened is None and not document.content.configuration.placed and document.live is None
