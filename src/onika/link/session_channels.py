"""The channels of an environment's session: one end for everything, or one for each channel. No I/O, no clock.

The asking channel comes first and leads: the others are opened when it is there and follow it into a new epoch.
"""

from collections.abc import Callable, Sequence
from random import random

from onika.link import lost
from onika.link.carrier import Carrier
from onika.link.channel import Channel
from onika.link.client import ClientEnd
from onika.link.link_events import EpochChanged, LinkNotice, LinkStateChanged, Resumed
from onika.link.link_terms import LOCAL, LinkTerms
from onika.link.lost import LinkLost
from onika.link.pump import Pump
from onika.link.state import LinkState
from onika.words.reason import Reason

_MS = 1_000_000
_FIRST_NS = 250 * _MS
_LONGEST_NS = 2_000 * _MS
_THERE = (LinkState.LINKED, LinkState.SUSPECT)

MakeClient = Callable[[str, LinkTerms, Channel], ClientEnd]
"""Makes the end that decides."""


class _ChannelEnd:
    """One channel: its end, its connection, and when to try for another one."""

    def __init__(self, end: ClientEnd) -> None:
        self.end = end
        self.pump = Pump(end)
        self.is_connecting = False
        self.connect_ns = 0
        self.wait_ns = _FIRST_NS

    def wants(self, now_ns: int) -> bool:
        waits = self.pump.carrier is None and self.end.state is LinkState.APART and not self.is_connecting
        return waits and now_ns >= self.connect_ns

    def rest(self, now_ns: int, jitter: float) -> None:
        """Try again after a while, a longer one each time, and not when everybody else does."""
        self.connect_ns = now_ns + round(self.wait_ns * (0.5 + jitter / 2))
        self.wait_ns = min(2 * self.wait_ns, _LONGEST_NS)


