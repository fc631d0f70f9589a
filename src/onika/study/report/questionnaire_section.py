"""Scores of questionnaires as a part of the page, by groups and for each subject (requirement H05)."""

import math
from collections.abc import Callable, Iterator, Sequence
from statistics import fmean, stdev

from onika.study.folder import Study
from onika.study.questionnaire import Answers
from onika.study.report import box_plot, markup
from onika.words.reason import Reason

Say = Callable[[Reason], str]


def section(study: Study, say: Say) -> Iterator[str]:
    """What was answered; nothing where nobody was asked."""
    if not study.answers:
        return
    groups = {subject.name: subject.group for subject in study.subjects if subject.is_compared}
    yield markup.heading(2, say(Reason.of("study.answers_head")))
    yield markup.paragraph(say(Reason.of("study.answers_text")), "dim")
    for kind in ("sus", "tlx"):
        points = points_of(study.answers, groups, kind)
        if not points:
            continue
        title = say(Reason.of(_TITLES[kind]))
        yield markup.heading(3, title)
        yield markup.figure(box_plot.drawn(points, title), say(Reason.of("study.box_caption")))
        heads = ("study.group", "study.subjects", "study.mean", "study.spread")
        rows = [_row(group, [value for _, value in named]) for group, named in points.items()]
        yield markup.table([say(Reason.of(key)) for key in heads], rows)
    yield _each(study.answers, say)


_TITLES = {"sus": "study.sus_title", "tlx": "study.tlx_title"}


def points_of(answers: Sequence[Answers], groups: dict[str, str], kind: str) -> dict[str, list[tuple[str, float]]]:
    """The scores by groups of subjects that are compared."""
    points: dict[str, list[tuple[str, float]]] = {}
    for given in answers:
        score = getattr(given, kind)
        if given.subject in groups and not math.isnan(score):
            points.setdefault(groups[given.subject], []).append((given.subject, score))
    return dict(sorted(points.items()))


def _row(group: str, scores: Sequence[float]) -> tuple[str, ...]:
    spread = markup.NOTHING
    if len(scores) > 1:
        spread = markup.number(stdev(scores), 1)
    return group, str(len(scores)), markup.number(fmean(scores), 1), spread


def _each(answers: Sequence[Answers], say: Say) -> str:
    heads = ("study.subject", "study.sus_title", "study.tlx_title", "study.weighted_title")
    rows = [
        (given.subject, *(markup.number(score, 1) for score in (given.sus, given.tlx, given.weighted_tlx)))
        for given in answers
    ]
    return markup.table([say(Reason.of(key)) for key in heads], rows)
