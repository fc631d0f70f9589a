"""The heartbeat registry knows whose datagram a heartbeat is, and whether it counts. No I/O, no clock.

Strangers cost next to nothing.
"""

from collections.abc import Callable
from dataclasses import dataclass

from onika.link.heartbeat import HeartbeatKey, name_in

Came = Callable[[int], None]
"""A beat of a connection has come, with its count."""


@dataclass(slots=True)
class _Line:
    heartbeat_key: HeartbeatKey
    came: Came
    last: int = 0


class HeartbeatRegistry:
    """The connections of a listener that may beat by datagram; `port` 0: none may."""

    def __init__(self, port: int = 0) -> None:
        self.port = port
        self._lines: dict[bytes, _Line] = {}

    def open(self, came: Came) -> HeartbeatKey | None:
        """For a new connection: what its other end is told; None where there are no datagrams."""
        if not self.port:
            return None
        heartbeat_key = HeartbeatKey.drawn(self.port)
        self._lines[heartbeat_key.name] = _Line(heartbeat_key, came)
        return heartbeat_key

    def close(self, heartbeat_key: HeartbeatKey | None) -> None:
        """The connection is no more, and its beats count no more."""
        if heartbeat_key is not None:
            self._lines.pop(heartbeat_key.name, None)

    def take(self, datagram: bytes) -> bool:
        """A datagram came; whether it is a beat that was not there before. A late one counts no more."""
        line = self._lines.get(name_in(datagram))
        if line is None:
            return False
        count = line.heartbeat_key.count_in(datagram)
        if count is None or count <= line.last:
            return False
        line.last = count
        line.came(count)
        return True
