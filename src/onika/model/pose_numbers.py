"""A frame as the nine numbers of a Cartesian target: approach, normal, position (reading 44)."""

from collections.abc import Sequence

COUNT = 9
SHAPE = "double[4,4]"
"""The shape of a variable that holds a frame: the axes and the position as columns."""


def nine_of(rows: Sequence[Sequence[float]]) -> tuple[float, ...]:
    """The nine numbers of a frame of four rows: its third column, its first and its last, without the row below."""
    columns = list(zip(*rows[:3], strict=True))
    return tuple(float(number) for column in (columns[2], columns[0], columns[3]) for number in column)