class SessionChannels:
    """One session with one runtime; what it promises is what `ClientEnd` promises."""

    def __init__(
        self,
        client: str,
        terms: LinkTerms = LOCAL,
        channels: Sequence[Channel] = (Channel.ALL,),
        make: MakeClient = ClientEnd,
        jitter: Callable[[], float] = random,
    ) -> None:
        self._jitter = jitter
        self._channel_ends = {channel: _ChannelEnd(make(client, terms, channel)) for channel in channels}
        (self._first,) = (channel_end for channel, channel_end in self._channel_ends.items() if channel.asks)
        self._notices: list[LinkNotice] = []

    @property
    def state(self) -> LinkState:
        """How the environment stands to the runtime; GREETING as long as one channel is missing."""
        states = [channel_end.end.state for channel_end in self._channel_ends.values()]
        if self._first.end.state in _THERE and not all(state in _THERE for state in states):
            return LinkState.GREETING
        suspects = LinkState.SUSPECT in states and self._first.end.state is LinkState.LINKED
        if suspects:
            return LinkState.SUSPECT
        return self._first.end.state

    @property
    def epoch(self) -> str:
        """The name of this life of the session, "" before the first greeting."""
        return self._first.end.epoch

    def states(self) -> dict[Channel, LinkState]:
        """How the environment stands to the runtime on each channel."""
        return {channel: channel_end.end.state for channel, channel_end in self._channel_ends.items()}

    @property
    def carriers(self) -> list[Carrier]:
        """The present connections."""
        return [
            channel_end.pump.carrier
            for channel_end in self._channel_ends.values()
            if channel_end.pump.carrier is not None
        ]

    def wants(self, now_ns: int) -> list[Channel]:
        """The channels to open a connection for now; for each say `attach` or `failed` later."""
        is_led = self._first.end.state in _THERE
        wanted = [
            c
            for c, channel_end in self._channel_ends.items()
            if (is_led or channel_end is self._first) and channel_end.wants(now_ns)
        ]
        for channel in wanted:
            self._channel_ends[channel].is_connecting = True
        return wanted

    def attach(self, channel: Channel, carrier: Carrier, now_ns: int) -> None:
        """There is a connection for this channel, in place of any old one."""
        channel_end = self._channel_ends[channel]
        channel_end.is_connecting = False
        if channel_end.end.state is LinkState.ENDED or (channel_end is not self._first and not self.epoch):
            carrier.close()
            return
        channel_end.pump.attach(carrier, now_ns)
        self._gather(now_ns)

    def failed(self, channel: Channel, now_ns: int) -> None:
        """No connection came about; it is wanted again after a while."""
        channel_end = self._channel_ends[channel]
        channel_end.is_connecting = False
        channel_end.rest(now_ns, self._jitter())

    def request(
        self, body: bytes, now_ns: int, begin_within_ns: int = 0, once: bool = False, urgent: bool = False
    ) -> int:
        """Ask for something; its number. See `ClientEnd.request`."""
        number = self._first.end.request(body, now_ns, begin_within_ns, once, urgent)
        self.push(now_ns)
        return number

    @property
    def request_count(self) -> int:
        """The number of the latest request."""
        return self._first.end.request_count

    def forget(self, number: int) -> None:
        """The answer to this request is not wanted any more."""
        self._first.end.forget(number)

    def service(self, now_ns: int, channel: Channel | None = None) -> None:
        """Take in, let time pass, send, on this channel (None: on all)."""
        for channel_end in self._channel_ends.values() if channel is None else (self._channel_ends[channel],):
            channel_end.pump.service(now_ns)
        self._gather(now_ns)

    def push(self, now_ns: int) -> None:
        """Send what is to be sent."""
        for channel_end in self._channel_ends.values():
            channel_end.pump.push(now_ns)
        self._gather(now_ns)

    def due_ns(self, now_ns: int) -> int | None:
        """How long until `service` or `wants` has something to do; None: not before something else happens."""
        times = [
            due for channel_end in self._channel_ends.values() if (due := channel_end.end.due_ns(now_ns)) is not None
        ]
        if any(carrier.held for carrier in self.carriers):
            return 0
        is_led = self._first.end.state in _THERE
        for channel_end in self._channel_ends.values():
            waits = (
                channel_end.pump.carrier is None
                and channel_end.end.state is LinkState.APART
                and not channel_end.is_connecting
            )
            if waits and (is_led or channel_end is self._first):
                times.append(max(0, channel_end.connect_ns - now_ns))
        return min(times, default=None)

    def close(self, reason: Reason, now_ns: int) -> None:
        """End the session for good; the good-byes are still to be sent."""
        for channel_end in reversed(self._channel_ends.values()):
            channel_end.end.close(reason)
        self.push(now_ns)

    def cut(self, why: LinkLost) -> None:
        """Let all connections go."""
        for channel_end in self._channel_ends.values():
            channel_end.end.cut(why)
            channel_end.pump.drop()

    def take_notices(self) -> list[LinkNotice]:
        """What the owner has not been told yet; signals in order."""
        taken = self._notices.copy()
        self._notices.clear()
        return taken

    def _gather(self, now_ns: int) -> None:
        for channel, channel_end in self._channel_ends.items():
            for notice in channel_end.end.take_notices():
                if isinstance(notice, Resumed | EpochChanged):
                    channel_end.wait_ns = _FIRST_NS
                    if channel_end is self._first:
                        self._lead(now_ns)
                elif isinstance(notice, LinkStateChanged) and notice.lost is not None:
                    channel_end.rest(now_ns, self._jitter())
                if self._is_news(channel, notice):
                    self._notices.append(notice)

    def _is_news(self, channel: Channel, notice: LinkNotice) -> bool:
        """The asking channel speaks for all; another one tells of what it carries, and of a gap in it."""
        if channel.asks:
            return True
        return not isinstance(notice, LinkStateChanged | Resumed)

    def _lead(self, now_ns: int) -> None:
        """The others follow into the epoch of the first, or go on in it; what is of an older one is void."""
        for channel_end in self._channel_ends.values():
            if channel_end is self._first or channel_end.end.epoch == self.epoch:
                continue
            if channel_end.end.state is not LinkState.APART:
                channel_end.end.cut(lost.closed(Reason.of("link.runtime_anew")))
                channel_end.pump.drop()
            channel_end.end.take_notices()
            channel_end.end.follow(self.epoch)
            channel_end.connect_ns = now_ns
