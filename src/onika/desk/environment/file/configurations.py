"""Acts on documents: new, open, save, close, reload (requirements C06, C21)."""

from dataclasses import replace
from pathlib import Path

from onika.desk.environment.canvas.placement import changed
from onika.desk.environment.outcome.on_document import closed, on_document
from onika.desk.environment.outcome.outcome import Done, No, Order
from onika.desk.environment.outcome.remedy import overwriting, plain, unreadable
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.files import text
from onika.model.configuration import Configuration
from onika.store.base_directory import BaseDirectory
from onika.store.opened_text import OpenedText
from onika.store.site import is_shipped
from onika.wire import act, live
from onika.wire.view import Remedy, ShowSaveAs
from onika.words.fault import Refusal
from onika.words.name import TASK_NAME


def new(model: Model, _asked: act.New, _outside: Surroundings) -> Done | No:
    """Open a blank configuration."""
    return opened_beside(model, None, None, model.blank())


def open_file(model: Model, asked: act.Open, outside: Surroundings) -> Done | No:
    """Open a configuration beside the others; one that is open already is shown."""
    found = read(asked.path, outside)
    if isinstance(found, No):
        return found
    base, opened = found
    for document in model.documents.values():
        if document.opened and document.opened.path == opened.path:
            return Done(model, value=document.id)
    done = opened_beside(model, base, opened, opened.value)
    blank = [one for one in model.documents.values() if _is_untouched(one)]
    if len(model.documents) == 1 and blank:
        done = replace(done, model=done.model.without(blank[0].id))  # as everywhere: it makes room
    return done


@on_document
def save(model: Model, document: Document, asked: act.Save, outside: Surroundings) -> Done | No:
    """Save a document."""
    name = asked.name or document.name
    if not TASK_NAME.match(name):
        form = "a name of letters, digits and _ . - that begins with a letter"
        return No(f"{name!r} is no name for a file", fields={"name": f"expected {form}"})
    base = Path(asked.base) if asked.base else document.base
    own = outside.site.own
    if base is None and asked.name:
        base = own
    if base is None:
        return No("it has no file yet: give it a name and a base directory", (Remedy("Save as…", show=ShowSaveAs()),))
    if is_shipped(base) and not asked.overwrites:
        return _shipped(asked, name, own)
    configuration = replace(document.content.configuration, name=name)
    former = document.opened
    done = BaseDirectory(base).save_configuration(configuration, former, overwrites=asked.overwrites)
    if isinstance(done, Refusal):
        again = act.Save(asked.doc, asked.name, asked.base, overwrites=True)
        remedies = (*overwriting(done, again), Remedy("Save as…", show=ShowSaveAs()))
        return No(plain(done.reason), remedies)
    content = replace(document.content, configuration=configuration)
    saved = replace(document, content=content, opened=done, base=base, has_changed_on_disk=False)
    return Done(model.with_document(saved), value=str(done.path))


def _shipped(asked: act.Save, name: str, own: Path | None) -> No:
    """What comes with Onika is not changed by the way."""
    here = () if own is None else (Remedy(f"Save a copy in {own}", act.Save(asked.doc, name, str(own))),)
    meant = Remedy("Change the shipped one", act.Save(asked.doc, asked.name, asked.base, overwrites=True))
    return No(f"{name} would be part of Onika itself there", (*here, Remedy("Save as…", show=ShowSaveAs()), meant))


@on_document
def close(model: Model, document: Document, asked: act.Close, _outside: Surroundings) -> Done | No:
    """Close a document; one is always open."""
    if (document.is_dirty or document.is_moved) and not asked.discards:
        remedies = (Remedy("Save it first", act.Save(asked.doc)), Remedy("Discard it", act.Close(asked.doc, True)))
        return No(f"{document.name} is not saved", remedies)
    known = document.live if document.live and document.live.state == "live" else None
    moving = [task for task, facts in known.tasks.items() if facts.is_moving] if known else []
    if moving and asked.alive == "ask":
        return _asked_about(asked, document, moving)
    left = model.without(document.id)
    done = Done(left) if left.documents else opened_beside(left, None, None, left.blank())
    if known is None or not known.tasks or asked.alive == "leave":
        return done
    return replace(done, orders=(Order(live.Close(known.subsystem)),))


def _asked_about(asked: act.Close, document: Document, moving: list[str]) -> No:
    """Nobody would see any more what goes on moving."""
    names = " and ".join(moving) if len(moving) < 3 else f"{len(moving)} tasks"
    remedies = (
        Remedy("End all its tasks and close", act.Close(asked.doc, asked.discards, "end")),
        Remedy("Let them run and close", act.Close(asked.doc, asked.discards, "leave")),
    )
    return No(f"{names} of {document.name} {'is' if len(moving) == 1 else 'are'} ON", remedies)


def reload(model: Model, asked: act.Reload, outside: Surroundings) -> Done | No:
    """Take over what stands in the file now, as a step that can be taken back."""
    document = model.documents.get(asked.doc)
    if document is None or document.opened is None:
        return closed()
    found = read(str(document.opened.path), outside)
    if isinstance(found, No):
        return found
    _, opened = found
    here = replace(document, opened=opened, has_changed_on_disk=False)
    return changed(model, here, opened.value, "reading the file again")


@on_document
def keep(model: Model, document: Document, asked: act.Keep, _outside: Surroundings) -> Done | No:
    """Go on with what is here; the next Save finds the file as it was seen now, and overwrites it."""
    opened = document.opened
    content = text.load(opened.path, str(opened.path))[0] if opened else None
    if opened is not None and content is not None:
        opened = replace(opened, text=content)
    return Done(model.with_document(replace(document, opened=opened, has_changed_on_disk=False)))


def read(path_or_name: str, outside: Surroundings) -> tuple[BaseDirectory, OpenedText[Configuration]] | No:
    """A configuration by the path of its file, or by its name on the search path."""
    path = Path(path_or_name)
    if path.suffix == ".conf":
        if not path.is_file():
            return No(f"there is no file {path}")
        if path.absolute().parent.name != "conf":
            return No(f"{path} stands in no folder conf/ of a base directory: what it names could not be found")
        base, name = BaseDirectory(path.absolute().parent.parent), path.stem
    else:
        name = path_or_name
        bases = [one for one in outside.site.directories if name in one.configurations]
        if not bases:
            return No(f"no base directory on the search path has a configuration {name}")
        base = bases[0]
    opened, faults = base.open_configuration(name)
    if opened is None:
        return No(unreadable(path_or_name, faults))
    return base, opened


def opened_beside(
    model: Model, base: BaseDirectory | None, opened: OpenedText[Configuration] | None, configuration: Configuration
) -> Done:
    """With one more document, whose id is the value."""
    number = model.opened + 1
    document = Document(f"c{number}", Content(configuration), opened=opened, base=base.path if base else None)
    return Done(replace(model.with_document(document), opened=number), value=document.id)


def _is_untouched(document: Document) -> bool:
    return document.opened is None and not document.content.configuration.placed and document.live is None
