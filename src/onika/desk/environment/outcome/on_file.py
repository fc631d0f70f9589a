"""Decorators of acts on open files: each passes the file to the act's handler, or refuses the act (requirement D18)."""

from collections.abc import Callable
from functools import wraps
from typing import Protocol, TypeVar

from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.desk.environment.state.open_file import DocumentKind
from onika.model.syntax import Syntax
from onika.wire import act
from onika.wire.view import Remedy, ShowSaveAs
from onika.words.reason import Reason


class _OfFile(Protocol):
    @property
    def doc(self) -> str: ...


_A = TypeVar("_A", bound=_OfFile)
_F = TypeVar("_F")
_R = TypeVar("_R")
_Inner = Callable[[Model, _F, _A, Services], _R]
_Handler = Callable[[Model, _A, Services], _R | No]
AnyFile = Document | OpenApplication

_NO_SYNTAX = Syntax((), ())


def closed(kind: DocumentKind) -> No:
    """The file is no longer open: somebody else has closed it."""
    is_application = kind is DocumentKind.APPLICATION
    return No(Reason.of("run.application_closed") if is_application else Reason.of("run.configuration_closed"))


def on_file(carry_out: _Inner[AnyFile, _A, _R]) -> _Handler[_A, _R]:
    """The handler of an act, made of a function that takes the act's open file too."""

    @wraps(carry_out)
    def handler(model: Model, command: _A, outside: Services) -> _R | No:
        file = model.file(command.doc)
        if file is None:
            return closed(DocumentKind.of(command.doc))
        return carry_out(model, file, command, outside)

    return handler


def on_document(carry_out: _Inner[Document, _A, _R]) -> _Handler[_A, _R]:
    """The same for an act on a configuration."""

    @wraps(carry_out)
    def handler(model: Model, command: _A, outside: Services) -> _R | No:
        document = model.documents.get(command.doc)
        if document is None:
            return closed(DocumentKind.CONFIGURATION)
        return carry_out(model, document, command, outside)

    return handler


def on_application(carry_out: _Inner[OpenApplication, _A, _R]) -> _Handler[_A, _R]:
    """The same for an act on an application."""

    @wraps(carry_out)
    def handler(model: Model, command: _A, outside: Services) -> _R | No:
        application = model.applications.get(command.doc)
        if application is None:
            return closed(DocumentKind.APPLICATION)
        return carry_out(model, application, command, outside)

    return handler


def on_resting_application(carry_out: _Inner[OpenApplication, _A, _R]) -> _Handler[_A, _R]:
    """The same for an act that changes an application: refused while it runs."""

    @wraps(carry_out)
    def unless_it_runs(model: Model, application: OpenApplication, command: _A, outside: Services) -> _R | No:
        return busy(model, application) or carry_out(model, application, command, outside)

    return on_application(unless_it_runs)


def busy(model: Model, file: AnyFile) -> No | None:
    """Why nothing in an open file is changed now."""
    if is_running(model, file.id):
        return running(file)
    return None


def is_running(model: Model, doc: str) -> bool:
    """Whether it is an application that runs now."""
    return any(run.doc == doc for run in model.going)


def running(file: AnyFile) -> No:
    """Nothing is changed in what runs."""
    abort = Remedy(Reason.of("run.abort_run"), act.Steer("abort", file.id))
    copy = Remedy(Reason.of("run.save_copy"), show=ShowSaveAs())
    return No(Reason.of("run.unchanged_while_running", name=file.name), (abort, copy))


def syntax_of(model: Model) -> Syntax:
    """The types of icons; none where the definition could not be read."""
    return model.syntax or _NO_SYNTAX
