"""Runtimes of a site that are none: what they answer is said by a test."""

import contextlib
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from onika.link.lost import LinkLost, LossCause
from onika.wire import holding, live, request
from onika.wire.runtime_standing import Standing, SubsystemStanding
from onika.words.reason import Reason


class QuietRuntime:
    """Answers what a site asks of a runtime; nothing of it is a process."""

    def __init__(self) -> None:
        self.sessions: tuple[holding.SessionStanding, ...] = ()
        self.subsystems: tuple[SubsystemStanding, ...] = ()
        self.lost: LinkLost | None = None
        self.answers: dict[type, request.Response] = {}
        self.is_open = False
        self._looks = 0
        self._looked = threading.Condition()

    @contextlib.contextmanager
    def opened(self) -> Iterator[Any]:
        if self.lost is not None:
            raise self.lost
        self.is_open = True
        yield self
        self.is_open = False

    def looked_at(self, times: int = 2, within_s: float = 10.0) -> None:
        """Wait until the site has looked at it so often from now on: after two it goes by what is so now."""
        with self._looked:
            until = self._looks + times
            assert self._looked.wait_for(lambda: self._looks >= until, within_s)

    def ask(self, message: request.Request) -> request.Response:
        if isinstance(message, live.Survey):
            with self._looked:
                self._looks += 1
                self._looked.notify_all()
        if type(message) in self.answers:
            return self.answers[type(message)]
        match message:
            case live.Survey():
                return Standing(self.subsystems, (), (), True, False, 0.0, ("ws://127.0.0.1:4711",))
            case holding.Sessions():
                return holding.Company("owner#1", (holding.SessionStanding("owner#1", "owner"), *self.sessions))
        raise AssertionError(message)

    def come(self, *names: str) -> None:
        self.sessions = tuple(holding.SessionStanding(name, "operator") for name in names)

    def hold(self, subsystem: str, holder: str, application: str = "") -> None:
        self.subsystems = (*self.subsystems, SubsystemStanding(subsystem, holder, application, ()))

    def fail(self, cause: LossCause, reason: Reason) -> None:
        self.lost = LinkLost(cause, reason)

    def readers(self) -> list[int]:
        return []

    def writers(self) -> list[int]:
        return []

    def due_s(self) -> float | None:
        return None

    def events(self, _timeout_s: float) -> Iterator[Any]:
        return iter(())


def descriptors() -> int:
    """How many descriptors this process has."""
    return len(list(Path("/proc/self/fd").iterdir()))
