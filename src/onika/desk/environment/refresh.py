"""What others have changed on the disk is taken over where that loses nothing, and told where it would (C01, X10)."""

from collections.abc import Iterable, Set
from dataclasses import replace
from pathlib import Path

from onika.desk.environment.canvas import libraries
from onika.desk.environment.file import application_on_disk, file_index
from onika.desk.environment.icons import dictionaries, syntax as defining
from onika.desk.environment.outcome.file_faults import told
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.outcome.remedy import plain
from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.history import Step
from onika.desk.environment.state.model import Model
from onika.files import conf, syntax, text
from onika.model.configuration import Configuration
from onika.store.opened_text import Faults, OpenedText, open_file
from onika.store.site import Site
from onika.wire import page

_LABEL = "reading the file again"


def refreshed(model: Model, changed: Set[Path], site: Site | None = None) -> Done:
    """With libraries, dictionaries, lists and open documents as the files are now; `site` is where the syntax is found.

    The same model where the files say what was known: what was saved here is nothing new.
    """
    done = libraries.reread(model, changed)
    model, says = done.model, [*done.says]
    model, faults = _listed(model, sorted(changed))
    icons = dictionaries.reread(model, changed)
    model, says = icons.model, [*says, *icons.says]
    if site is not None and any(syntax.NAME in path.name for path in changed):
        defined = defining.redefined(model, site)
        model, says = defined.model, [*says, *defined.says]
    opened = application_on_disk.refreshed(model, changed)
    model, says = opened.model, [*says, *opened.says]
    for document in model.documents.values():
        if document.opened is not None and document.opened.path in changed:
            now, said, wrong = _document(document, document.opened)
            says += said
            faults = tuple(one for one in faults if one not in wrong)
            model = model if now is document else model.with_document(now)
    return Done(model, orders=done.orders, says=(*says, *told(faults)))


def _listed(model: Model, paths: Iterable[Path]) -> tuple[Model, Faults]:
    """With these configurations and applications in their lists as they are now."""
    found, gone = file_index.Listed(), list[str]()
    for path in paths:
        if not (file_index.is_configuration(path) or file_index.is_application(path)):
            continue
        again = file_index.again(path, model.syntax)
        if again is None:
            gone.append(str(path))
        else:
            found = found.and_(again)
    return found.beside(file_index.without(model, gone)), found.faults


def _document(document: Document, opened: OpenedText[Configuration]) -> tuple[Document, list[page.Say], Faults]:
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
