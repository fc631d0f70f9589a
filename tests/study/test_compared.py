"""Which values of which subjects are compared."""

import math

from onika.study.compared import compared
from onika.study.subject import Subject
from onika.words.reason import Reason


def subject(name, group, selection, **more):
    return Subject(name, group, figures={"mean_selection_s": selection}, **more)


def test_who_is_removed_or_unfit_and_what_is_no_number_does_not_count():  # R-H03
    subjects = (
        subject("a", "x", 1.0),
        subject("b", "x", 2.0),
        subject("c", "x", 9.0, removed="ill"),
        subject("d", "w", math.nan),
        subject("e", "w", 3.0),
        subject("f", "w", 4.0, unfit=Reason.of("study.empty_log")),
    )
    (figure,) = compared(subjects)
    assert figure.points == {"w": [("e", 3.0)], "x": [("a", 1.0), ("b", 2.0)]}
    assert [doubt.key for doubt in figure.comparison.doubts] == ["study.group_of_one", "study.one_group"]


def test_of_nobody_nothing_is_compared():  # R-H03
    assert compared(()) == ()
