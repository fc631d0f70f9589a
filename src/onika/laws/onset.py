"""When something begins: so long after the first cycle."""


class Onset:
    """Counts cycles until something begins, `after` seconds behind the first; half a cycle decides."""

    def __init__(self, after: float) -> None:
        self._after, self._cycles = after, -1
        self.age = -after
        """How long ago it began, in s; below 0 before it."""

    def has_come(self, dt: float) -> bool:
        """Whether it has begun in this cycle, `dt` seconds behind the one before; asked once in each cycle."""
        self._cycles += 1
        self.age = self._cycles * dt - self._after
        return self.age >= -dt / 2.0
