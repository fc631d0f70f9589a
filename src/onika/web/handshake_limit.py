"""A limit of the TLS handshakes that are under way, so that a crowd at the door costs little and keeps few out.

Each address begins so many at once, then so many in a second; where too many are under way, the oldest of the address
that has the most makes room. No I/O, no clock.
"""

from collections import Counter, OrderedDict

MOST = 256
"""Handshakes under way."""
AT_ONCE = 128
"""What an address may begin without a pause: some browsers with a few connections each."""
_NS = 50_000_000
"""After that it may begin one in so long."""
_ADDRESSES = 4096


class HandshakeLimit:
    """Counts them, by number and address."""

    def __init__(self, most: int = MOST, at_once: int = AT_ONCE) -> None:
        self._most, self._at_once = most, at_once
        self._under_way: OrderedDict[int, str] = OrderedDict()
        self._free_ns: OrderedDict[str, int] = OrderedDict()
        """By address: when all that it began would have been paid for."""
        self._count = 0

    def begin(self, address: str, now_ns: int) -> tuple[int, int | None] | None:
        """One more: its number, and that of the one that makes room for it; None: it may not begin."""
        free_ns = max(self._free_ns.pop(address, now_ns), now_ns)
        is_paid = free_ns - now_ns < self._at_once * _NS
        self._free_ns[address] = free_ns + _NS if is_paid else free_ns
        while len(self._free_ns) > _ADDRESSES:
            self._free_ns.popitem(last=False)
        if not is_paid:
            return None
        evicted = self._evicted() if len(self._under_way) >= self._most else None
        self._count += 1
        self._under_way[self._count] = address
        return self._count, evicted

    def end(self, number: int) -> None:
        """It is done, or gone."""
        self._under_way.pop(number, None)

    def _evicted(self) -> int:
        crowded, _ = Counter(self._under_way.values()).most_common(1)[0]
        number = next(number for number, address in self._under_way.items() if address == crowded)
        self.end(number)
        return number
