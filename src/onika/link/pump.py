"""The pump: it moves packets between an end, which decides, and a carrier, which transports. It never waits."""

from typing import Protocol

from onika.link.carrier import Carrier
from onika.link.lost import LinkLost, garbage, here
from onika.link.state import LinkState
from onika.wire.packet import Packet, decode, encode
from onika.words.reason import reason_of

LOW_WATER = 128 * 1024
"""Bytes under way beyond which only signals and beats are added."""


class LinkEnd(Protocol):
    """What the two ends of the link have in common; see `ClientEnd` and `ServerEnd`."""

    @property
    def state(self) -> LinkState:
        """How this end stands to the other."""

    def open(self, now_ns: int) -> None:
        """There is a new connection."""

    def cut(self, why: LinkLost) -> None:
        """The connection is gone or unusable."""

    def feed(self, packet: Packet, now_ns: int) -> None:
        """A packet came."""

    def tick(self, now_ns: int) -> None:
        """Time has passed."""

    def due_ns(self, now_ns: int) -> int | None:
        """How long until `tick` has something to do."""

    def take_packets(self, now_ns: int, room: int) -> list[Packet]:
        """What is to be sent now."""


class Pump:
    """Serves one end over one carrier at a time."""

    def __init__(self, end: LinkEnd) -> None:
        self._end = end
        self._carrier: Carrier | None = None

    @property
    def carrier(self) -> Carrier | None:
        """The present connection, None when there is none."""
        return self._carrier

    def attach(self, carrier: Carrier, now_ns: int) -> None:
        """Go on over a new connection; an old one is let go."""
        if self._carrier is not None:
            self._carrier.close()
        self._carrier = carrier
        self._end.open(now_ns)
        self.push(now_ns)

    def service(self, now_ns: int) -> None:
        """Take in what came, then let time pass, then send."""
        self._pull(now_ns)
        self._end.tick(now_ns)
        self.push(now_ns)

    def push(self, now_ns: int) -> None:
        """Send what is to be sent, as far as it goes without waiting."""
        carrier = self._carrier
        if carrier is None:
            return
        try:
            carrier.flush()
            while packets := self._end.take_packets(now_ns, LOW_WATER - carrier.pending):
                for packet in packets:
                    carrier.send(encode(packet))
        except LinkLost as why:
            self._end.cut(why)
            self.drop()
        if self._end.state is LinkState.APART or (self._end.state is LinkState.ENDED and not carrier.pending):
            self.drop()

    def drop(self) -> None:
        """Let the connection go."""
        if self._carrier is not None:
            self._carrier.close()
            self._carrier = None
            self._end.cut(here())

    def _pull(self, now_ns: int) -> None:
        if self._carrier is None:
            return
        try:
            for payload in self._carrier.receive():
                self._end.feed(decode(payload), now_ns)
        except LinkLost as why:
            self._end.cut(why)
        except ValueError as fault:
            self._end.cut(garbage(reason_of(fault)))
