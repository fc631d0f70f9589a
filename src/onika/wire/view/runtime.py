"""The runtime, as a page shows it."""

from typing import Literal

from msgspec import field

from onika.wire.view.asking import AskView
from onika.wire.view.booking import BookView, SlotEndView
from onika.wire.view.subsystem import SubsystemView
from onika.wire.view.view import View
from onika.words.reason import NOTHING, Reason


class UnitView(View, frozen=True):
    """A processing unit."""

    load: float = 0.0
    is_lost: bool = False


class SessionView(View, frozen=True):
    """Somebody who is connected with the runtime; a user may be there several times."""

    role: str
    is_here: bool = True
    """Whether it is heard at present."""
    only_watches: bool = False
    is_you: bool = False
    lease_s: float = 0.0
    """For how long it may be silent before it holds nothing any more; 0: for ever."""


class HoldView(View, frozen=True):
    """Who may change a subsystem that lives (law 27, X12)."""

    holder: str = ""
    """A session, by its name; empty: nobody."""
    application: str = ""
    """What runs in it; empty: its tasks are held by hand."""
    state: str = ""
    """Of a flow of an application, a word of `engine.flow.FlowState`; empty: it was not told."""
    since_at_s: float = 0.0
    """Seconds since 1970 when it was told here that this one holds it, or that nobody does; 0: it was so before."""
    cause: Reason = NOTHING
    """Why the holder changed last, where that is worth a word."""
    former: str = ""
    """Who held it before and is gone or was silent for too long; empty: nobody, or it was released."""
    was_here: bool = False
    """Whether that was this environment."""
    offered_to: str = ""
    """The session that may take it or decline."""
    offered_until_s: float = 0.0
    """Seconds since 1970 when the offer ends; 0: that is not known."""
    asks: dict[str, AskView] = field(default_factory=dict)
    """What tasks of an application wait to be told, by name; its holder tells them."""
    on_loss: str = ""
    """Of an application: what becomes of it where its holder is lost; `stop`, `finish` or `run`."""


class RuntimeView(View, frozen=True):
    """The runtime of a station."""

    state: Literal["none", "starting", "linked", "lost"] = "none"
    address: str = ""
    text: Reason = NOTHING
    """Why it is lost."""
    is_virtual: bool = False
    is_stopped: bool = False
    stop_text: Reason = NOTHING
    units: dict[str, UnitView] = field(default_factory=dict)
    worlds: dict[str, bool] = field(default_factory=dict)
    """Those that are open."""
    outdated: dict[str, Reason] = field(default_factory=dict)
    """Those whose files were changed since they were opened, and which file it is."""
    subsystems: dict[str, str] = field(default_factory=dict)
    """Names of those that live, with what holds them."""
    holds: dict[str, HoldView] = field(default_factory=dict)
    """Who may change which of them."""
    sessions: dict[str, SessionView] = field(default_factory=dict)
    """Who is there, by name."""
    inside: dict[str, SubsystemView] = field(default_factory=dict)
    """What lives in those in which an application runs."""
    world_kinds: dict[str, Literal["simulated", "real"]] = field(default_factory=dict)
    """What is known of worlds, open or not; in a simulated one nothing outside the program moves."""
    displaced: dict[str, tuple[Reason, ...]] = field(default_factory=dict)
    """What does not stand where a program needs it, by world; told while no application runs."""
    moved: dict[str, tuple[Reason, ...]] = field(default_factory=dict)
    """What stands elsewhere than at their start and does no harm there, as an arm does."""
    pressed: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """By world the parts that a hand holds pressed, such as a panic button, as far as that is known here."""
    is_cut: bool = False
    """Whether nothing is heard of it at present, although it is not given up yet."""
    round_trip_ms: float = -1.0
    """How long the way there and back takes; -1: it was not measured."""
    book: BookView | None = None
    """For whom its robot is booked; None: it was not asked, or keeps no bookings."""
    libraries: tuple[str, ...] = ()
    """The addresses of libraries that it supplies to whoever is connected."""
    slot_ends: SlotEndView | None = None
    """Whose time ends, as it was announced."""
    clock_set_s: float = 0.0
    """By how much the clock of its machine was set last, since this environment came; 0: it was not."""
