"""A subject of a study: its group, its log with what that comes to, or figures from a table (H02)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

from onika.study.log import LogEntry, StudyLog, doubts
from onika.study.measure_names import COMPARED
from onika.study.measures import IconSelection, TaskMeasures, measure
from onika.study.session import StudyTask, task_of
from onika.study.table import SubjectRow
from onika.words.fault import Fault, Place
from onika.words.reason import NOTHING, Reason

EVERYBODY = "all"
"""The group where nobody has said who is in which."""


@dataclass(frozen=True, slots=True)
class Subject:
    """What is known of a subject."""

    name: str
    group: str = EVERYBODY
    removed: str = ""
    """Why it is left out of comparisons, in the words of whoever left it out."""
    unfit: Reason = NOTHING
    """Why it cannot be compared."""
    is_doubtful: bool = False
    """Whether something of its log could not be read, or is not as it should be."""
    task: StudyTask | None = None
    measures: TaskMeasures | None = None
    selections: tuple[IconSelection, ...] = ()
    figures: Mapping[str, float] = field(default_factory=dict)
    """What is compared, by name; no figure where there is none."""

    @property
    def is_compared(self) -> bool:
        """Whether its figures count in comparisons."""
        return not self.removed and not self.unfit


def from_log(name: str, logs: Sequence[StudyLog], row: SubjectRow | None) -> tuple[Subject, tuple[Fault, ...]]:
    """A subject by its logs, in any order, and its row in the table of subjects."""
    ordered = sorted((log for log in logs if log.entries), key=lambda log: log.entries[0].at_s)
    faults = [*_overlaps(ordered), *doubts(ordered)]
    entries = tuple(entry for log in ordered for entry in log.entries)
    source = ordered[0].name if ordered else name
    task, of_task = task_of(StudyLog(source, _forward(entries)), _succeeded(row))
    faults += of_task
    measures, selections = measure(task)
    figures = {figure: float(getattr(measures, figure)) for figure in COMPARED}
    subject = replace(_named(name, row), task=task, measures=measures, selections=selections, figures=figures)
    if not entries:
        subject = replace(subject, unfit=Reason.of("study.empty_log"))
        empty = Place(logs[0].name if logs else name)
        faults.append(Fault(empty, subject.unfit, Reason.of("study.not_counted")))
    elif not task.success:
        # What was selected was selected; how long the task would have taken nobody knows.
        faults.append(
            Fault(Place(source), Reason.of("study.no_success"), Reason.of("study.without_times"), is_note=True)
        )
    return subject, tuple(faults)


def from_results(row: SubjectRow, of_subject: SubjectRow | None, file: str) -> tuple[Subject, tuple[Fault, ...]]:
    """A subject by a row of a table of results."""
    subject = _named(row.subject, of_subject)
    if group := row.cells.get("group"):
        subject = replace(subject, group=group)
    figures: dict[str, float] = {}
    faults: list[Fault] = []
    for figure in COMPARED:
        number = row.number(figure)
        if number is not None and number >= 0.0:
            figures[figure] = number
        elif figure in row.cells:
            reason = Reason.of("study.no_number", column=figure, text=row.cells[figure][:60])
            faults.append(Fault(Place(file, row.line), reason, Reason.of("study.cell_left_out")))
    return replace(subject, figures=figures), tuple(faults)


def _named(name: str, row: SubjectRow | None) -> Subject:
    if row is None:
        return Subject(name)
    return Subject(name, row.cells.get("group", EVERYBODY), row.cells.get("removed", ""))


def _succeeded(row: SubjectRow | None) -> int | None:
    """The attempt of which the experimenter says that it succeeded."""
    number = row.number("succeeded") if row else None
    return int(number) if number is not None and number >= 0 and number.is_integer() else None


def _overlaps(logs: Sequence[StudyLog]) -> list[Fault]:
    """Logs of one subject that go on at the same time: one of them is somebody else's."""
    return [
        Fault(
            Place(later.name, later.entries[0].line),
            Reason.of("study.overlap", other=log.name),
            Reason.of("study.mixed"),
        )
        for log, later in pairwise(logs)
        if later.entries[0].at_s < log.entries[-1].at_s
    ]


def _forward(entries: tuple[LogEntry, ...]) -> tuple[LogEntry, ...]:
    return tuple(sorted(entries, key=lambda entry: entry.at_s))
