"""The dependents of a session: what is nobody's when it is gone, or silent for too long (requirement X12)."""

from collections.abc import Iterable, Mapping
from typing import Protocol, TypeVar


class BegunRun(Protocol):
    """A run, as far as it depends on a session."""

    @property
    def session(self) -> str:
        """Who began it."""
        ...

    @property
    def on_loss(self) -> str:
        """What becomes of it when that one is gone."""
        ...


_Run = TypeVar("_Run", bound=BegunRun)


def runs_of(session: str, runs: Iterable[_Run], *, is_silent: bool) -> list[_Run]:
    """The runs that a session leaves; silence alone takes from nobody a run that was begun to go on."""
    return [run for run in runs if run.session == session and not (is_silent and run.on_loss == "run")]


def subsystems_of(session: str, holders: Mapping[str, str]) -> list[str]:
    """The subsystems that come to rest: those that the session holds by hand."""
    return [name for name, holder in holders.items() if holder == session]
