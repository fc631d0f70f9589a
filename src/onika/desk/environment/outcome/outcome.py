"""What comes of an act: a new model, or a no with its reasons; and what is asked of the outside for it.

An act that waits is a generator. It yields what it waits for (`Ask`, `Work`, `AwaitedNews`), each with the model as it
is to be meanwhile; it receives the model of then together with what has come; and it returns `Done` or `No`
(decision 35).
"""

from collections.abc import Callable, Generator, Hashable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Protocol, TypeVar

from onika.desk.environment.state.model import Model
from onika.desk.environment.state.restoration import OwnStep
from onika.wire import page
from onika.wire.request import Request, Response
from onika.wire.view import Remedy
from onika.words.reason import NOTHING, Reason

_T = TypeVar("_T")

News = tuple[Hashable, Any]
"""Something that acts may wait for has come, with what there is to say of it."""


@dataclass(frozen=True, slots=True)
class No:
    """A refusal: nothing is changed."""

    reason: Reason
    remedies: tuple[Remedy, ...] = ()
    fields: Mapping[str, Reason] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Simulator:
    """A runtime in virtual time, which passes as wall time does as soon as nothing is repeated in it."""

    rtpus: tuple[str, ...]
    options: tuple[str, ...] = ()
    """More words for the runtime program."""


@dataclass(frozen=True, slots=True)
class RequiredRuntime:
    """A runtime to be there before it is asked: one elsewhere by its address; without one, that of this environment."""

    url: str = ""
    token: str = ""
    is_anew: bool = False
    """Whether one that was started here ends first."""
    simulator: Simulator | None = None
    """What is started in its place; None: what this environment starts else."""


@dataclass(frozen=True, slots=True, eq=False)
class Order:
    """Something to ask a runtime; `then` makes of its response what comes of it. Each is itself alone."""

    asked: Request
    then: "Callable[[Model, Response], Done] | None" = None
    reach: RequiredRuntime | None = None
    """None: asked only where a runtime is there."""
    station: str | None = None
    """Whose runtime is asked; None: that of the station in focus."""
    identity: object = field(default_factory=object, repr=False)
    """By what its response is known, also where another order that says more is sent in its place."""

    def at(self, station: str) -> "Order":
        """The order to this station, where it names none."""
        return self if self.station is not None else replace(self, station=station)


@dataclass(frozen=True, slots=True)
class SubsystemChange:
    """The change of a document's subsystem of this number: its news is None when it is accepted, else a `No`."""

    doc: str
    number: int


@dataclass(frozen=True, slots=True)
class EditEnd:
    """The end of an accepted live edit, by the runtime's number: its news is None when it is done, else a `No`."""

    number: int
    station: str = ""


@dataclass(frozen=True, slots=True)
class RunEnd:
    """The end of a run of an application, by the number that it has here: there is nothing else to say of it."""

    number: int


@dataclass(frozen=True, slots=True)
class Done:
    """A new model; with a label it is a step of its document, which Undo takes back."""

    model: Model
    label: Reason = NOTHING
    doc: str = ""
    value: Any = None
    orders: tuple[Order, ...] = ()
    """What a runtime is asked beside; no act waits for it."""
    says: tuple[page.Say, ...] = ()
    news: tuple[News, ...] = ()
    """What has come that acts may wait for."""
    own: OwnStep | None = None
    """A step that belongs to no open file."""
    awaits: SubsystemChange | None = None
    """The change of a running system that this leads to: the act is answered when it is accepted."""


# What an act yields


@dataclass(frozen=True, slots=True, eq=False)
class InterimModel:
    """What an act has done so far; yielded as it is, the act goes on at once with the model of then."""

    model: Model
    says: tuple[page.Say, ...] = field(default=(), kw_only=True)
    orders: tuple[Order, ...] = field(default=(), kw_only=True)
    news: tuple[News, ...] = field(default=(), kw_only=True)


@dataclass(frozen=True, slots=True, eq=False)
class Ask(InterimModel):
    """A request to a runtime: the act goes on with its response."""

    request: Request
    reach: RequiredRuntime | None = None
    """None: asked only where a runtime is there."""


@dataclass(frozen=True, slots=True, eq=False)
class AskAll(InterimModel):
    """Requests to runtimes of several stations at one time: the act goes on with all responses, in the same order."""

    requests: tuple[tuple[str, Request], ...]
    """Each with its station."""


class Worker(Protocol):
    """A thread that works aside."""

    def answer(self, work: Callable[[], Any], what: Hashable) -> None:
        """Have something done; its result is the news of `what`."""
        ...


@dataclass(frozen=True, slots=True, eq=False)
class Work(InterimModel):
    """Something that takes long: it is done in a thread of its own, and the act goes on with its result."""

    worker: Worker
    work: Callable[[], Any]


@dataclass(frozen=True, slots=True, eq=False)
class AwaitedNews(InterimModel):
    """Something that comes by itself: the act goes on with its news."""

    what: Hashable


Steps = Generator[InterimModel, tuple[Model, Any], _T]
"""Part of an act that waits."""

Procedure = Steps[Done | No]
"""An act that waits."""
