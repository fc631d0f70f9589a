"""What becomes of open documents when the pins of library tasks change (reading 9, requirement C24)."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from onika.desk.environment.state.content import Content
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.model.configuration import Configuration
from onika.model.rules import loci
from onika.model.rules.box import TaskBox


def resettled(model: Model, before: OpenLibraries) -> Model:
    """With the loci of every document as its pins are now; `before` has the tasks that they were settled with."""
    for document in model.documents.values():
        content = settled(document.content, before, model.libraries)
        if content is not document.content:
            model = model.with_document(document.having(content))
    return model


def settled(content: Content, before: OpenLibraries, after: OpenLibraries) -> Content:
    """One content; the same object where no pin of its tasks has changed."""
    configuration = content.configuration
    return _settled(content, before.within(configuration), after.within(configuration))


def retuned(content: Content, configuration: Configuration, libraries: OpenLibraries) -> Content:
    """With the same tasks, of which the configuration says other things now."""
    changed = replace(content, configuration=configuration)
    return _settled(changed, libraries.within(content.configuration), libraries.within(configuration))


def _settled(content: Content, before: OpenLibraries, after: OpenLibraries) -> Content:
    if before is after:
        return content
    old, new = before.boxes(content.names), after.boxes(content.names)
    changed = [name for name in content.names if old.get(name) != new.get(name)]
    if not changed:
        return content
    # a task that comes or goes with its library leaves the picture as it is
    former = {name: old.get(name, box) for name, box in new.items()}
    configuration = _renamed(content.configuration, changed, old, new)
    return replace(content, configuration=loci.settled(configuration, new, configuration, former))


def _renamed(
    configuration: Configuration, changed: Sequence[str], old: Mapping[str, TaskBox], new: Mapping[str, TaskBox]
) -> Configuration:
    """A locus that only changed tasks used keeps its place under their new name for it."""
    used = {svar for box in new.values() for svar in box.uses}
    stand = {one.svar for one in configuration.loci}
    names: dict[str, str] = {}
    for task in changed:
        after = {pin.name: pin.svar for pin in new[task].pins} if task in new else {}
        for pin in old[task].pins if task in old else ():
            svar = after.get(pin.name, pin.svar)
            if pin.svar not in used and svar not in stand and svar not in names.values():
                names.setdefault(pin.svar, svar)
    if not names:
        return configuration
    found = tuple(replace(one, svar=names.get(one.svar, one.svar)) for one in configuration.loci)
    return replace(configuration, loci=found)
