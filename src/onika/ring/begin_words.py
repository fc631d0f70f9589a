"""Words of shared memory by which a program lets a unit begin at an agreed time, and says that all others have begun.

Each appointment has a number from 1, never given twice; two words are its own. The unit looks at them at its time, so
that a program that is frozen then has neither let it begin nor keeps what has begun from being held.
"""

_PLACES = 8
SIZE = _PLACES * 16


class BeginWords:
    """Written by the program, read by the unit; at most eight appointments of a unit are under way at one time."""

    def __init__(self, view: memoryview | None = None) -> None:
        words = memoryview(bytearray(SIZE)) if view is None else view[:SIZE]
        self._words = words.cast("Q")

    def permit(self, number: int) -> None:
        """It may begin."""
        self._words[_place(number)] = number

    def revoke(self, number: int) -> None:
        """It may not begin, unless it has."""
        if self.is_permitted(number):
            self._words[_place(number)] = 0

    def is_permitted(self, number: int) -> bool:
        """Whether it may begin."""
        return self._words[_place(number)] == number

    def confirm(self, number: int) -> None:
        """All others have begun, too: it is not held."""
        self._words[_place(number) + 1] = number

    def is_confirmed(self, number: int) -> bool:
        """Whether all others are known to have begun."""
        return self._words[_place(number) + 1] == number


def _place(number: int) -> int:
    return number % _PLACES * 2
