"""What an application does, step by step, and how its flows stand; times are seconds since the run's start."""

from msgspec import Struct

from onika.words.reason import NOTHING, Reason


class Began(Struct, frozen=True, tag=True):
    """An action begins; `index` counts from 0."""

    flow: int
    index: int
    of: int
    action: str
    at_s: float
    run: str = ""
    """The subsystem of the first flow of its run: several run side by side."""


class Done(Struct, frozen=True, tag=True):
    """An action has finished."""

    flow: int
    index: int
    at_s: float
    run: str = ""
    """As in `Began`."""


class Moved(Struct, frozen=True, tag=True):
    """A flow has come into another state (`engine.flow` has the words); where it waits, the tag and for whom."""

    subsystem: str
    state: str
    action: int
    """The current action, or the last one; -1 before the first."""
    at_s: float
    tag: str = ""
    waits_for: tuple[str, ...] = ()
    text: Reason = NOTHING
    """Why, where that is worth a word."""


class Met(Struct, frozen=True, tag=True):
    """Flows have begun together at a tag; `skew_us` lies between the first cycles of the first and the last of them."""

    tag: str
    subsystems: tuple[str, ...]
    skew_us: float
    at_s: float


class Stood(Struct, frozen=True, tag=True):
    """The clock of a held run stands, and everything that was asked is carried out; `steer.Onward` lets it go on."""

    at_s: float
