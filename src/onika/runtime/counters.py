"""The counters of one task since its last status (requirements A11, A17)."""


class Counters:
    """Cycles, warnings, the times of cycles and the time in which the task was ON, in nanoseconds."""

    __slots__ = ("cycles", "least_ns", "most_ns", "on_since_ns", "total_ns", "warnings", "was_on_ns")

    def __init__(self, on_since_ns: int | None = None) -> None:
        self.on_since_ns = on_since_ns
        self.was_on_ns = 0
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

    def add_several(self, cycles: int, total_ns: int, least_ns: int, most_ns: int) -> None:
        """So many cycles more, at least one."""
        self.least_ns = min(self.least_ns, least_ns) if self.cycles else least_ns
        self.most_ns = max(self.most_ns, most_ns)
        self.total_ns += total_ns
        self.cycles += cycles

    def begin(self, now: int) -> None:
        """The task comes on."""
        self.on_since_ns = now

    def end(self, now: int) -> None:
        """The task is ON no more; harmless where it was not."""
        self.was_on_ns = self.profiled_ns(now)
        self.on_since_ns = None

    def profiled_ns(self, now: int) -> int:
        """The time in which cycles could have been counted."""
        return self.was_on_ns + (0 if self.on_since_ns is None else now - self.on_since_ns)

    @property
    def mean_ns(self) -> float:
        """Mean time of a cycle; 0 without one."""
        return self.total_ns / self.cycles if self.cycles else 0.0
