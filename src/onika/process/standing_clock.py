"""A clock that can be made to stand, as that of a link whose other end the system holds: no silence passes then."""

from collections.abc import Callable


class StandingClock:
    """Tells the time of another clock, in ns, less all the time that it has stood."""

    def __init__(self, clock: Callable[[], int]) -> None:
        self._clock = clock
        self._stood_ns = 0
        self._stands_at: int | None = None

    def __call__(self) -> int:
        """The time; it never goes back."""
        return self._clock() - self._stood_ns if self._stands_at is None else self._stands_at

    def stand(self) -> None:
        """It stands from now on."""
        self._stands_at = self()

    def go_on(self, passed_ns: int = 0) -> None:
        """It goes on, as if so much had passed while it stood; no more than has."""
        if self._stands_at is not None:
            stood_ns = max(0, self._clock() - self._stood_ns - self._stands_at - passed_ns)
            self._stood_ns, self._stands_at = self._stood_ns + stood_ns, None
