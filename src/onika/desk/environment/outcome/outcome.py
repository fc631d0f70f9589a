"""What comes of an act: a new model, or a no with its reasons; and what has to be asked of the outside."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from onika.desk.environment.state.model import Model
from onika.wire import page, request
from onika.wire.view import Remedy


@dataclass(frozen=True, slots=True)
class No:
    """A refusal: nothing is changed."""

    reason: str
    remedies: tuple[Remedy, ...] = ()
    fields: dict[str, str] = field(default_factory=dict)
    instead: "Done | None" = None
    """Of what a runtime refuses: the model without what was done already."""


@dataclass(frozen=True, slots=True)
class Simulator:
    """A runtime in virtual time, which passes as wall time does as soon as nothing is repeated in it."""

    rtpus: tuple[str, ...]
    options: tuple[str, ...] = ()
    """More words for the runtime program."""


@dataclass(frozen=True, slots=True)
class Reach:
    """A runtime to be there before it is asked: one elsewhere by its address; without one, that of this environment."""

    url: str = ""
    token: str = ""
    is_anew: bool = False
    """Whether one that was started here ends first."""
    simulator: Simulator | None = None
    """What is started in its place; None: what this environment starts else."""


@dataclass(frozen=True, slots=True)
class Order:
    """Something to ask a runtime; `then` makes of its response what comes of it."""

    asked: request.Request
    then: "Callable[[Model, request.Response], Done | No] | None" = None
    doc: str = ""
    reach: Reach | None = None
    """None: asked only where a runtime is there."""
    is_aside: bool = False
    """Whether no act waits for it."""
    is_kept: bool = False
    """Whether it is not asked by itself: what comes of another order is its response too (`Done.replies`)."""


@dataclass(frozen=True, slots=True)
class Done:
    """A new model; with a label it is a step of its document, which Undo takes back."""

    model: Model
    label: str = ""
    doc: str = ""
    value: Any = None
    orders: tuple[Order, ...] = ()
    is_answered_later: bool = False
    """Whether the act, or what it is waiting for, is answered by what comes of the first order."""
    says: tuple[page.Say, ...] = ()
    replies: tuple[tuple[Order, request.Response], ...] = ()
    """The responses to orders that were kept."""
