"""What others have changed on the disk is taken over where that loses nothing, and told where it would (C01, X10)."""

from collections.abc import Iterable, Set
from dataclasses import replace
from pathlib import Path

from onika.desk.environment import libraries, listing
from onika.desk.environment.content import Content
from onika.desk.environment.document import Document
from onika.desk.environment.history import Step
from onika.desk.environment.libraries import told
from onika.desk.environment.model import Model
from onika.desk.environment.outcome import Done
from onika.desk.environment.remedy import plain
from onika.files import conf, text
from onika.model.configuration import Configuration
from onika.store.base_directory import BaseDirectory
from onika.store.opened import Faults, Opened, open_file
from onika.wire import page

_LABEL = "reading the file again"


def refreshed(model: Model, changed: Set[Path]) -> Done:
    """With the libraries, the list of configurations and the open documents as the files are now.

    The same model where the files say what was known: what was saved here is nothing new.
    """
    done = libraries.reread(model, changed)
    model, says = done.model, [*done.says]
    configurations = sorted(path for path in changed if listing.is_configuration(path))
    model, faults = _listed(model, configurations)
    for document in model.documents.values():
        if document.opened is not None and document.opened.path in changed:
            now, said, wrong = _document(document, document.opened)
            says += said
            faults = tuple(one for one in faults if one not in wrong)
            model = model if now is document else model.with_document(now)
    return Done(model, orders=done.orders, says=(*says, *told(faults)))


def _listed(model: Model, paths: Iterable[Path]) -> tuple[Model, Faults]:
    """With these configurations in the list as they are now."""
    files, faults = dict(model.files), list[Faults]()
    for path in paths:
        if not path.is_file():
            files.pop(str(path), None)
            continue
        base = BaseDirectory(path.parent.parent)
        if path.stem in base.configurations:
            files[str(path)], wrong = listing.entry(base, path.stem)
            faults.append(wrong)
    same = files == model.files
    return (model if same else replace(model, files=files)), tuple(one for some in faults for one in some)


def _document(document: Document, opened: Opened[Configuration]) -> tuple[Document, list[page.Say], Faults]:
    """An open document whose file was written; what is not saved here, or lives, is never touched."""
    if not opened.path.is_file():
        text_ = f"{opened.path} was removed; {document.name} is still here and can be saved again"
        return _differs(document), [page.Say("warning", text_, document.id)], ()
    if text.load(opened.path, str(opened.path))[0] == opened.text:
        return _as_it_was(document), [], ()
    found, faults = open_file(opened.path, opened.path.stem, conf.read)
    if found is None:
        reasons = "; ".join(plain(str(one)) for one in faults)
        said = f"{document.name} was changed by somebody else and is at fault now: {reasons}"
        return _differs(document), [page.Say("warning", said, document.id)], faults
    if document.is_dirty or document.is_moved or document.live is not None:
        said = f"{document.name} was changed on the disk by somebody else; what is here stays until you read it again"
        return _differs(document), [page.Say("warning", said, document.id)], ()
    content = Content(found.value)
    history = document.history.done(Step(_LABEL, "", document.content, content))
    now = replace(document, content=content, opened=found, history=history, has_changed_on_disk=False)
    said = f"{document.name} was changed on the disk by somebody else and is read again"
    return now, [page.Say("info", said, document.id)], ()


def _differs(document: Document) -> Document:
    return document if document.has_changed_on_disk else replace(document, has_changed_on_disk=True)


def _as_it_was(document: Document) -> Document:
    return replace(document, has_changed_on_disk=False) if document.has_changed_on_disk else document
