"""The request server is the runtime's end of all links; requests in, replies, events and readings out."""

import select
import socket
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from onika.host.sessions.leases import SessionSilence
from onika.host.sessions.permission import refusal
from onika.host.sessions.request_decoder import decode
from onika.link.caller import Role
from onika.link.carrier import Carrier, SocketCarrier
from onika.link.link_events import RequestReceived
from onika.link.link_terms import CHILD, LinkTerms
from onika.link.runtime_port import ServerPort
from onika.link.session import EnvironmentSession
from onika.link.sessions import Introduction, Sessions
from onika.wire import event, holding, request
from onika.wire.packet import Bye, encode
from onika.words.reason import Reason, reason_of

_EVERY = "*"
_WAITING = 4 * 1024 * 1024
"""Bytes that may wait for a guest who reads slowly before he is cut."""
_PACKETS, _BYTES = 16, 256 * 1024
"""What one connection of a guest may bring in one turn; the rest waits, so that a flood takes nobody's time."""


@dataclass(frozen=True, slots=True)
class SessionRequest:
    """One request of one session."""

    ticket: int
    session: str
    role: Role
    asked: request.Request
    address: str = ""


class Descriptor(Protocol):
    """What `select` can wait for."""

    def fileno(self) -> int:
        """Its number."""
        ...


class ConnectionSource(Protocol):
    """Where guests come from: the listener, or a test's."""

    address: str
    """Where others reach it."""

    @property
    def post(self) -> Descriptor:
        """Readable when somebody has come, or at its end."""
        ...

    def arrivals(self) -> list[tuple[Introduction, socket.socket]]:
        """Who has come since the last call."""
        ...

    def deaf_ns(self) -> int:
        """For how long it has passed nothing on, though something may have come."""
        ...

    def ending(self) -> Reason:
        """How it ended; empty while it lives."""
        ...


EventObserver = Callable[[event.Event, str], None]
"""Hears an event, and the subsystem it is about."""


class RequestObserver(Protocol):
    """Sees what is asked and told, and what came of it; see `host.sessions.audit_log`."""

    def answered(self, call: SessionRequest, response: request.Response) -> None:
        """A request was answered."""
        ...

    def garbage(self, session: str, text: str) -> None:
        """Something came that is no request."""
        ...

    def came(self, new: Introduction, why_not: Reason) -> None:
        """Somebody has connected, or was turned away."""
        ...

    def lost(self, session: str) -> None:
        """A session is gone."""
        ...

    def told(self, message: event.Event) -> None:
        """Something was told."""
        ...


