"""A line that the user types: waited for in short turns, so that a Ctrl-C just before the wait is not missed."""

import select
import sys

_TURN_S = 0.1


def typed_line() -> str | None:
    """The next line of the input without its end; None at the end of the input."""
    while not select.select([sys.stdin], [], [], _TURN_S)[0]:
        pass
    line = sys.stdin.readline()
    return line.rstrip("\n") if line else None
