"""The pace of what one browser sends: some hundred messages at once, then so many a second."""

AT_ONCE = 400
A_SECOND = 200.0


class Pace:
    """Says after each message how long the next one is not read."""

    def __init__(self, at_once: int = AT_ONCE, a_second: float = A_SECOND) -> None:
        self._at_once, self._gap_s = at_once, 1.0 / a_second
        self._paid_s = 0.0

    def wait_s(self, now_s: float) -> float:
        """Seconds to wait; 0 for whoever sends as people do."""
        self._paid_s = max(self._paid_s, now_s) + self._gap_s
        return max(0.0, self._paid_s - now_s - self._at_once * self._gap_s)
