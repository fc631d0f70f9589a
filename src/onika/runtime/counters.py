"""What is counted of one task since its last status (requirements A11, A17)."""


class Counters:
    """Cycles, warnings and the times of cycles in nanoseconds."""

    __slots__ = ("cycles", "least_ns", "most_ns", "since_ns", "total_ns", "warnings")

    def __init__(self, now: int) -> None:
        self.since_ns = now
        self.cycles = 0
        self.warnings = 0
        self.total_ns = 0
        self.least_ns = 0
        self.most_ns = 0

    def add(self, took_ns: int) -> None:
        """One more cycle."""
        self.total_ns += took_ns
        self.cycles += 1
        if took_ns > self.most_ns:  # noqa: PLR1730 - a call of max would cost more than the rest of this function
            self.most_ns = took_ns
        if took_ns < self.least_ns or self.cycles == 1:
            self.least_ns = took_ns

    def span_s(self, now: int) -> float:
        """Seconds counted over; never 0, so that it can be divided by."""
        return max(now - self.since_ns, 1) * 1e-9

    @property
    def mean_ns(self) -> float:
        """Mean time of a cycle; 0 without one."""
        return self.total_ns / self.cycles if self.cycles else 0.0
