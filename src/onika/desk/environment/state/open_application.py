"""An open application: its content, its past, the file it came from, and what is wrong with it."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from onika.desk.environment.state.history import History
from onika.model.application import Application
from onika.model.redirect import Redirect
from onika.store.opened_text import OpenedText
from onika.wire.view import FaultView


@dataclass(frozen=True, slots=True)
class Change:
    """One thing that was done to an application."""

    label: str
    by: str
    before: Application
    after: Application


@dataclass(frozen=True, slots=True)
class Judgement:
    """What is wrong with an application as it was when it was looked at."""

    of: Application
    faults: tuple[FaultView, ...] = ()
    has_new_files: bool = False
    """Whether files that it uses have changed since it was looked at before."""
    homes: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Of each task for which another one stands: the flows that use it."""


@dataclass(frozen=True, slots=True)
class Looked:
    """What a runtime has found wrong with an application, as it was when the runtime was asked (X02)."""

    of: Application
    redirects: tuple[Redirect, ...]
    at: str
    """The address of the runtime; empty: it is that of the environment."""
    faults: tuple[FaultView, ...] = ()


@dataclass(frozen=True, slots=True)
class OpenApplication:
    """An application whose steps have numbers."""

    id: str
    application: Application
    """Every step in it, those of branches too, has a number of its own."""
    last_number: int = 0
    """The greatest number that was ever given here: none is used again."""
    history: History[Change] = field(default_factory=History)
    opened: OpenedText[Application] | None = None
    """The file as it was read or saved last; None: it has none yet."""
    base: Path | None = None
    """The base directory of its file, or the one it is meant for."""
    has_changed_on_disk: bool = False
    file_faults: tuple[FaultView, ...] = ()
    """What was wrong with the file when it was read."""
    is_partial: bool = False
    """Whether some of the file could not be read: it is not run, nor overwritten without asking."""
    judgement: Judgement | None = None
    """The last one, which may be of an earlier content."""
    redirects: tuple[Redirect, ...] = ()
    """The tasks that stand for others as long as it is open."""
    marks: Mapping[int, str] = field(default_factory=dict)
    """What became of steps when a runtime looked at them last, by their numbers."""
    looked: Looked | None = None
    """The last look of a runtime, which may be of an earlier content."""

    @property
    def name(self) -> str:
        """What it is called."""
        return self.application.name

    @property
    def is_dirty(self) -> bool:
        """Whether it has changed since it was saved."""
        if self.opened is None:
            return any(flow.steps for flow in self.application.flows)
        return self.application != self.opened.value

    @property
    def is_judged(self) -> bool:
        """Whether what is known to be wrong is of what is here now."""
        return self.judgement is not None and self.judgement.of is self.application

    def looked_at(self, address: str) -> Looked | None:
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
