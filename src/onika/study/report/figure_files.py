"""The figures of a study as CSV, one file for each kind of thing; columns are named as in the code (H02, H03)."""

import dataclasses
from collections.abc import Iterator, Sequence
from itertools import pairwise

from onika.study.compared import ComparedFigure
from onika.study.folder import Study
from onika.study.log import elapsed_s
from onika.study.measure_names import COMPARED
from onika.study.measures import TaskMeasures
from onika.study.questionnaire import SCALES
from onika.study.report.icon_table import icons_of
from onika.study.subject import Subject
from onika.study.table import written

_MEASURES = tuple(field.name for field in dataclasses.fields(TaskMeasures))


def files(study: Study, compared: Sequence[ComparedFigure]) -> dict[str, str]:
    """The texts of the files by their names."""
    tables: dict[str, tuple[Sequence[str], list[Sequence[object]]]] = {
        "figures.csv": (("subject", "group", "compared", *_MEASURES), [_subject(one) for one in study.subjects]),
        "selections.csv": (("subject", "group", "icon", "line", "seconds"), [*_selections(study.subjects)]),
        "icons.csv": (
            ("icon", "count", "mean_s", "longest_s"),
            [dataclasses.astuple(i) for i in icons_of(study.subjects)],
        ),
        "timelines.csv": (_TIMELINE, [*_timelines(study.subjects)]),
        "groups.csv": (
            ("figure", "group", "count", "mean", "spread", "low", "high", "shapiro_p"),
            [*_groups(compared)],
        ),
        "tests.csv": (("figure", "test", "statistic", "between", "within", "p"), [*_tests(compared)]),
        "effects.csv": (("figure", "eta_squared", "low", "high", "omega_squared", "cohens_f"), [*_effects(compared)]),
        "pairs.csv": (_PAIRS, [*_pairs(compared)]),
        "scores.csv": (("subject", "sus", "tlx", "weighted_tlx", *SCALES), [*_scores(study)]),
    }
    return {name: written(columns, rows) for name, (columns, rows) in tables.items()}


_TIMELINE = ("subject", "after_s", "at_s", "event", "object", "id", "associated", "associated_id", "window", "line")
_PAIRS = ("figure", "first", "second", "low", "difference", "high", "tukey_p", "games_howell_p", "g", "g_low", "g_high")


def _subject(subject: Subject) -> Sequence[object]:
    if subject.measures is not None:
        values = [_cell(getattr(subject.measures, name)) for name in _MEASURES]
    else:
        values = [subject.figures.get(name, "") if name in COMPARED else "" for name in _MEASURES]
    return subject.name, subject.group, _cell(subject.is_compared), *values


def _cell(value: object) -> object:
    if isinstance(value, bool):
        return ("no", "yes")[value]
    return value


def _selections(subjects: Sequence[Subject]) -> Iterator[Sequence[object]]:
    for subject in subjects:
        for selection in subject.selections:
            yield subject.name, subject.group, selection.icon, selection.line, selection.seconds


def _timelines(subjects: Sequence[Subject]) -> Iterator[Sequence[object]]:
    """As §E.4 has it: how long after the event before, and when since the task began."""
    for subject in subjects:
        entries = subject.task.entries if subject.task else ()
        for before, entry in pairwise((*entries[:1], *entries)):
            words = (entry.event, entry.object, entry.id, entry.associated, entry.associated_id, entry.window)
            after_s, at_s = elapsed_s(before.at_s, entry.at_s), elapsed_s(entries[0].at_s, entry.at_s)
            yield subject.name, after_s, at_s, *words, entry.line


def _groups(compared: Sequence[ComparedFigure]) -> Iterator[Sequence[object]]:
    for figure in compared:
        for group in figure.comparison.groups:
            numbers = (group.mean, group.spread, group.low, group.high, group.normal_p)
            yield figure.figure, group.name, len(group.values), *numbers


def _tests(compared: Sequence[ComparedFigure]) -> Iterator[Sequence[object]]:
    for figure in compared:
        comparison = figure.comparison
        tests = {
            "anova": comparison.variance,
            "welch": comparison.welch,
            "kruskal_wallis": comparison.ranks,
            "brown_forsythe": comparison.spreads,
        }
        for name, test in tests.items():
            yield figure.figure, name, test.statistic, test.between, test.within, test.p


def _effects(compared: Sequence[ComparedFigure]) -> Iterator[Sequence[object]]:
    for figure in compared:
        yield figure.figure, *dataclasses.astuple(figure.comparison.effect)


def _pairs(compared: Sequence[ComparedFigure]) -> Iterator[Sequence[object]]:
    for figure in compared:
        for pair in figure.comparison.pairs:
            limits = (pair.low, pair.difference, pair.high, pair.p, pair.welch_p)
            yield figure.figure, pair.first, pair.second, *limits, pair.g, pair.g_low, pair.g_high


def _scores(study: Study) -> Iterator[Sequence[object]]:
    for given in study.answers:
        yield given.subject, given.sus, given.tlx, given.weighted_tlx, *given.scales
