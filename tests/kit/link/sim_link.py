"""A simulated connection: two carriers with a faulty network between them, and what its oracle has to know of it."""

from collections.abc import Callable
from typing import Protocol

from onika.link import lost
from onika.link.channel import Channel
from onika.wire.packet import Hello, Packet, Welcome, decode


class SimNetwork(Protocol):
    """The network as a simulated link needs it."""

    @property
    def now_ns(self) -> int:
        """True time."""
        ...

    def carry(self, plug: "SimCarrier", act: Callable[[], None]) -> None:
        """Let this happen at the other end, in time, or never, or twice."""
        ...

    def tell_end(self, plug: "SimCarrier", act: Callable[[], None]) -> None:
        """Let the other end learn, perhaps, that this one is gone."""
        ...

    def sent(self, plug: "SimCarrier", packet: Packet) -> None:
        """A packet left this end."""
        ...

    def came(self, plug: "SimCarrier", packet: Packet, payload: bytes) -> None:
        """A packet came to this end; it lies in its inbox."""
        ...

    def ended(self, plug: "SimCarrier") -> None:
        """This end learns that the connection is no more."""
        ...


class SimCarrier:
    """One end of a simulated link: a carrier."""

    pending = 0
    held = 0

    def __init__(self, cable: "SimLink", air: SimNetwork, is_runtime: bool) -> None:
        self.cable = cable
        self.is_runtime = is_runtime
        self.heard_ns = air.now_ns
        self.free_ns = 0
        self.is_open = True
        self.peer: SimCarrier = self
        self._air = air
        self._inbox: list[bytes] = []
        self._end: lost.LinkLost | None = None

    def fileno(self) -> int:
        """There is none."""
        return -1

    def flush(self) -> None:
        """Nothing ever waits here."""

    def send(self, payload: bytes) -> None:
        """Give it to the network."""
        if self.is_open:
            self._air.sent(self, decode(payload))
            self._air.carry(self, lambda: self.peer.arrive(payload))

    def receive(self) -> list[bytes]:
        """What has come; raises LinkLost at the end."""
        taken, self._inbox = self._inbox, []
        if self._end is not None and not taken:
            raise self._end
        return taken

    def close(self) -> None:
        """Let go; the other end learns it, or not."""
        if self.is_open:
            self.is_open = False
            self._air.tell_end(self, self.peer.hear_end)

    def arrive(self, payload: bytes) -> None:
        """The network brings something."""
        if not self.is_open or self.cable.is_broken:
            return
        packet = decode(payload)
        self.cable.heard_hello |= isinstance(packet, Hello)
        self.cable.heard_welcome |= isinstance(packet, Welcome)
        self.heard_ns = self._air.now_ns
        self._inbox.append(payload)
        self._air.came(self, packet, payload)

    def hear_end(self) -> None:
        """The connection is no more."""
        if self.is_open and self._end is None:
            self._end = lost.closed()
            self._air.ended(self)


class SimLink:
    """One connection for one channel of one environment, and how far its greeting is."""

    def __init__(self, air: SimNetwork, channel: Channel, client: str) -> None:
        self.channel = channel
        self.client = client
        self.is_broken = False
        self.heard_hello = False
        self.heard_welcome = False
        self.is_welcomed = False
        self.beginning: tuple[str, int] | None = None
        """The epoch that was begun on it, and how many signals had been said by then."""
        self.shown = 0
        self.environment = SimCarrier(self, air, False)
        self.runtime = SimCarrier(self, air, True)
        self.environment.peer, self.runtime.peer = self.runtime, self.environment
