"""The wrong tries to sign in, by address: after ten nobody from there is judged for a while, whatever he says.

A right password in between changes nothing, or whoever has one could guess those of others. No I/O, no clock.
"""

import ipaddress
from collections import OrderedDict

MOST = 10
BACK_OFF_NS = 60 * 1_000_000_000
_DOUBLED = 6
_ADDRESSES = 4096
_NETWORK = 64
"""Bits of an IPv6 address that tell one house from another."""


class WrongTries:
    """Counts them."""

    def __init__(self) -> None:
        self._wrong: OrderedDict[str, tuple[int, int]] = OrderedDict()
        """By house: how many, and when the last one was."""

    def wait_ns(self, address: str, now_ns: int) -> int:
        """How long nobody from there is judged; 0: he is."""
        count, last_ns = self._wrong.get(_house(address), (0, now_ns))
        if count < MOST:
            return 0
        return max(0, last_ns + _pause_ns(count) - now_ns)

    def note(self, address: str, now_ns: int) -> int:
        """One more; how many there are now."""
        house = _house(address)
        count, last_ns = self._wrong.pop(house, (0, now_ns))
        forgotten = now_ns >= last_ns + _pause_ns(count) + BACK_OFF_NS
        self._wrong[house] = (1 if forgotten else count + 1, now_ns)
        while len(self._wrong) > _ADDRESSES:
            self._wrong.popitem(last=False)
        return self._wrong[house][0]

    def take_back(self, address: str) -> None:
        """The last one was right."""
        house = _house(address)
        count, last_ns = self._wrong.get(house, (0, 0))
        if count > 1:
            self._wrong[house] = (count - 1, last_ns)
        else:
            self._wrong.pop(house, None)


def _pause_ns(count: int) -> int:
    """A minute after ten, twice as long after each one more, about an hour at most."""
    return BACK_OFF_NS << min(count - MOST, _DOUBLED) if count >= MOST else 0


def _house(address: str) -> str:
    """All addresses that one house has: of IPv6 a whole network."""
    try:
        number = ipaddress.ip_address(address.partition("%")[0])
    except ValueError:
        return address
    if isinstance(number, ipaddress.IPv6Address):
        mapped = number.ipv4_mapped
        return str(mapped) if mapped else str(ipaddress.ip_network((int(number), _NETWORK), strict=False))
    return str(number)
