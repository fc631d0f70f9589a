"""A control authority by itself: fakes of all that it works with, and the messages that it sends."""

from inspect import getgeneratorlocals
from types import SimpleNamespace
from typing import Any

from onika.host.sessions.control_authority import ControlAuthority
from onika.host.subsystems.live_subsystem import Transaction
from onika.wire import event, holding, live, request
from onika.words.reason import Reason


class LiveFake:
    """A subsystem by hand; notes what is begun in it."""

    def __init__(self, holder: str = "", *members: str) -> None:
        self.holder = holder
        self.members = dict.fromkeys(members)
        self.begun: list[tuple[int, bool]] = []

    @property
    def is_empty(self) -> bool:
        """Whether no task is in it."""
        return not self.members

    def begin(self, number: int, transaction: Transaction) -> None:
        """Note whether the transaction is this subsystem's; nothing of it is carried out."""
        self.begun.append((number, getgeneratorlocals(transaction)["live"] is self))
        transaction.close()


class RunFake:
    """A run of an application; notes why it was abandoned."""

    def __init__(self, session: str, *names: str, application: str = "work", on_loss: str = "stop") -> None:
        self.session, self.names, self.application, self.on_loss = session, names, application, on_loss
        self.abandoned: list[tuple[Reason, int]] = []

    def abandon(self, cause: Reason, now: int) -> None:
        """Its holder is silent or gone."""
        self.session = ""
        self.abandoned.append((cause, now))

    def pass_on(self, session: str) -> None:
        """Another one holds it."""
        self.session = session


class SubsystemsFake:
    """The subsystems of a runtime, by hand and in runs."""

    def __init__(self) -> None:
        self.live: dict[str, LiveFake] = {}
        self.runs: list[RunFake] = []
        self.released: list[str] = []
        self.hold = SimpleNamespace(release=self.released.append)

    def run_in(self, name: str) -> RunFake | None:
        """The run that a subsystem belongs to."""
        return next((run for run in self.runs if name in run.names), None)

    def by_hand(self, name: str) -> LiveFake:
        """The subsystem of this name, made where there is none."""
        return self.live.setdefault(name, LiveFake())

    def drop(self, name: str) -> None:
        """It is no more."""
        del self.live[name]


class AuthorityBench:
    """A control authority among fakes, with the messages that it sends."""

    def __init__(self) -> None:
        self.subsystems = SubsystemsFake()
        self.messages: list[tuple[event.Event, str, str]] = []
        self.standings = [holding.SessionStanding(name, "operator") for name in ("one", "two", "ann#1", "ann#2")]
        steering: Any = SimpleNamespace(refusal=lambda session, message: Reason.plain(f"{session}: {message!r}"))
        subsystems: Any = self.subsystems
        self.authority = ControlAuthority(subsystems, self._tell, steering, lambda: self.standings)

    def refusal(self, session: str, message: request.Request, is_stopped: bool = False) -> Reason:
        """Why a session may not ask this; NOTHING: it may."""
        return self.authority.refusal(session, message, is_stopped)

    def take(self, session: str, name: str = "s0") -> request.Response:
        """The session wants to hold the subsystem."""
        return self.authority.change(session, live.Take(name))

    def release(self, session: str, name: str = "s0") -> request.Response:
        """The session gives the subsystem back."""
        return self.authority.change(session, live.Release(name))

    def hand(self, session: str, to: str, name: str = "s0", wall_ns: int = 0) -> request.Response:
        """The session offers the subsystem to another; to nobody, it withdraws the offer."""
        return self.authority.hand(session, holding.Hand(name, to), wall_ns)

    def runs(self, session: str, *names: str, on_loss: str = "stop") -> RunFake:
        """A run of the session goes on in these subsystems from now on."""
        run = RunFake(session, *names, on_loss=on_loss)
        self.subsystems.runs.append(run)
        return run

    def keys(self) -> list[tuple[str, str, str]]:
        """The messages sent since the last time: of which subsystem, to whom, and why."""
        keys = [(name, session, _key(message)) for message, name, session in self.messages]
        self.messages.clear()
        return keys

    def _tell(self, message: event.Event, subsystem: str, session: str) -> None:
        self.messages.append((message, subsystem, session))


def _key(message: event.Event) -> str:
    if isinstance(message, event.Held):
        return message.cause.key
    assert isinstance(message, event.Offered)
    return message.outcome.key
