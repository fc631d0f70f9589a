"""The company: who is there; those who attend to it are told whenever that changes (requirement X12)."""

from collections.abc import Callable, Set
from typing import Protocol

from msgspec import structs

from onika.wire import event, holding


class SessionSource(Protocol):
    """Where sessions come and go."""

    def sessions(self) -> tuple[holding.SessionStanding, ...]:
        """All that are known, here or not."""
        ...

    def tell(self, message: event.Event, subsystem: str = "", session: str = "") -> None:
        """Say an event to who attends."""
        ...


class Presence:
    """The sessions of a runtime, with what each of them has said of itself."""

    def __init__(
        self, session_source: SessionSource, watching: Callable[[], Set[str]], lease: Callable[[str], int] = lambda _: 0
    ) -> None:
        self._session_source = session_source
        self._lease = lease
        self._watching = watching
        self._told: tuple[holding.SessionStanding, ...] = ()

    def sessions(self) -> tuple[holding.SessionStanding, ...]:
        """Who is known."""
        watching = self._watching()
        sessions = self._session_source.sessions()
        return tuple(self._standing(standing, watching) for standing in sessions)

    def answer(self, session: str) -> holding.Company:
        """To whoever asks who is there."""
        return holding.Company(session, self.sessions())

    def look(self) -> None:
        """Tell who is there now, if that has changed."""
        sessions = self.sessions()
        if sessions != self._told:
            self._told = sessions
            self._session_source.tell(event.Company(sessions), holding.COMPANY)

    def _standing(self, standing: holding.SessionStanding, watching: Set[str]) -> holding.SessionStanding:
        return structs.replace(
            standing, only_watches=standing.name in watching, lease_s=self._lease(standing.name) * 1e-9
        )
