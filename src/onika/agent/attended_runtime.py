"""A runtime that a site has launched, in a thread of its own, which looks after it as long as it lives (A15)."""

import os
import select
import threading
from collections.abc import Callable
from contextlib import AbstractContextManager
from time import monotonic, monotonic_ns

from msgspec import Struct
from msgspec.structs import replace

from onika.agent.use import RuntimeUse
from onika.desk.run.runtime_conversation import RuntimeConversation
from onika.link.address import Address
from onika.link.lost import LinkLost
from onika.wire import holding, live, request
from onika.wire.runtime_standing import Standing
from onika.words.reason import NOTHING, Reason, reason_of

LOOK_S = 1.0
"""How often it is looked who is there and what runs."""

Opens = Callable[[], AbstractContextManager[RuntimeConversation]]
"""Starts a runtime; the runtime ends with the block. Raises OSError."""


class RuntimeNews(Struct, frozen=True):
    """How a runtime stands: `starting`, `running`, `over`, or `failed`; why it is no more, and what was seen last."""

    state: str = "starting"
    reason: Reason = NOTHING
    port: int = 0
    standing: Standing | None = None
    sessions: tuple[holding.SessionStanding, ...] = ()
    """Of all but the site itself."""

    @property
    def lives(self) -> bool:
        """Whether it is there, or about to be."""
        return self.state in ("starting", "running")


class AttendedRuntime:
    """One runtime, from its launch to its end; it lives as long as its thread, and so at most as long as the site.

    stays   whether it goes on when nobody is connected
    clock   ns that never go back
    """

    def __init__(self, opens: Opens, *, stays: bool, clock: Callable[[], int] = monotonic_ns) -> None:
        self.stays = stays
        self._opens = opens
        self._clock = clock
        self._news = RuntimeNews()
        self._changed = threading.Condition()
        self._ending = NOTHING
        self._use = RuntimeUse(clock())
        self._awake, self._waker = os.pipe2(os.O_NONBLOCK | os.O_CLOEXEC)
        self._thread = threading.Thread(target=self._live, name="onika site runtime", daemon=True)

    def start(self) -> None:
        """Begin to launch it."""
        self._thread.start()

    @property
    def news(self) -> RuntimeNews:
        """How it stands."""
        return self._news

    def ready(self, within_s: float) -> RuntimeNews:
        """How it stands once it runs, or does not, at the latest after so long."""
        with self._changed:
            self._changed.wait_for(lambda: self._news.state != "starting", within_s)
        return self._news

    def expect_guest(self) -> bool:
        """Whether whoever is told of it now will find it: it waits for him as after the last one who was there."""
        with self._changed:
            if self._ending or not self._news.lives:
                return False
            self._use.look(self._clock(), is_used=True)
        return True

    def end(self, reason: Reason) -> None:
        """Let it end: drives hold, tasks are turned off."""
        self._ending = reason
        try:
            os.write(self._waker, b"!")
        except OSError:
            return  # it has ended

    def join(self, within_s: float) -> None:
        """Wait until it has ended."""
        self._thread.join(within_s)

    # -- in its thread

    def _live(self) -> None:
        try:
            with self._opens() as runtime:
                self._attend(runtime)
            self._become(RuntimeNews("over", self._ending))
        except LinkLost as lost:
            self._become(RuntimeNews("failed", lost.reason))
        except (OSError, ValueError) as wrong:
            self._become(RuntimeNews("failed", reason_of(wrong)))
        finally:
            os.close(self._awake)
            os.close(self._waker)

    def _attend(self, runtime: RuntimeConversation) -> None:
        self._use.since_ns = self._clock()
        while not self._ending:
            self._look(runtime)
            news = self._news
            standing = news.standing
            is_used = bool(news.sessions) or (
                standing is not None and any(subsystem.application for subsystem in standing.subsystems)
            )
            with self._changed:
                if self._use.look(self._clock(), is_used=is_used) and not self.stays:
                    self._ending = Reason.of("site.nobody_there")
            self._wait(runtime)

    def _look(self, runtime: RuntimeConversation) -> None:
        standing, company = runtime.ask(live.Survey()), runtime.ask(holding.Sessions())
        if not isinstance(standing, Standing) or not isinstance(company, holding.Company):
            answer = standing if isinstance(standing, request.Refused) else company
            raise ValueError(answer.reason if isinstance(answer, request.Refused) else str(answer))
        sessions = tuple(session for session in company.sessions if session.is_here and session.name != company.you)
        port = Address.parse(standing.addresses[0]).port if standing.addresses else 0
        self._become(replace(self._news, state="running", port=port, standing=standing, sessions=sessions))

    def _wait(self, runtime: RuntimeConversation) -> None:
        """Hear the runtime until it is time to look again, or to end."""
        until = monotonic() + LOOK_S
        while not self._ending and (left_s := until - monotonic()) > 0:
            due_s = runtime.due_s()
            wait_s = left_s if due_s is None else min(left_s, due_s)
            select.select([self._awake, *runtime.readers()], runtime.writers(), [], wait_s)
            list(runtime.events(0.0))

    def _become(self, news: RuntimeNews) -> None:
        with self._changed:
            self._news = news
            self._changed.notify_all()
