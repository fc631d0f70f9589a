"""The folder of a study: logs, who is in which group, figures known already, questionnaires (requirement H02).

`subjects.csv`        who: subject, group; where it applies `removed`, why not compared, and `succeeded`, which attempt
`results.csv`         figures of subjects without a log: subject, group, and what is compared
`questionnaires.csv`  answers: subject, sus1 … sus10, and the six scales of NASA-TLX
`NAME.log`            the log of the subject NAME, here or in `logs/`; or several in a folder `NAME`
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from onika.files import text as texts
from onika.study import log as logs, table
from onika.study.log import StudyLog
from onika.study.questionnaire import Answers, answers_of
from onika.study.subject import Subject, from_log, from_results
from onika.study.table import SubjectRow
from onika.words.fault import Fault, Place
from onika.words.reason import Reason
from onika.words.system_error import system_reason

SUBJECTS, RESULTS, QUESTIONNAIRES = "subjects.csv", "results.csv", "questionnaires.csv"
LOGS = "logs"
ENDINGS = (".log", ".raw")


@dataclass(frozen=True, slots=True)
class Study:
    """What a folder holds; subjects in the order of their names."""

    name: str
    subjects: tuple[Subject, ...]
    answers: tuple[Answers, ...] = ()
    faults: tuple[Fault, ...] = ()


def read(folder: Path) -> Study:
    """Read all of it; what is wrong is among its faults."""
    faults: list[Fault] = []
    rows = {row.subject: row for row in _table(folder / SUBJECTS, SUBJECTS, faults)}
    has_table = (folder / SUBJECTS).exists()
    files = _of_one(_files(folder, faults), faults)
    subjects: dict[str, Subject] = {}
    for name, paths in files.items():
        if clash := _clash(folder, paths):
            faults.append(Fault(Place(clash), Reason.of("study.logs_of_one_name", subject=name), _both_out()))
            continue
        of_logs: list[Fault] = []
        subject, wrong = from_log(name, [*_logs(folder, paths, of_logs)], rows.get(name))
        of_logs += wrong
        subjects[name] = replace(subject, is_doubtful=any(not fault.is_note for fault in of_logs))
        faults += of_logs
        if has_table and name not in rows:
            faults.append(Fault(Place(SUBJECTS), Reason.of("study.not_listed", subject=name), _in_all()))
    for row in _table(folder / RESULTS, RESULTS, faults):
        if row.subject in files:
            place = Place(RESULTS, row.line)
            faults.append(Fault(place, Reason.of("study.has_log", subject=row.subject), Reason.of("study.log_counts")))
            continue
        subjects[row.subject], wrong = from_results(row, rows.get(row.subject), RESULTS)
        faults += wrong
    absent = [row for name, row in rows.items() if name not in subjects and name not in files]
    if absent:
        without = Reason.of("study.no_log", subjects=tuple(row.subject for row in absent))
        faults.append(Fault(Place(SUBJECTS, absent[0].line), without, Reason.of("study.none_counted"), is_note=True))
    answers = [
        answers_of(row, QUESTIONNAIRES, faults) for row in _table(folder / QUESTIONNAIRES, QUESTIONNAIRES, faults)
    ]
    ordered = tuple(sorted(subjects.values(), key=lambda subject: natural(subject.name)))
    return Study(folder.resolve().name, ordered, tuple(answers), tuple(faults))


def natural(name: str) -> tuple[tuple[int, int, str], ...]:
    """What sorts p2 before p10."""
    parts: list[tuple[int, int, str]] = []
    for letter in name:
        if letter.isdecimal() and parts and parts[-1][0] == 0:
            parts[-1] = (0, parts[-1][1] * 10 + int(letter), "")
        else:
            parts.append((0, int(letter), "") if letter.isdecimal() else (1, 0, letter))
    return tuple(parts)


def _table(path: Path, name: str, faults: list[Fault]) -> tuple[SubjectRow, ...]:
    if not path.exists():
        return ()
    content, wrong = texts.load(path, name)
    faults += wrong
    if content is None:
        return ()
    rows, wrong = table.read(content, name)
    faults += wrong
    return rows


def _files(folder: Path, faults: list[Fault]) -> dict[str, list[Path]]:
    """The paths of logs by the names of subjects."""
    files: dict[str, list[Path]] = {}
    for place in (folder, folder / LOGS):
        for path in _listed(place, folder, faults):
            if path.suffix in ENDINGS and path.is_file():
                files.setdefault(path.stem, []).append(path)
            elif path.is_dir() and not path.name.startswith(".") and path != folder / LOGS:
                several = [part for part in _listed(path, folder, faults) if part.suffix in ENDINGS and part.is_file()]
                if several:
                    files.setdefault(path.name, []).extend(several)
    return files


def _of_one(files: dict[str, list[Path]], faults: list[Fault]) -> dict[str, list[Path]]:
    """Without those of subjects that stand twice in the table: nobody knows of which of them they are."""
    doubled = {fault.reason.args["subject"] for fault in faults if fault.reason.key == "study.subject_twice"}
    return {name: paths for name, paths in files.items() if name not in doubled}


def _listed(place: Path, folder: Path, faults: list[Fault]) -> list[Path]:
    if not place.is_dir():
        return []
    try:
        return sorted(path for path in place.iterdir() if not path.name.startswith("."))
    except OSError as error:
        shown = place.relative_to(folder).as_posix()
        faults.append(Fault(Place(shown), system_reason(error), Reason.of("study.folder_left_out")))
        return []


def _clash(folder: Path, paths: list[Path]) -> str:
    """The logs where they are those of two subjects of one name: not all in the folder of one."""
    places = {path.parent for path in paths}
    lone = [path for path in paths if path.parent in (folder, folder / LOGS)]
    if len(paths) == 1 or (not lone and len(places) == 1):
        return ""
    return ", ".join(path.relative_to(folder).as_posix() for path in paths)


def _logs(folder: Path, paths: list[Path], faults: list[Fault]) -> Iterator[StudyLog]:
    for path in paths:
        name = path.relative_to(folder).as_posix()
        content, wrong = texts.load_bytes(path, name)
        faults += wrong
        if content is None:
            continue
        text, torn = texts.decode_foreign(content, name)
        faults += [Fault(fault.place, fault.reason, Reason.of("study.letters_replaced")) for fault in torn]
        log, wrong = logs.read(text, name)
        faults += wrong
        yield log


def _both_out() -> Reason:
    return Reason.of("study.both_left_out")


def _in_all() -> Reason:
    return Reason.of("study.in_no_group")
