"""An act on an open application: who is asked to do it is handed the application; while it runs nobody is (D18)."""

from collections.abc import Callable
from functools import wraps
from typing import Protocol, TypeVar

from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_application import OpenApplication
from onika.model.syntax import Syntax
from onika.wire import act
from onika.wire.view import Remedy, ShowSaveAs


class _OfApplication(Protocol):
    @property
    def doc(self) -> str: ...


_A = TypeVar("_A", bound=_OfApplication)
_R = TypeVar("_R")
_Inner = Callable[[Model, OpenApplication, _A, Surroundings], _R]
_Handler = Callable[[Model, _A, Surroundings], _R | No]

_NO_SYNTAX = Syntax((), ())


def is_application(doc: str) -> bool:
    """Whether an id is one of an application."""
    return doc.startswith("a")


def closed() -> No:
    """The application is no longer open: somebody else has closed it."""
    return No("this application is no longer open")


def on_application(carry_out: _Inner[_A, _R]) -> _Handler[_A, _R]:
    """The handler of an act, made of a function that takes the act's application too."""

    @wraps(carry_out)
    def handler(model: Model, asked: _A, outside: Surroundings) -> _R | No:
        application = model.applications.get(asked.doc)
        return closed() if application is None else carry_out(model, application, asked, outside)

    return handler


def on_resting_application(carry_out: _Inner[_A, _R]) -> _Handler[_A, _R]:
    """The same for an act that changes it: refused while it runs."""

    @wraps(carry_out)
    def handler(model: Model, asked: _A, outside: Surroundings) -> _R | No:
        application = model.applications.get(asked.doc)
        if application is None:
            return closed()
        return running(application) if is_running(model, asked.doc) else carry_out(model, application, asked, outside)

    return handler


def is_running(model: Model, doc: str) -> bool:
    """Whether it is the application that runs now."""
    run = model.run
    return run is not None and run.doc == doc and not run.is_over


def running(application: OpenApplication) -> No:
    """Why nothing in it is changed now."""
    remedies = (Remedy("Abort the run", act.Steer("abort")), Remedy("Save a copy…", show=ShowSaveAs()))
    return No(f"{application.name} is running: nothing in it is changed until it has ended", remedies)


def syntax_of(model: Model) -> Syntax:
    """The types of icons; none where the definition could not be read."""
    return model.syntax or _NO_SYNTAX
