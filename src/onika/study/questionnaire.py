"""Two questionnaires and their scores: the System Usability Scale, and the NASA Task Load Index (requirement H05).

SUS  ten statements, 1 (strongly disagree) to 5; of odd ones the answer less 1 counts, of even ones 5 less the answer;
     their sum times 2.5 is 0 to 100 (Brooke, SUS: a quick and dirty usability scale, 1996)
TLX  six scales from 0 to 100 in steps of 5; unweighted ("raw TLX") the mean counts; with the fifteen paired choices,
     which give each scale a weight of 0 to 5, the weighted mean (Hart and Staveland, 1988)
"""

import math
from dataclasses import dataclass
from statistics import fmean

from onika.study.table import SubjectRow
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

STATEMENTS = 10
SCALES = ("mental", "physical", "temporal", "performance", "effort", "frustration")
_WEIGHT = "_weight"
_PAIRS = 15
_LONGEST = 60


@dataclass(frozen=True, slots=True)
class Answers:
    """The scores of a subject; NaN where the answers are not all there."""

    subject: str
    sus: float
    tlx: float
    weighted_tlx: float
    scales: tuple[float, ...]


def sus_score(answers: list[float]) -> float:
    """The score of ten answers from 1 to 5."""
    return 2.5 * (sum(answers[::2]) - 5.0 + 25.0 - sum(answers[1::2]))


def answers_of(row: SubjectRow, file: str, faults: list[Fault]) -> Answers:
    """The scores of a row; an answer that is none is added to the faults, and no score is made without it."""
    statements = [_answer(row, file, f"sus{number}", (1.0, 5.0, 1.0), faults) for number in range(1, STATEMENTS + 1)]
    scales = [_answer(row, file, scale, (0.0, 100.0, 5.0), faults) for scale in SCALES]
    weights = [_answer(row, file, scale + _WEIGHT, (0.0, 5.0, 1.0), faults) for scale in SCALES]
    given = [weight for weight in weights if not math.isnan(weight)]
    weighted = math.nan
    if len(given) == len(SCALES) and sum(given) == _PAIRS:
        weighted = sum(scale * weight for scale, weight in zip(scales, weights, strict=True)) / _PAIRS
    elif given:
        wrong = Reason.of("study.weights", total=_PAIRS, sum=sum(given), count=len(given))
        faults.append(Fault(Place(file, row.line), wrong, Reason.of("study.no_weighted_score")))
    _partly(row, file, {"SUS": statements, "TLX": scales}, faults)
    return Answers(row.subject, sus_score(statements), fmean(scales), weighted, tuple(scales))


def _partly(row: SubjectRow, file: str, kinds: dict[str, list[float]], faults: list[Fault]) -> None:
    for kind, answers in kinds.items():
        missing = sum(map(math.isnan, answers))
        if 0 < missing < len(answers):
            reason = Reason.of("study.answers_missing", kind=kind, count=missing)
            faults.append(Fault(Place(file, row.line), reason, Reason.of("study.no_score")))


def _answer(row: SubjectRow, file: str, column: str, bounds: tuple[float, float, float], faults: list[Fault]) -> float:
    """The answer in a column; NaN where there is none or it is not on its scale."""
    if column not in row.cells:
        return math.nan
    low, high, step = bounds
    number = row.number(column)
    if number is not None and low <= number <= high and (number / step).is_integer():
        return number
    text = row.cells[column][:_LONGEST]
    reason = Reason.of("study.no_answer", column=column, low=low, high=high, step=step, text=text)
    faults.append(Fault(Place(file, row.line), reason, Reason.of("study.cell_left_out")))
    return math.nan
