"""The quality of a connection: how many heartbeats came as datagrams, when the last one, and how long they take."""

from dataclasses import dataclass

from onika.wire.packet import Beat


@dataclass(frozen=True, slots=True)
class LinkQuality:
    """Of one connection; nothing where no datagram gets through."""

    beats: int = 0
    last_ns: int = 0
    """When the last one came, on this side's clock."""
    round_trip_us: int = -1
    """The shortest round trip of the connection; -1: it was not told."""

    def after(self, beat: Beat, now_ns: int) -> "LinkQuality":
        """With one more; those that came over the connection do not count."""
        if beat.round_trip_us < 0:
            return self
        return LinkQuality(self.beats + 1, now_ns, beat.round_trip_us)
