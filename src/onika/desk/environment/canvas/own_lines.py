"""Changes what a configuration says of a placed task otherwise than its file (requirements C04, B09)."""

from collections.abc import Mapping
from dataclasses import replace

from onika.desk.environment.outcome import pin_changes
from onika.desk.environment.outcome.clash import beside, refused
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.remedy import reasons
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.model.configuration import Placed
from onika.model.own_lines import NO_OWN_LINES, OwnLines
from onika.model.rules import placement
from onika.model.task import Task
from onika.words.reason import Reason


def placed_in(model: Model, doc: str, task: str) -> tuple[Document, Placed] | None:
    """The document that has a task placed, where it is one of a library; None: it is meant in its library."""
    document = model.documents.get(doc)
    placed = document.content.placed(task) if document is not None else None
    if document is None or placed is None or placed.file not in model.libraries.tasks:
        return None
    return document, placed


def changed(model: Model, home: tuple[Document, Placed], task: Task, label: Reason, cannot: Reason) -> Done | No:
    """With a task as it is to be in this configuration alone; a no where something speaks against it there."""
    document, placed = home
    own = OwnLines.between(model.libraries.tasks[placed.file], task)
    after = _with(document, placed, own)
    libraries = model.libraries.within(after.configuration)
    against = (
        *reasons(placement.alias_refusals(libraries.tasks[placed.task], ()), "", task),
        *beside(placed.task, document, model.libraries_of(document), libraries),
    )
    if against:
        return refused(cannot, tuple(dict.fromkeys(against)), "svar")
    content = pin_changes.retuned(document.content, after.configuration, model.libraries)
    return Done(model.with_document(document.having(content)), label, document.id)


def with_tasks(model: Model, document: Document, tasks: Mapping[str, Task]) -> Model:
    """With placed tasks as they are to be in this configuration alone, whose pins stay as they are."""
    for name, task in tasks.items():
        placed = document.content.placed(name)
        if placed is not None and placed.file in model.libraries.tasks:
            content = _with(document, placed, OwnLines.between(model.libraries.tasks[placed.file], task))
            document = document.having(content)
    return model.with_document(document)


def as_in_library(model: Model, home: tuple[Document, Placed], label: Reason) -> Done | No:
    """With a task as the library has it, where the configuration bears that."""
    task = replace(model.libraries.tasks[home[1].file], name=home[1].task)
    return changed(model, home, task, label, Reason.of("desk.not_as_filed", task=home[1].task))


def dropped(model: Model, home: tuple[Document, Placed]) -> Model:
    """Without lines of its own that the file has now."""
    document, placed = home
    configuration = _with(model.documents[document.id], placed, NO_OWN_LINES).configuration
    content = replace(model.documents[document.id].content, configuration=configuration)
    return model.with_document(model.documents[document.id].having(content))


def _with(document: Document, placed: Placed, own: OwnLines) -> Content:
    configuration = document.content.configuration
    changed = tuple(replace(each, own=own) if each.task == placed.task else each for each in configuration.placed)
    return replace(document.content, configuration=replace(configuration, placed=changed))
