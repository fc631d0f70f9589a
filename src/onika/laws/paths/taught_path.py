"""A taught path: joint positions over time, as a file of rows keeps them."""

import numpy as np

from onika.laws.frames import Array, Numbers
from onika.laws.paths.joint_range import check_range
from onika.laws.sentence import LawSentence

_LOOKS = np.linspace(0.0, 0.8, 5)


class TaughtPath:
    """Passes `rows` double[m,n] (rad, m) at `times` double[m] (s, rising), smoothly, at rest at both ends.

    Between two rows it is a cubic whose speeds at the rows are those of the line between their neighbours. The time is
    stretched where a joint would be faster than `speed`, judged at the rows and four points between each two.
    """

    def __init__(self, times: Array, rows: Array, speed: Numbers) -> None:
        self._rows, self._own = rows, times - times[0]
        self._slopes = np.zeros_like(rows)
        if len(rows) > 2:
            self._slopes[1:-1] = (rows[2:] - rows[:-2]) / (times[2:] - times[:-2])[:, None]
        looks = np.append(self._own[:-1, None] + np.diff(self._own)[:, None] * _LOOKS, self._own[-1])
        peak = float(np.max(np.abs(self._course(looks)[1]) / np.asarray(speed)))
        self.stretch = max(1.0, peak)
        """How many times as long as it was taught it takes."""

    @property
    def duration(self) -> float:
        """Seconds that it takes."""
        return float(self._own[-1]) * self.stretch

    def at(self, t: float) -> tuple[Array, Array]:
        """Position and speed double[n] at t in s; before 0 and after its duration it rests."""
        own = min(max(t / self.stretch, 0.0), float(self._own[-1]))
        places, speeds = self._course(np.array([own]))
        return places[0], speeds[0] / self.stretch

    def check_range(self, low: Numbers, high: Numbers) -> None:
        """Raises ValueError with the first joint that a row would bring beyond its range."""
        check_range(self._rows, low, high)

    def _course(self, t: Array) -> tuple[Array, Array]:
        """Positions and speeds double[k,n], so many seconds after its beginning as it was taught."""
        k = np.clip(np.searchsorted(self._own, t, side="right") - 1, 0, len(self._own) - 2)
        span = (self._own[k + 1] - self._own[k])[:, None]
        x = (t - self._own[k])[:, None] / span
        first, last = self._rows[k], self._rows[k + 1]
        out, into = self._slopes[k] * span, self._slopes[k + 1] * span
        cubic, square = 2.0 * (first - last) + out + into, 3.0 * (last - first) - 2.0 * out - into
        return first + x * (out + x * (square + x * cubic)), (out + x * (2.0 * square + x * 3.0 * cubic)) / span


def path_text(times: Numbers, rows: Array) -> str:
    """A path as the text of a file: a line of heads, then time in s and n positions in each."""
    heads = ",".join(["t", *(f"q{joint}" for joint in range(1, rows.shape[1] + 1))])
    lines = (",".join(f"{number:.9g}" for number in (t, *row)) for t, row in zip(times, rows, strict=True))
    return "\n".join([heads, *lines, ""])


def path_of_text(text: str, n: int) -> tuple[Array, Array]:
    """Times double[m] and rows double[m,n] of such a text; raises ValueError with the line that is wrong."""
    numbers: list[list[float]] = []
    for line, words in enumerate((row.split(",") for row in text.strip().splitlines()[1:]), 2):
        numbers.append(_row(line, words, n))
        if len(numbers) > 1 and numbers[-1][0] <= numbers[-2][0]:
            raise ValueError(
                LawSentence("laws.path_time", "line {line}: expected a time after the one before it", line=line)
            )
    if len(numbers) < 2:
        raise ValueError(
            LawSentence("laws.path_short", "expected two rows at least, found {count}", count=len(numbers))
        )
    table = np.array(numbers)
    return table[:, 0], table[:, 1:]


def _row(line: int, words: list[str], n: int) -> list[float]:
    try:
        row = [float(word) for word in words]
    except ValueError:
        row = []
    if len(row) != n + 1 or not np.isfinite(row).all():
        raise ValueError(
            LawSentence(
                "laws.path_row", "line {line}: expected a time and {n} joint positions as numbers", line=line, n=n
            )
        )
    return row
