"""Whether the environment itself is alive: who speaks for it to a runtime is silent when it is not (requirement X12).

A runtime far away believes that a holder is there as long as it hears his beats. These come from the thread that talks
with the runtime; so that they do not outlive what they speak for, the environment's own loop is asked again and again.
"""

from collections.abc import Callable

EVERY_S = 0.1
LIMIT_S = 1.0
"""How long an act may keep the environment: more than one that is honest takes, less than a user waits for Stop."""


class LoopWatchdog:
    """Asks a loop whether it is there; `clock` is in seconds, and `answered` is told when it is there again."""

    def __init__(
        self, post: Callable[[Callable[[], None]], None], answered: Callable[[], None], clock: Callable[[], float]
    ) -> None:
        self._post = post
        self._answered = answered
        self._clock = clock
        self._asked_s: float | None = None
        self._due_s = 0.0

    @property
    def is_missing(self) -> bool:
        """Whether it has not answered in time."""
        asked_s = self._asked_s
        return asked_s is not None and self._clock() - asked_s >= LIMIT_S

    def ask(self) -> float:
        """Ask where that is due; how long until there is something to do, in s."""
        now = self._clock()
        asked_s = self._asked_s
        if asked_s is not None:
            return max(0.0, asked_s + LIMIT_S - now)
        if now >= self._due_s:
            self._asked_s, self._due_s = now, now + EVERY_S
            self._post(self._is_there)
        return EVERY_S

    def _is_there(self) -> None:
        """In the loop that is asked."""
        was_missing, self._asked_s = self.is_missing, None
        if was_missing:
            self._answered()
