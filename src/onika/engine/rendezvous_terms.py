"""The terms of a rendezvous: how long before a beginning who does what, from how far apart two runtimes are.

`alone_ns` is the number that users are told: nobody who has begun alone is driven on for longer (docs/safety.md).
"""

from dataclasses import dataclass

EVERY_NS = 20_000_000
"""How often a runtime says how it stands, besides at each change."""

LATE_NS = 5_000_000
"""Nothing is committed or begun later than this after its time."""


@dataclass(frozen=True, slots=True)
class RendezvousTerms:
    """In ns. `one_way_ns` is what a datagram takes at least, `clock_ns` by how much two clocks may be misjudged."""

    one_way_ns: int
    clock_ns: int

    @property
    def alone_ns(self) -> int:
        """So long after its beginning is held who does not know that all others have begun."""
        return self.one_way_ns * 3 // 2 + 4 * EVERY_NS + 2 * self.clock_ns

    @property
    def commit_ns(self) -> int:
        """So long before the beginning everybody commits himself."""
        return self.alone_ns

    @property
    def lead_ns(self) -> int:
        """So long before the beginning it is proposed."""
        return self.commit_ns + 3 * self.one_way_ns + 5 * EVERY_NS

    @property
    def near_ns(self) -> int:
        """Who was not heard for longer is not proposed anything to."""
        return 3 * self.one_way_ns + 4 * EVERY_NS