class RequestServer:
    """All sessions of a runtime; every request gets exactly one response, now or later."""

    def __init__(
        self,
        sessions: Sessions,
        clock: Callable[[], int],
        listener: ConnectionSource | None = None,
        accepts_code: bool = False,
    ) -> None:
        self._sessions = sessions
        self._listener = listener
        self._clock = clock
        self._accepts_code = accepts_code
        self.addresses: tuple[str, ...] = ()
        """Where others reach this runtime."""
        self.libraries: tuple[str, ...] = ()
        """The addresses of libraries that it names to whoever is connected."""
        self._parent: EnvironmentSession | None = None
        self._told: list[tuple[event.Event, str, str]] = []
        self._event_observers: tuple[EventObserver, ...] = ()
        self._tickets: dict[int, tuple[EnvironmentSession, int]] = {}
        self._calls: dict[int, SessionRequest] = {}
        self.watcher: RequestObserver | None = None
        """Who writes down what happens here."""
        self._count = 0
        self._turn = 0

    @property
    def is_open(self) -> bool:
        """Whether somebody may still ask: as long as the launching program is there; for ever where there is none."""
        return self._parent is None or bool(self._parent.ports)

    @property
    def is_waiting(self) -> bool:
        """Whether something still waits to be sent."""
        return bool(self._told) or bool(self.writers())

    def adopt(self, carrier: Carrier, terms: LinkTerms = CHILD) -> str:
        """Serve the program that launched this one; the name of its session."""
        self._parent = self._sessions.adopt(carrier, self._clock(), terms)
        return self._parent.name

    def welcome(self, listener: ConnectionSource) -> None:
        """From now on take in who comes there."""
        self._listener = listener
        self.addresses = (listener.address,)

    def dismiss(self, reason: Reason) -> None:
        """Nobody comes any more, and whoever came is told good-bye; the launching program stays."""
        self.flush()
        self._listener, self.addresses = None, ()
        for session in self._sessions.sessions:
            if session is not self._parent:
                session.close(reason, self._clock())

    def readers(self) -> list[Descriptor]:
        """What to wait for reading."""
        return [*self._ports(), *([] if self._listener is None else [self._listener.post])]

    def writers(self) -> list[Descriptor]:
        """What to wait for writing."""
        return [port for port in self._ports() if port.want_write()]

    def due_s(self) -> float | None:
        """How long `requests` may be left alone, in s; None: until something can be read or written."""
        if self._told:
            return 0.0
        now = self._clock()
        times = [due for session in self._sessions.sessions if (due := session.due_ns(now)) is not None]
        return min(times) * 1e-9 if times else None

    def wait_s(self, most_s: float) -> float:
        """How long to wait at most, where nothing else is to be done for so long."""
        due_s = self.due_s()
        return most_s if due_s is None else min(most_s, due_s)

    def tell(self, message: event.Event, subsystem: str = "", session: str = "") -> None:
        """Say an event to every session that attends the subsystem (empty: to all), and to the named one in any case.

        Numbered, acknowledged, never lost. It goes out at the next `flush`, so that telling never stands between a
        trigger's finish and the next job.
        """
        self._told.append((message, subsystem, session))
        if self.watcher is not None:
            self.watcher.told(message)
        for observer in self._event_observers:
            observer(message, subsystem)

    def overhear(self, observer: EventObserver) -> None:
        """From now on this one too hears every event as it is told, and the subsystem it is about."""
        self._event_observers = (*self._event_observers, observer)

    def leave(self, observer: EventObserver) -> None:
        """It hears no more."""
        self._event_observers = tuple(other for other in self._event_observers if other != observer)

    def flush(self) -> None:
        """Send what was told."""
        if self._told:
            told, self._told = self._told, []
            now = self._clock()
            for one, subsystem, name in told:
                self._say(event.encode(one), subsystem, name, now)

    def attend(self, session: str, subsystems: tuple[str, ...]) -> None:
        """From now on the session hears these subsystems, in place of what it heard before; `*`: all."""
        self.flush()  # what was told before was told to those who attended then
        find = self._sessions.find(session)
        if find is not None:
            find.attends = frozenset(subsystems)

    def show(self, session: str, key: str, body: bytes) -> None:
        """The newest reading under a key, to one session; dropped where there is no room."""
        find = self._sessions.find(session)
        if find is not None:
            find.show(key, body, self._clock())

    def requests(self) -> list[SessionRequest]:
        """What was asked since the last call; what is no request, or is not allowed, is refused at once."""
        self.flush()
        self._welcome()
        now = self._clock()
        sessions = self._sessions.sessions
        self._turn += 1
        first = self._turn % len(sessions) if sessions else 0  # in turns: nobody is always the last
        stirring = self._stirring(sessions[first:] + sessions[:first], now)
        asked = [(session, each) for session in stirring for each in session.service(now)]
        calls = [self._judge(session, each) for session, each in asked if isinstance(each, RequestReceived)]
        return [call for call in calls if call is not None]

    def reply(self, ticket: int, response: request.Response) -> None:
        """Answer a request; what was told before goes first."""
        self.flush()
        session, number = self._tickets.pop(ticket)
        call = self._calls.pop(ticket, None)
        if self.watcher is not None and call is not None:
            self.watcher.answered(call, response)
        session.reply(number, request.encode(response), self._clock())

    def close(self, reason: Reason) -> None:
        """Say good-bye to everybody; `requests` and `is_waiting` go on until it is out."""
        self.flush()
        for session in self._sessions.sessions:
            session.close(reason, self._clock())

    def sessions(self) -> tuple[holding.SessionStanding, ...]:
        """Who is known; here is who is heard at present."""
        sessions = self._sessions.sessions
        return tuple(holding.SessionStanding(one.name, one.caller.role.word, one.is_linked) for one in sessions)

    def hearing(self, session: str) -> SessionSilence | None:
        """How a session is heard; None: it is not known, or the launching program, whose end is told."""
        find = self._sessions.find(session)
        if find is None or find is self._parent:
            return None
        now, link_quality = self._clock(), find.link_quality
        return SessionSilence(
            now - find.heard_ns, link_quality.beats, now - link_quality.last_ns, link_quality.round_trip_us
        )

    @property
    def launcher(self) -> str:
        """The session of the program that launched this runtime, with whose end it ends; empty: nobody did."""
        return "" if self._parent is None else self._parent.name

    def deaf_ns(self) -> int:
        """For how long nothing could be heard, whoever spoke."""
        if self._listener is None:
            return 0
        return self._listener.deaf_ns()

    def lost(self) -> list[str]:
        """The sessions given up since the last call: good-bye, or silence for too long; each loss once."""
        lost = self._sessions.lost(self._clock())
        if self.watcher is not None:
            for session in lost:
                self.watcher.lost(session)
        return lost

    def _stirring(self, sessions: list[EnvironmentSession], now: int) -> list[EnvironmentSession]:
        """Those with something to take in or to do; the system is asked once for all, so that idle ones cost little."""
        poller = select.poll()
        for port in self._ports():
            if port.fileno() >= 0:
                poller.register(port.fileno(), select.POLLIN | (select.POLLOUT if port.want_write() else 0))
        ready = {-1, *(descriptor for descriptor, _ in poller.poll(0))}
        return [
            session
            for session in sessions
            if session.due_ns(now) == 0 or any(port.fileno() in ready for port in session.ports)
        ]

    def _welcome(self) -> None:
        """Take in who has come, and notice when nobody can come any more."""
        if self._listener is None:
            return
        for new, connected in self._listener.arrivals():
            carrier = SocketCarrier(connected, buffer_limit=_WAITING, turn=_PACKETS, turn_bytes=_BYTES)
            why = self._sessions.admit(new, carrier, self._clock())
            if self.watcher is not None:
                self.watcher.came(new, why)
            if why:
                carrier.send(encode(Bye("refused", why)))
                carrier.close()
        ending = self._listener.ending()
        if ending:
            self._listener, self.addresses = None, ()
            self.tell(event.Lost("porter", ending, self._clock() * 1e-9))

    def _judge(self, session: EnvironmentSession, each: RequestReceived) -> SessionRequest | None:
        self._count += 1
        self._tickets[self._count] = (session, each.ticket)
        try:
            message = decode(each.body)
        except ValueError as wrong:
            if self.watcher is not None:
                self.watcher.garbage(session.name, str(wrong))
            self.reply(self._count, request.Refused(reason_of(wrong)))
            return None
        call = SessionRequest(self._count, session.name, session.caller.role, message, session.caller.address)
        self._calls[self._count] = call
        why = refusal(session.caller, message, self._accepts_code)
        if why:
            self.reply(self._count, request.Refused(why))
            return None
        return call

    def _say(self, body: bytes, subsystem: str, name: str, now: int) -> None:
        for session in self._sessions.sessions:
            hears = not subsystem or not session.attends.isdisjoint((subsystem, _EVERY))
            if hears or session.name == name:
                session.signal(body, now)

    def _ports(self) -> list[ServerPort]:
        return [port for session in self._sessions.sessions for port in session.ports]
