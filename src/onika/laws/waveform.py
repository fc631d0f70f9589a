"""Test signals: periodic waves between -1 and 1, and the course of a sweep."""

import math

PERIODIC = ("sine", "square", "triangle")
"""What repeats by itself; a step and a sweep do not."""


def wave(kind: str, turns: float, rate: float) -> tuple[float, float]:
    """The value of a wave after so many turns, and its slope per second where they pass at `rate` Hz.

    A sine and a triangle begin at 0 and rise; a square is 1 in the first half of each turn, -1 in the second, and its
    slope counts as 0. Raises ValueError for another kind.
    """
    if kind == "sine":
        angle = 2.0 * math.pi * (turns % 1.0)
        return math.sin(angle), 2.0 * math.pi * rate * math.cos(angle)
    if kind == "square":
        return (1.0 if turns % 1.0 < 0.5 else -1.0), 0.0
    if kind == "triangle":
        place = (turns - 0.25) % 1.0
        slope = 4.0 * rate if place >= 0.5 else -4.0 * rate
        return 4.0 * abs(place - 0.5) - 1.0, slope
    raise ValueError(f"expected one of {' '.join(PERIODIC)}, found {kind}")


def sweep(time: float, first: float, last: float, lasts: float) -> tuple[float, float]:
    """The turns of a linear sweep so long after its beginning, and its frequency then; Hz and seconds.

    It goes from `first` to `last` in about `lasts` seconds: shortened to whole turns, so that a sine is back at 0 in
    the end, and from then on it rests. One of less than a turn rests from the beginning.
    """
    mean = (first + last) / 2.0
    whole = math.floor(mean * lasts + 1e-9)
    if whole < 1:
        return 0.0, 0.0
    duration = whole / mean
    if time >= duration:
        return float(whole), 0.0
    slope = (last - first) / duration
    return first * time + slope * time * time / 2.0, first + slope * time
