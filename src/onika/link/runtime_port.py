"""The runtime's port for one environment, served in the runtime's own loop; it never waits."""

from collections.abc import Callable

from onika.link.carrier import Carrier
from onika.link.channel import Channel
from onika.link.link_events import LinkNotice
from onika.link.link_quality import LinkQuality
from onika.link.link_terms import LOCAL, LinkTerms
from onika.link.pump import Pump
from onika.link.reply_log import ReplyLog
from onika.link.server import ServerEnd
from onika.link.signal_journal import SignalJournal
from onika.link.state import LinkState
from onika.words.reason import NOTHING, Reason

MakeServer = Callable[[SignalJournal, ReplyLog, LinkTerms, Channel], ServerEnd]
"""Makes the end that decides."""


class ServerPort:
    """Answers one environment at a time; when its connection ends, another may be attached and goes on.

    Ports of one runtime share its journal and its reply log.
    """

    def __init__(
        self,
        journal: SignalJournal,
        replies: ReplyLog | None = None,
        terms: LinkTerms = LOCAL,
        channel: Channel = Channel.ALL,
        make: MakeServer = ServerEnd,
    ) -> None:
        self._end = make(journal, replies or ReplyLog(), terms, channel)
        self._pump = Pump(self._end)

    @property
    def state(self) -> LinkState:
        """How the runtime stands to the environment."""
        return self._end.state

    @property
    def is_open(self) -> bool:
        """Whether there is a connection, so that `fileno` can be waited for."""
        return self._pump.carrier is not None

    @property
    def heard_ns(self) -> int:
        """When the environment was heard last."""
        return self._end.heard_ns

    @property
    def link_quality(self) -> LinkQuality:
        """Its beats that came as datagrams."""
        return self._end.link_quality

    @property
    def has_more(self) -> bool:
        """Whether something came that the last `service` left for the next."""
        return self._pump.carrier is not None and self._pump.carrier.held > 0

    def fileno(self) -> int:
        """The descriptor to wait for reading; -1 when there is no connection."""
        if self._pump.carrier is not None:
            return self._pump.carrier.fileno()
        return -1

    def want_write(self) -> bool:
        """Whether to wait for writing too."""
        return self._pump.carrier is not None and self._pump.carrier.pending > 0

    def due_ns(self, now_ns: int) -> int | None:
        """How long the loop may wait before `service` has something to do; None: until something else happens."""
        return self._end.due_ns(now_ns)

    def attach(self, carrier: Carrier, now_ns: int) -> None:
        """Serve this connection from now on, in place of any old one."""
        self._pump.attach(carrier, now_ns)

    def service(self, now_ns: int) -> list[LinkNotice]:
        """Take in, let time pass, send; what happened, in order: Greeted, Asked, Turned. Never raises LinkLost."""
        self._pump.service(now_ns)
        return self._end.take_notices()

    def reply(self, ticket: int, body: bytes, now_ns: int) -> None:
        """Answer what was Asked under this ticket, at any time, once; raises KeyError for any other ticket."""
        self._end.reply(ticket, body)
        self._pump.push(now_ns)

    def signal(self, body: bytes, now_ns: int) -> int:
        """Say something that must arrive, once and in order, now or after a reconnection; its number."""
        seq = self._end.signal(body, now_ns)
        self._pump.push(now_ns)
        return seq

    def reading(self, key: str, body: bytes, now_ns: int) -> None:
        """Show the newest value under a key; it goes at the next `service`, if there is room on the way."""
        self._end.reading(key, body, now_ns)

    def close(self, now_ns: int, reason: Reason = NOTHING) -> None:
        """Say good-bye; serve on while `is_open`, so that a slow reader gets what was said last."""
        self._end.close(reason)
        self._pump.push(now_ns)

    def drop(self) -> None:
        """Let the connection go at once."""
        self._pump.drop()
