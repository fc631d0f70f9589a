"""An act on an open document: who is asked to do it is handed the document, and never asked where there is none."""

from collections.abc import Callable
from functools import wraps
from typing import Protocol, TypeVar

from onika.desk.environment.outcome.outcome import No
from onika.desk.environment.outcome.services import Surroundings
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.model import Model


class _OfDocument(Protocol):
    @property
    def doc(self) -> str: ...


_A = TypeVar("_A", bound=_OfDocument)
_R = TypeVar("_R")


def closed() -> No:
    """The document is no longer open: somebody else has closed it."""
    return No("this configuration is no longer open")


def on_document(
    carry_out: Callable[[Model, Document, _A, Surroundings], _R],
) -> Callable[[Model, _A, Surroundings], _R | No]:
    """The handler of an act, made of a function that takes the act's document too."""

    @wraps(carry_out)
    def handler(model: Model, asked: _A, outside: Surroundings) -> _R | No:
        document = model.documents.get(asked.doc)
        return closed() if document is None else carry_out(model, document, asked, outside)

    return handler
