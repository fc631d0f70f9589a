"""A document with another set of tasks: its loci are settled, and what is wanted of the tasks follows."""

from dataclasses import replace

from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.model.configuration import Configuration
from onika.model.rules import loci
from onika.words.reason import Reason


def with_other_tasks(model: Model, document: Document, configuration: Configuration, label: Reason) -> Done:
    """The outcome of giving a document another configuration; new tasks are wanted OFF where it is connected."""
    names = tuple(placed.task for placed in configuration.placed)
    former = document.content.configuration
    boxes = model.libraries.within(configuration).boxes(names)
    settled = loci.settled(configuration, boxes, former, model.libraries_of(document).boxes(document.content.names))
    content = document.content.with_configuration(settled)
    if document.live is not None:
        content = replace(content, wanted={**dict.fromkeys(names, False), **content.wanted})
    return Done(model.with_document(document.having(content)), label, document.id)
