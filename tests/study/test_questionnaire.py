"""Scores of SUS and NASA-TLX, against examples by hand."""

import math

import pytest

from onika.study.questionnaire import SCALES, answers_of, sus_score
from onika.study.table import SubjectRow


def scored(**cells):
    faults = []
    row = SubjectRow(3, "p1", {name: str(value) for name, value in cells.items()})
    return answers_of(row, "q.csv", faults), [fault.reason.key for fault in faults]


def sus(*answers):
    return {f"sus{number}": answer for number, answer in enumerate(answers, start=1)}


def test_the_scale_of_usability_goes_from_0_to_100():  # R-H05
    assert sus_score([5, 1] * 5) == 100
    assert sus_score([1, 5] * 5) == 0
    assert sus_score([3] * 10) == 50
    assert sus_score([4, 2, 5, 1, 4, 2, 4, 3, 5, 2]) == 80  # (3+3+4+4+3+3+3+2+4+3) times 2.5


def test_the_load_is_the_mean_or_weighed_by_pairs():  # R-H05
    ratings = dict(zip(SCALES, (70, 10, 55, 20, 65, 40), strict=True))
    answers, faults = scored(**ratings)
    assert faults == []
    assert answers.tlx == pytest.approx(260 / 6)
    assert math.isnan(answers.weighted_tlx)
    assert math.isnan(answers.sus)
    weights = {f"{scale}_weight": weight for scale, weight in zip(SCALES, (5, 0, 3, 2, 4, 1), strict=True)}
    answers, faults = scored(**ratings, **weights)
    assert faults == []
    assert answers.weighted_tlx == pytest.approx((350 + 165 + 40 + 260 + 40) / 15)


def test_an_answer_off_its_scale_is_told_and_no_score_made():  # R-H05
    answers, faults = scored(**sus(5, 1, 5, 1, 5, 1, 5, 1, 5, 6))
    assert faults == ["study.no_answer", "study.answers_missing"]
    assert math.isnan(answers.sus)
    answers, faults = scored(**dict.fromkeys(SCALES, 42))
    assert faults == ["study.no_answer"] * 6
    assert math.isnan(answers.tlx)


def test_weights_that_are_not_of_fifteen_pairs_give_no_weighted_score():  # R-H05
    ratings = dict.fromkeys(SCALES, 50)
    answers, faults = scored(**ratings, **{f"{scale}_weight": 5 for scale in SCALES})
    assert faults == ["study.weights"]
    assert math.isnan(answers.weighted_tlx)
    assert answers.tlx == 50
