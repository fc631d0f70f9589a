"""Parts of a long body: split by the sender, gathered by the receiver (§5.8.2: large data is split)."""

from onika.wire.packet import Part
from onika.words.reason import Reason


def split(number: int, body: bytes, piece: int) -> tuple[list[Part], bytes]:
    """The parts that go ahead, and the last piece, which goes in the request or reply itself."""
    last = max(0, (len(body) - 1) // piece)
    parts = [Part(number, index, body[index * piece : (index + 1) * piece]) for index in range(last)]
    return parts, body[last * piece :]


class BodyAssembly:
    """Parts received on one connection, by number, until the packet comes that completes them."""

    def __init__(self, limit: int) -> None:
        self._limit = limit
        self._bytes = 0
        self._parts: dict[int, dict[int, bytes]] = {}

    def put(self, part: Part) -> None:
        """Keep a part; raises ValueError when the parts together are longer than the limit."""
        pieces = self._parts.setdefault(part.number, {})
        if part.index in pieces:
            return
        # every part costs something, so that endless empty ones are noticed too
        self._bytes += len(part.body) + 64
        if self._bytes > self._limit:
            raise ValueError(Reason.of("link.body_limit", limit=self._limit))
        pieces[part.index] = part.body

    def complete(self, number: int, parts: int, last: bytes) -> bytes | None:
        """The whole body, or None while a part is missing; the parts are let go."""
        if not parts:
            return last
        pieces = self._parts.get(number, {})
        if any(index not in pieces for index in range(parts)):
            return None
        self.drop(number)
        return b"".join([*(pieces[index] for index in range(parts)), last])

    def drop(self, number: int) -> None:
        """Nobody wants the parts of this number."""
        self._bytes -= sum(len(body) + 64 for body in self._parts.pop(number, {}).values())

    def clear(self) -> None:
        """A new connection begins."""
        self._parts.clear()
        self._bytes = 0
