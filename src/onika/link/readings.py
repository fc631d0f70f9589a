"""Readings that wait to be sent: the newest value under each key, dropped when it grows old."""

from onika.wire.packet import ReadingPacket


class Readings:
    """At most `keep` keys and about so many bytes, oldest first; a newer reading replaces the older one in its turn."""

    def __init__(self, age_ns: int = 0, keep: int = 4096, keep_bytes: int = 8 * 1024 * 1024) -> None:
        self._age_ns = age_ns
        self._keep = keep
        self._keep_bytes = keep_bytes
        self._bytes = 0
        self._waiting: dict[str, tuple[int, bytes]] = {}
        self._count = 0

    def put(self, key: str, body: bytes, now_ns: int) -> None:
        """A new reading; the keys that have waited longest are dropped when there are too many."""
        if key not in self._waiting and len(self._waiting) >= self._keep:
            self._pop(next(iter(self._waiting)))
        self._bytes += len(body) - len(self._waiting.get(key, (0, b""))[1])
        self._waiting[key] = (now_ns, body)
        while self._bytes > self._keep_bytes and len(self._waiting) > 1:
            self._pop(next(iter(self._waiting)))

    def take(self, room: int, now_ns: int) -> list[ReadingPacket]:
        """Readings for about `room` bytes; those that are too old are dropped."""
        taken: list[ReadingPacket] = []
        while self._waiting and room > 0:
            key = next(iter(self._waiting))
            at_ns, body = self._pop(key)
            if self._age_ns and now_ns - at_ns > self._age_ns:
                continue
            self._count += 1
            taken.append(ReadingPacket(self._count, key, body))
            room -= len(body) + 32
        return taken

    def clear(self) -> None:
        """Nobody is there to read them."""
        self._waiting.clear()
        self._bytes = 0

    def _pop(self, key: str) -> tuple[int, bytes]:
        at_ns, body = self._waiting.pop(key)
        self._bytes -= len(body)
        return at_ns, body
