"""A dead-man switch whose state comes in pieces over a line that may break."""

LOST_S = 1.0
"""After so long without news nobody is taken to hold on still."""


class DeadMan:
    """What is held counts for `patience` seconds after the last news; after a second without it is let go first.

    Whoever holds it already when somebody begins to look has to let go first, too.
    """

    def __init__(self, patience: float, count: float) -> None:
        self.is_fresh = False
        """Whether the last news is young enough to be believed."""
        self._patience = patience
        self._count = count
        self._age = LOST_S
        self._was_free = False

    def is_held(self, count: float, is_held: bool, dt: float) -> bool:
        """Whether it is held now, `dt` seconds after the last look; another `count` is news."""
        is_news = count != self._count
        self._count = count
        if self._age >= LOST_S:
            self._was_free = False
        self._age = 0.0 if is_news else self._age + dt
        self.is_fresh = self._age < self._patience - dt / 2.0
        self._was_free = self._was_free or (is_news and not is_held)
        return is_held and self._was_free and self.is_fresh
