"""Three queues of packets to send, by priority: signal before session before stream (§5.8.2).

They share a connection now; a queue could as well have a connection of its own.
"""

from collections import deque
from collections.abc import Sequence

from onika.link.readings import Readings
from onika.wire.packet import Packet, Part, ReplyPacket, RequestPacket

_OVERHEAD = 32


class SendQueues:
    """Greeting, signals, acknowledgements and beats; requests and replies; readings."""

    def __init__(self, readings: Readings) -> None:
        self._readings = readings
        self._signal: deque[Packet] = deque()
        self._session: deque[RequestPacket | ReplyPacket | Part] = deque()
        self._queued: set[tuple[type, int]] = set()
        self._last: Packet | None = None

    def signal(self, packet: Packet) -> None:
        """Queue a packet that goes whatever the room: these are small and bounded by the signals' window."""
        self._signal.append(packet)

    def session(self, parts: Sequence[Part], final: RequestPacket | ReplyPacket, urgent: bool = False) -> None:
        """Queue a request or reply behind its parts, unless it waits here already; urgent ones pass the others."""
        if (type(final), final.number) in self._queued:
            return
        self._queued.add((type(final), final.number))
        if urgent:
            self._session.extendleft((final, *reversed(parts)))
        else:
            self._session.extend((*parts, final))

    def last(self, packet: Packet) -> None:
        """The word after which nothing is said: it goes when both queues are empty, readings are let go."""
        self._last = packet
        self._readings.clear()

    def clear(self) -> None:
        """The connection is another or none: what was said to the old one is void."""
        self._signal.clear()
        self._session.clear()
        self._queued.clear()
        self._readings.clear()
        self._last = None

    def take(self, room: int, now_ns: int) -> list[Packet]:
        """All of the signal queue, then about `room` bytes of the others."""
        taken: list[Packet] = list(self._signal)
        self._signal.clear()
        while self._session and room > 0:
            packet = self._session.popleft()
            if not isinstance(packet, Part):
                self._queued.discard((type(packet), packet.number))
            taken.append(packet)
            room -= len(packet.body) + _OVERHEAD
        if not self._session and self._last is not None:
            taken.append(self._last)
            self._last = None
        taken += self._readings.take(room, now_ns)
        return taken
