"""An open application: its content, its past, the file it came from, and what is wrong with it."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from onika.desk.environment.state.open_file import DocumentKind, OpenFile
from onika.model.application import Application
from onika.model.redirect import Redirect
from onika.wire.view import FaultView
from onika.words.reason import NOTHING, Reason

MOST_FLOWS = 32
"""Flows of an application, and of a branch: more are a slip of the hand."""


@dataclass(frozen=True, slots=True)
class Judgement:
    """What is wrong with an application as it was when it was looked at."""

    of: Application
    faults: tuple[FaultView, ...] = ()
    has_new_files: bool = False
    """Whether files that it uses have changed since it was looked at before."""
    homes: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Of each task for which another one stands: the flows that use it."""
    worlds: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """The worlds that each flow drives which is not nested, with what is nested in it, by its subsystem."""
    guests: Mapping[str, str] = field(default_factory=dict)
    """The guest of each flow that has one, by its subsystem."""


@dataclass(frozen=True, slots=True)
class PreflightResult:
    """What a runtime has found wrong with an application, as it was when the runtime was asked (X02)."""

    of: Application
    redirects: tuple[Redirect, ...]
    at: str
    """The address of the runtime; empty: it is that of the environment."""
    faults: tuple[FaultView, ...] = ()


@dataclass(frozen=True, slots=True)
class MishapAtStep:
    """What happens that the program does not mean, at which step of it (0: at none), and how a world stands then."""

    step: int
    text: Reason
    at_s: float
    world: str
    poses: bytes
    lit: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Foretelling:
    """What is foreseen of an application as it was when that began: under way or finished (E16).

    cause       why it is not foreseen to its end; nothing: it is, or is not yet
    standing    how everything stands at the end, in sentences
    watched     of each world whether it says what happens there that is not meant
    scenes      what the worlds consist of in which something happens
    """

    of: Application
    redirects: tuple[Redirect, ...]
    is_going: bool = True
    lasts_s: float = 0.0
    cause: Reason = NOTHING
    mishaps: tuple[MishapAtStep, ...] = ()
    standing: tuple[Reason, ...] = ()
    watched: Mapping[str, bool] = field(default_factory=dict)
    scenes: Mapping[str, dict[str, Any]] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class OpenApplication(OpenFile[Application, Application]):
    """An application whose steps have numbers."""

    kind = DocumentKind.APPLICATION
    application: Application
    """Every step in it, those of branches too, has a number of its own."""
    last_number: int = 0
    """The greatest number that was ever given here: none is used again."""
    file_faults: tuple[FaultView, ...] = ()
    """What was wrong with the file when it was read."""
    is_partial: bool = False
    """Whether some of the file could not be read: it is not run, nor overwritten without asking."""
    judgement: Judgement | None = None
    """The last one, which may be of an earlier content."""
    redirects: tuple[Redirect, ...] = ()
    """The tasks that stand for others as long as it is open."""
    stations: Mapping[str, str] = field(default_factory=dict)
    """Where its flows are carried out as long as it is open, by subsystem; the empty one stands for all others."""
    puzzle: str = ""
    """The puzzle by which its runs are judged as long as it is open; empty: none."""
    marks: Mapping[int, Reason] = field(default_factory=dict)
    """What became of steps when a runtime looked at them last, by their numbers."""
    looked: PreflightResult | None = None
    """The last look of a runtime, which may be of an earlier content."""
    foretelling: Foretelling | None = None
    """The last forecast, which may be of an earlier content."""

    @property
    def name(self) -> str:
        """What it is called."""
        return self.application.name

    @property
    def value(self) -> Application:
        """What its file would hold if it were saved now."""
        return self.application

    @property
    def is_dirty(self) -> bool:
        """Whether it has changed since it was saved."""
        if self.opened is None:
            return any(flow.steps for flow in self.application.flows)
        return self.application != self.opened.value

    def station_of(self, subsystem: str) -> str:
        """Where a flow is carried out; empty: at the first station."""
        return self.stations.get(subsystem, self.stations.get("", ""))

    @property
    def lone_station(self) -> str | None:
        """The station at which all its flows are carried out; None: they are at several."""
        stations = {self.station_of(f"flow{number}") for number in range(len(self.application.flows))}
        return next(iter(stations or {self.station_of("")})) if len(stations) < 2 else None

    @property
    def is_judged(self) -> bool:
        """Whether what is known to be wrong is of what is here now."""
        return self.judgement is not None and self.judgement.of is self.application

    @property
    def foretold(self) -> Foretelling | None:
        """What is foreseen of what is here now."""
        of = self.foretelling
        if of is None or of.of is not self.application or of.redirects != self.redirects:
            return None
        return of

    @property
    def is_foretold(self) -> bool:
        """Whether what is here now is foreseen, or just being so."""
        return self.foretold is not None

    def looked_at(self, address: str) -> PreflightResult | None:
        """What the runtime of that address has found in what is here now; None: it has not looked at it."""
        looked = self.looked
        if (
            looked is None
            or looked.of is not self.application
            or looked.redirects != self.redirects
            or looked.at != address
        ):
            return None
        return looked

    def having(self, application: Application) -> "OpenApplication":
        """With other content."""
        return replace(self, application=application)
