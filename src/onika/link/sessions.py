"""All sessions of a runtime: who is new, who came back, who is lost and who is forgotten."""

from dataclasses import dataclass

from onika.link.caller import PARENT, Caller
from onika.link.carrier import Carrier
from onika.link.channel import Channel
from onika.link.link_terms import CHILD, LOCAL, LinkTerms
from onika.link.runtime_port import MakeServer
from onika.link.server import ServerEnd
from onika.link.session import EnvironmentSession
from onika.link.signal_journal import SignalJournal
from onika.words.reason import NOTHING, Reason

_FORGET_NS = 600 * 1_000_000_000
_KEEP = 32
_SIGNALS = 4 * 1024 * 1024
"""Bytes of signals that are kept for each session."""


@dataclass(frozen=True, slots=True)
class Introduction:
    """A new connection: on which channel, by whom, and what its greeting says."""

    channel: Channel
    client: str
    epoch: str
    caller: Caller


class Sessions:
    """Sessions by name; a slow, dead or talkative one costs the others nothing but its share."""

    def __init__(
        self,
        epoch: str,
        terms: LinkTerms = LOCAL,
        keep: int = _KEEP,
        forget_ns: int = _FORGET_NS,
        make: MakeServer = ServerEnd,
        session: type[EnvironmentSession] = EnvironmentSession,
    ) -> None:
        self._epoch = epoch
        self._terms = terms
        self._keep = keep
        self._forget_ns = forget_ns
        self._make = make
        self._session = session
        self._count = 0
        self._sessions: dict[str, EnvironmentSession] = {}
        self._by_client: dict[str, EnvironmentSession] = {}
        self._turned_away: list[str] = []

    @property
    def sessions(self) -> list[EnvironmentSession]:
        """All that are known, here or not."""
        return list(self._sessions.values())

    def find(self, name: str) -> EnvironmentSession | None:
        """The session of that name."""
        return self._sessions.get(name)

    def adopt(self, carrier: Carrier, now_ns: int, terms: LinkTerms = CHILD) -> EnvironmentSession:
        """The session of the program that launched this one, which ends with its connection."""
        self._count += 1
        name = f"{PARENT.user}#{self._count}"
        session = self._session(name, "", PARENT, SignalJournal(self._life), terms, False, self._make)
        self._sessions[name] = session
        session.attach(Channel.ALL, carrier, now_ns)
        return session

    def admit(self, new: Introduction, carrier: Carrier, now_ns: int) -> Reason:
        """Take a connection to its session, which is made where there is none; else why it is turned away."""
        session = self._by_client.get(new.client)
        if session is not None and session.caller.user != new.caller.user:
            return Reason.of("link.another_users")
        if session is not None and self._begins_anew(session, new):
            self._part(session)
            session = None
        if session is None and not new.channel.asks:
            return Reason.of("link.no_session")
        if session is not None and not session.fits(new.channel):
            return Reason.of("link.channels_mixed")
        if session is None:
            if not self._has_room():
                return Reason.of("link.sessions_full", count=self._keep)
            session = self._begin(new)
        session.caller = new.caller
        session.attach(new.channel, carrier, now_ns)
        return NOTHING

    def lost(self, now_ns: int) -> list[str]:
        """The sessions given up since the last call; those that are away for long are forgotten too."""
        gone = self._turned_away + [session.name for session in self._sessions.values() if session.is_lost(now_ns)]
        self._turned_away = []
        for session in self.sessions:
            if session.has_left or (not session.ports and now_ns - session.heard_ns >= self._forget_ns):
                self._forget(session)
        return gone

    @property
    def _life(self) -> str:
        return f"{self._epoch}-{self._count}"

    def _begins_anew(self, session: EnvironmentSession, new: Introduction) -> bool:
        """Whether a program that knows nothing of its session has come under the old name.

        Not if nothing was asked: then the same program may have missed the first welcome.
        """
        is_other = session.has_requested or not session.fits(new.channel)
        return new.channel.asks and is_other and new.epoch != session.epoch

    def _begin(self, new: Introduction) -> EnvironmentSession:
        self._count += 1
        name = f"{new.caller.user}#{self._count}"
        journal = SignalJournal(self._life, keep_bytes=_SIGNALS)
        session = self._session(name, new.client, new.caller, journal, self._terms, True, self._make)
        self._sessions[name] = self._by_client[new.client] = session
        return session

    def _has_room(self) -> bool:
        """Whether one more fits, if need be in place of the one that has been away longest."""
        if len(self._by_client) < self._keep:
            return True
        away = [session for session in self._by_client.values() if not session.ports]
        if away:
            self._part(min(away, key=lambda session: session.heard_ns))
        return bool(away)

    def _part(self, session: EnvironmentSession) -> None:
        session.drop()
        if session.leave():
            self._turned_away.append(session.name)
        self._forget(session)

    def _forget(self, session: EnvironmentSession) -> None:
        self._sessions.pop(session.name, None)
        self._by_client.pop(session.client, None)
