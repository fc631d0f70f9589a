"""The session of one environment as the runtime keeps it: its signals, its requests, the ports of its connections."""

from onika.link.caller import Caller
from onika.link.carrier import Carrier
from onika.link.channel import Channel
from onika.link.link_events import Greeted, LinkNotice, RequestReceived
from onika.link.link_quality import LinkQuality
from onika.link.link_terms import LinkTerms
from onika.link.reply_log import ReplyLog
from onika.link.runtime_port import MakeServer, ServerPort
from onika.link.server import ServerEnd
from onika.link.signal_journal import SignalJournal
from onika.link.state import LinkState
from onika.words.reason import Reason

_LINKED = (LinkState.LINKED, LinkState.SUSPECT)


class EnvironmentSession:
    """One environment over one connection or three, and over many one after another.

    It is lost when its asking channel said good-bye or was silent for too long, each time once; one that cannot come
    back (the launching program's) is lost with its connection.
    """

    def __init__(
        self,
        name: str,
        client: str,
        caller: Caller,
        journal: SignalJournal,
        terms: LinkTerms,
        can_return: bool = True,
        make: MakeServer = ServerEnd,
    ) -> None:
        self.name = name
        self.client = client
        self.caller = caller
        self.attends: frozenset[str] = frozenset()
        self._journal = journal
        self._terms = terms
        self._can_return = can_return
        self._make = make
        self._ports: dict[Channel, ServerPort] = {}
        self._asking: ServerPort | None = None
        self._replies = ReplyLog()
        self._followers = ReplyLog()
        self._has_greeted = False
        self._is_present = False
        self.has_requested = False
        self._has_shown = False

    @property
    def epoch(self) -> str:
        """The name of this life of the session."""
        return self._journal.epoch

    @property
    def ports(self) -> list[ServerPort]:
        """The ports that have a connection."""
        return [port for port in self._ports.values() if port.is_open]

    @property
    def has_left(self) -> bool:
        """Whether it said good-bye, or was cut and cannot come back."""
        gone = self._asking is not None and not self._asking.is_open and not self._can_return
        return gone or (self._has_greeted and self._replies.find(self.client) is None)

    @property
    def heard_ns(self) -> int:
        """When it was heard last on its asking channel."""
        return 0 if self._asking is None else self._asking.heard_ns

    @property
    def link_quality(self) -> LinkQuality:
        """Its beats that came as datagrams, beside its asking channel."""
        if self._asking is None:
            return LinkQuality()
        return self._asking.link_quality

    @property
    def is_linked(self) -> bool:
        """Whether it has a connection, and was not silent on its asking channel for suspiciously long."""
        is_quiet = self._asking is not None and self._asking.state is LinkState.SUSPECT
        return bool(self.ports) and not is_quiet

    def fits(self, channel: Channel) -> bool:
        """Whether such a connection goes with those it has: one for all, or each of its own."""
        return not self._ports or (channel is Channel.ALL) == (Channel.ALL in self._ports)

    def attach(self, channel: Channel, carrier: Carrier, now_ns: int) -> None:
        """Serve this connection from now on, in place of any old one of its channel."""
        if channel not in self._ports:
            self._ports[channel] = self._open(channel)
        if not channel.asks:
            # part of a session that is known: signals go on where they were, whoever said good-bye there
            self._followers.begin(self.client)
        self._ports[channel].attach(carrier, now_ns)

    def service(self, now_ns: int, channel: Channel | None = None) -> list[LinkNotice]:
        """Take in, let time pass, send, on this channel (None: on all); what happened."""
        notices: list[LinkNotice] = []
        self._has_shown = False
        for port in self._ports.values() if channel is None else (self._ports[channel],):
            for notice in port.service(now_ns):
                notices.append(notice)
                if isinstance(notice, RequestReceived):
                    self.has_requested = True
                elif isinstance(notice, Greeted) and port is self._asking:
                    self.client = notice.client
                    self._has_greeted = self._is_present = True
        return notices

    def states(self) -> dict[Channel, LinkState]:
        """How the runtime stands to it on each channel."""
        return {channel: port.state for channel, port in self._ports.items()}

    def is_lost(self, now_ns: int) -> bool:
        """Whether it is given up now; true once for each loss."""
        if self._asking is not None and self._asking.state in _LINKED:
            return False
        if not self._is_present or not (self.has_left or now_ns >= self.heard_ns + self._terms.lost_ns):
            return False
        return self.leave()

    def leave(self) -> bool:
        """It is given up; whether it was there until now."""
        was_present, self._is_present = self._is_present, False
        return was_present

    def due_ns(self, now_ns: int) -> int | None:
        """How long until `service` or `is_lost` has something to do; None: not before something else happens."""
        if self._has_shown or any(port.has_more for port in self._ports.values()):
            return 0
        times = [due for port in self._ports.values() if (due := port.due_ns(now_ns)) is not None]
        if self._is_present and self._asking is not None and self._asking.state not in _LINKED:
            times.append(max(0, self.heard_ns + self._terms.lost_ns - now_ns))
        return min(times, default=None)

    def signal(self, body: bytes, now_ns: int) -> None:
        """Say something that must arrive, now or when it is here again."""
        port = self._ports.get(Channel.SIGNAL) or self._ports.get(Channel.ALL)
        if port is None:
            self._journal.append(body)
        else:
            port.signal(body, now_ns)

    def reply(self, ticket: int, body: bytes, now_ns: int) -> None:
        """Answer what was asked under this ticket."""
        if self._asking is not None:
            self._asking.reply(ticket, body, now_ns)

    def show(self, key: str, body: bytes, now_ns: int) -> None:
        """Show the newest value under a key, if there is somebody to see it."""
        port = self._ports.get(Channel.STREAM) or self._ports.get(Channel.ALL)
        if port is not None and port.is_open:
            port.reading(key, body, now_ns)
            self._has_shown = True

    def close(self, reason: Reason, now_ns: int) -> None:
        """Say good-bye on every channel; serve on while there are `ports`."""
        for port in self._ports.values():
            port.close(now_ns, reason)

    def drop(self) -> None:
        """Let all connections go at once."""
        for port in self._ports.values():
            port.drop()

    def _open(self, channel: Channel) -> ServerPort:
        if channel.asks:
            port = ServerPort(self._spoken_on(channel), self._replies, self._terms, channel, self._make)
            self._asking = port
            return port
        return ServerPort(self._spoken_on(channel), self._followers, self._terms, channel, self._make)

    def _spoken_on(self, channel: Channel) -> SignalJournal:
        """Signals are said on one channel only; the others just need the epoch."""
        if channel in (Channel.ALL, Channel.SIGNAL):
            return self._journal
        return SignalJournal(self._journal.epoch)
