"""An open application, as a page shows it: flows of steps, joined by their edges."""

from typing import Literal

from msgspec import field

from onika.wire.view.dictionary import Role
from onika.wire.view.view import Remedy, View
from onika.words.reason import NOTHING, Reason


class StepView(View, frozen=True):
    """An icon, hole or branch in a flow, with its marks."""

    kind: Literal["icon", "hole", "branch"] = "icon"
    left: str = ""
    """The edges it shows, by their keys in `Tree.edges`; a hole those that it must satisfy."""
    right: str = ""
    name: str = ""
    type: str = ""
    role: Role = ""
    picture: str = ""
    """Its key in `Tree.pictures`."""
    description: str = ""
    words: dict[str, str] = field(default_factory=dict)
    """Descriptions in other languages, by their codes."""
    values: tuple[tuple[str, ...], ...] = ()
    is_joined: bool = False
    """Whether it belongs to the action before it: its target, or the hole for it."""
    wants: tuple[str, ...] = ()
    """Of a hole: the types of the targets that are missing there; none where an action is."""
    breaks: bool = False
    break_if: str = ""
    synch_tag: str = ""
    loop: str = ""
    is_test: bool = False
    loop_if: str = ""
    conditions: tuple[str, ...] = ()
    """Of a branch."""
    flows: tuple[str, ...] = ()
    """Of a branch: the paths of its flows."""
    note: Reason = NOTHING
    """What became of it when a runtime looked at it last, worth a mark: its target is re-resolved for another robot."""


class AppFlowView(View, frozen=True):
    """A flow: the numbers of its steps in order, without start and end."""

    steps: tuple[int, ...] = ()
    end: str = ""
    """The edge that its end icon wants."""
    start: str = ""
    """The edge of its start icon."""


class RedirectView(View, frozen=True):
    """A task that stands for another one in a flow, by its subsystem, or in all of them; or a world, with its colon."""

    old: str
    new: str
    flow: str = ""
    homes: tuple[str, ...] = ()
    """The flows that use it and are not nested, by their subsystems; they come a moment later than the wish."""


class FaultView(View, frozen=True):
    """Something that keeps an application from running, or is worth knowing; `step` is where, 0: nowhere in it."""

    text: Reason
    level: Literal["fault", "warning"] = "fault"
    step: int = 0
    remedies: tuple[Remedy, ...] = ()
    is_of_runtime: bool = False
    """Whether a runtime has found it, where it looked; `Run` looks again."""
    follows: tuple[Reason, ...] = ()
    """What is wrong for this reason only, and goes with it."""
    instant: int = 0
    """Of what is foreseen: the number under which `act.ForeseenInstant` shows it; 0: it is not foreseen."""


class ForecastView(View, frozen=True):
    """What an application would come to, in a workcell as at its start (E16)."""

    state: Literal["none", "going", "whole", "part"] = "none"
    """Whether it is foreseen: not, just now, to its end, or not so far."""
    lasts_s: float = 0.0
    cause: Reason = NOTHING
    """Why not to its end."""
    mishaps: int = 0
    """How much happens that it does not mean; that is told among its faults."""
    standing: tuple[Reason, ...] = ()
    """How everything stands at its end."""
    worlds: tuple[str, ...] = ()
    """In which worlds that is."""
    unwatched: tuple[str, ...] = ()
    """Those of them that do not say what happens in them that no program means."""


class ApplicationView(View, frozen=True):
    """An open application."""

    name: str
    order: int
    path: str = ""
    base: str = ""
    is_dirty: bool = False
    has_changed_on_disk: bool = False
    undo: Reason = NOTHING
    redo: Reason = NOTHING
    is_parallel: bool = False
    flows: dict[str, AppFlowView] = field(default_factory=dict)
    """By their paths; those of branches too."""
    steps: dict[str, StepView] = field(default_factory=dict)
    """By their numbers."""
    holes: int = 0
    faults: dict[str, FaultView] = field(default_factory=dict)
    is_judged: bool = False
    """Whether `faults` are those of what is here now; they come a moment later than a change."""
    is_checked: bool = False
    """Whether a runtime has looked at what is here now, with what it found among `faults`."""
    is_running: bool = False
    redirects: tuple[RedirectView, ...] = ()
    forecast: ForecastView = ForecastView()
    worlds: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """The worlds that its flows drive, by their subsystems, as it was judged last."""
    guests: dict[str, str] = field(default_factory=dict)
    """The guest of a flow: what carries out all its actions, by its subsystem, as it was judged last."""
    stations: dict[str, str] = field(default_factory=dict)
    """Where its flows are carried out, by subsystem; under the empty one, where all others are."""
    puzzle: str = ""
    """The puzzle by which its runs are judged; empty: none."""


class ApplicationFile(View, frozen=True):
    """An application that could be opened."""

    name: str
    base: str
    path: str
    flows: int = 0
    icons: int = 0
