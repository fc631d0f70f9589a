"""What is known of a document in the running system: facts, which are never taken back (law 22)."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Literal

from onika.desk.environment.state.content import Content
from onika.desk.environment.state.history import Edits, History
from onika.model.configuration import Configuration
from onika.wire import event
from onika.wire.plan import PlannedTask
from onika.words.reason import NOTHING, Reason


@dataclass(frozen=True, slots=True)
class TaskFacts:
    """A living task, or one that is about to live."""

    state: str
    note: Reason = NOTHING
    rtpu: str = ""
    hz: float | None = None
    question: event.Asked | None = None
    present: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    """Of what it asks for: the values that it measures, by the names of the inputs."""
    failed: event.Failed | None = None
    warnings: int = 0
    planned: PlannedTask | None = None
    """As what it was brought to life, as far as the runtime has told."""

    @property
    def is_moving(self) -> bool:
        """Whether it is ON, or would be if somebody answered it."""
        return self.state in ("ON", "ASKING")


@dataclass(frozen=True, slots=True)
class RequestedState:
    """What the runtime was asked for up to now: what a document differs in from it is still to be asked."""

    content: Content
    history: History[Content] = field(default_factory=History)
    edits: Edits = field(default_factory=dict)
    """Tasks of the libraries that have changed since, as they were."""


@dataclass(frozen=True, slots=True)
class Pending:
    """Something that the runtime was asked for and whose outcome is not known."""

    before: RequestedState | None = None
    """Of a change of the subsystem: what to go back to where it fails."""
    after: Content | None = None
    present: History[Content] = field(default_factory=History)
    """The history with the steps that it carries out."""
    tasks: frozenset[str] = frozenset()
    """Which tasks it touches."""
    number: int | None = None
    """By which its outcome is told; None: it was not accepted yet."""
    turns: Mapping[str, str] = field(default_factory=dict)
    """The tasks that it turns ON whatever they were, each with its argument line."""


@dataclass(frozen=True, slots=True)
class TightChange:
    """A change that was taken back because tasks found no gap between the cycles of their unit."""

    before: Content
    after: Content
    rest: Configuration
    """What is on the canvas without it."""
    tasks: tuple[str, ...]
    """Those tasks."""
    turns: Mapping[str, str] = field(default_factory=dict)
    """As the change had them."""


@dataclass(frozen=True, slots=True)
class Offer:
    """Who would hand a subsystem over, to whom, and whether that is this environment."""

    holder: str
    to: str
    is_here: bool


@dataclass(frozen=True, slots=True)
class WatchedRun:
    """A subsystem that an application has, or had, and that a document looks into without changing anything."""

    subsystem: str
    application: str
    station: str = ""


@dataclass(frozen=True, slots=True)
class TakenOver:
    """What a run has taken over of a document, to be put back when it is over (requirement C18)."""

    run: int
    """Which run of this environment it is."""
    application: str
    subsystem: str
    on: frozenset[str] = frozenset()
    """The tasks that come ON again then."""
    is_asked: bool = False
    """Whether the runtime is being asked for it."""


@dataclass(frozen=True, slots=True)
class SubsystemFacts:
    """A document's subsystem."""

    subsystem: str
    state: Literal["connecting", "live", "lost"] = "connecting"
    tasks: Mapping[str, TaskFacts] = field(default_factory=dict)
    """Those that live or are about to, by name."""
    holder: str = ""
    offer: "Offer | None" = None
    """What its holder would hand over."""
    black_box: str = ""
    """The file in which the last seconds stand before something went wrong here last."""
    recording: str = ""
    """The file on the runtime's machine into which it is being recorded; empty: it is not."""
    me: str = ""
    """The name by which the runtime knows this environment; empty: it was not told yet."""
    base: RequestedState | None = None
    """None: it is not live."""
    turns: Mapping[str, str] = field(default_factory=dict)
    """Tasks to turn ON with the next change, whatever they were, each with its argument line."""
    pending: Mapping[int, Pending] = field(default_factory=dict)
    """By their own count, oldest first."""
    early: Mapping[int, Reason] = field(default_factory=dict)
    """Outcomes of changes, by number, that were told before the changes were accepted."""
    changes: int = 0
    """How many changes of the subsystem were ever asked for; acts wait for one of them by this number."""
    is_awaited: bool = False
    """Whether acts wait for the next change, with which goes out what they did while one was under way."""
    requests: int = 0
    """How many things were ever asked for."""
    tight: TightChange | None = None
    """The last change that found no gap between cycles, for which there are other ways."""
    holds: bool = False
    """Whether the next change may turn everything OFF for a moment."""

    @property
    def is_changing(self) -> bool:
        """Whether a change of the subsystem is under way: the next one waits for it."""
        return any(change.before is not None for change in self.pending.values())

    @property
    def is_held_here(self) -> bool:
        """Whether this environment may change it."""
        return bool(self.me) and self.holder == self.me

    @property
    def is_foreign(self) -> bool:
        """Whether somebody else may change it and this environment may not."""
        return bool(self.holder) and self.holder != self.me

    def state_of(self, name: str) -> str:
        """A task's state; empty where it does not live."""
        facts = self.tasks.get(name)
        return facts.state if facts else ""

    def with_task(self, name: str, facts: TaskFacts | None) -> "SubsystemFacts":
        """With what is known of a task now; None: it is gone."""
        tasks = {other: former for other, former in self.tasks.items() if other != name}
        return replace(self, tasks=tasks if facts is None else {**self.tasks, name: facts})

    def without_pending(self, key: int) -> "SubsystemFacts":
        """With one change less whose outcome is not known."""
        return replace(self, pending={number: change for number, change in self.pending.items() if number != key})
