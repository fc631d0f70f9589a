"""The subjects of a study by their groups, and the groups compared in each figure (requirement H03)."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from onika.study.comparison import Comparison, compare
from onika.study.measure_names import COMPARED
from onika.study.subject import Subject

Points = Mapping[str, Sequence[tuple[str, float]]]
"""Names of subjects with their values, by groups."""


@dataclass(frozen=True, slots=True)
class ComparedFigure:
    """A figure: its name, the values of each group, and what comes of comparing them."""

    figure: str
    points: Points
    comparison: Comparison


def compared(subjects: Sequence[Subject]) -> tuple[ComparedFigure, ...]:
    """Every figure that some subject has."""
    figures = (
        ComparedFigure(name, points, _comparison(points)) for name in COMPARED if (points := _points(subjects, name))
    )
    return tuple(figures)


def _points(subjects: Sequence[Subject], figure: str) -> Points:
    """Groups in the order of their names; a figure that is no number is left out."""
    points: dict[str, list[tuple[str, float]]] = {}
    for subject in subjects:
        value = subject.figures.get(figure)
        if subject.is_compared and value is not None and not math.isnan(value):
            points.setdefault(subject.group, []).append((subject.name, value))
    return dict(sorted(points.items()))


def _comparison(points: Points) -> Comparison:
    return compare({group: [value for _, value in named] for group, named in points.items()})
