"""Subjects as a part of the page: a table of all, and of each the statistics of §E.3 with its timeline (H02)."""

from collections.abc import Callable, Iterator, Sequence
from html import escape

from onika.study.measures import PAUSE_S, TaskMeasures
from onika.study.report import markup, timeline_picture
from onika.study.report.figure_names import SHORT, TITLES, title_of
from onika.study.report.icon_table import icons_of
from onika.study.subject import Subject
from onika.words.reason import Reason

Say = Callable[[Reason], str]
_LANES = {
    "selection": "study.lane_selection",
    "insertion": "study.lane_insertion",
    "deletion": "study.lane_deletion",
    "check": "study.lane_check",
    "run": "study.lane_run",
    "other": "study.lane_other",
}
_SHOWN_ICONS = 20


def overview(subjects: Sequence[Subject], say: Say) -> str:
    """All subjects below each other; those that are not compared with the reason."""
    head = [say(Reason.of(key)) for key in ("study.subject", "study.group", "study.remark")]
    head += [say(title_of(figure)) for figure in SHORT]
    rows = [(subject.name, subject.group, _remark(subject, say), *_cells(subject, say)) for subject in subjects]
    return markup.table(head, rows, [("removed", "")[subject.is_compared] for subject in subjects])


def single(subject: Subject, say: Say) -> Iterator[str]:
    """The statistics and the timeline of a subject with a log."""
    if subject.measures is None or subject.task is None or not subject.task.entries:
        return
    yield markup.heading(3, subject.name, f"subject-{subject.name}")
    names = {lane: say(Reason.of(key)) for lane, key in _LANES.items()}
    label = say(Reason.of("study.timeline_of", subject=subject.name))
    yield markup.figure(timeline_picture.drawn(subject.task.entries, names, label))
    measures = subject.measures
    rows = [(say(title_of(figure)), shown(measures, figure, say)) for figure in TITLES]
    titles = (say(Reason.of("study.figure")), say(Reason.of("study.value")))
    summary = say(Reason.of("study.statistics_of", subject=subject.name, seconds=PAUSE_S))
    yield "<details><summary>" + escape(summary) + "</summary>" + markup.table(titles, rows) + "</details>"


def icons(subjects: Sequence[Subject], say: Say) -> str:
    """How long which icon took to be selected, the slowest first."""
    keys = ("study.icon", "study.selected", "study.mean_s", "study.longest_s")
    rows = [
        (icon.name, str(icon.count), markup.number(icon.mean_s), markup.number(icon.longest_s))
        for icon in icons_of(subjects)[:_SHOWN_ICONS]
    ]
    return markup.table([say(Reason.of(key)) for key in keys], rows)


def shown(measures: TaskMeasures, figure: str, say: Say) -> str:
    """A figure as it stands in a table."""
    value = getattr(measures, figure)
    if isinstance(value, bool):
        return say(Reason.of(("study.no", "study.yes")[value]))
    return markup.number(value)


def _cells(subject: Subject, say: Say) -> list[str]:
    if subject.measures is not None:
        return [shown(subject.measures, figure, say) for figure in SHORT]
    figures = subject.figures
    return [f"{figures[figure]:g}" if figure in figures else markup.NOTHING for figure in SHORT]


def _remark(subject: Subject, say: Say) -> str:
    remarks = [subject.removed, say(subject.unfit)]
    if subject.is_doubtful:
        remarks.append(say(Reason.of("study.doubtful")))
    return "; ".join(filter(None, remarks))
