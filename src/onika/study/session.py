"""The part of a session that counts: one task, from *New* to the run that succeeded (§6.2.3, §E.3).

A log may hold a demonstration and the warm-up before the task, which the source took with the same program. A part
begins with the first new application after a run that completed; the last part is the task. Within it the run that
succeeded is that of the attempt which the experimenter names, else the first that completed.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from onika.study.log import LogEntry, StudyLog
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

NEW, TRY_NEW = "new_appl", "try_new_appl"
OPEN, CLOSE = "open_view", "close_view"
_FORM = "newApplication"
"""What the page calls the panel that asks how many flows a new application shall have."""
RUN, TRY_RUN = "run_appl", "try_run_appl"
END = "end_appl"
SUCCESS = "succeed_appl"
_ENDS = frozenset((END, SUCCESS, "abort_appl", "fail_appl"))
"""The first as this Onika writes it, with how it ended; the others as the thesis's did."""
COMPLETED = "completed"


@dataclass(frozen=True, slots=True)
class Attempt:
    """An attempt to run the application: when, whether it ran, when that ended, and whether it completed."""

    line: int
    at_s: float
    is_run: bool = True
    end_s: float | None = None
    is_completed: bool = False


@dataclass(frozen=True, slots=True)
class StudyTask:
    """What a subject did for the task, and the attempts among it."""

    entries: tuple[LogEntry, ...]
    attempts: tuple[Attempt, ...]
    success: Attempt | None = None
    """The attempt that counts as success."""
    later: int = 0
    """Attempts after it."""


def is_request(entry: LogEntry) -> bool:
    """Whether a new application is asked for: by a press, as the thesis's logger has it, or by a panel of the page."""
    return entry.event == TRY_NEW or (entry.event == OPEN and entry.object == _FORM)


def is_end(entry: LogEntry) -> bool:
    """Whether a run ends here."""
    return entry.event in _ENDS


def is_completion(entry: LogEntry) -> bool:
    """Whether a run has ended well here."""
    return entry.event == SUCCESS or (entry.event == END and entry.associated == COMPLETED)


def task_of(log: StudyLog, succeeded: int | None = None) -> tuple[StudyTask, tuple[Fault, ...]]:
    """The task of a log, and what is to be known of it.

    succeeded  the attempt that assembled the structure, 1 the first; 0 none did; None: nobody has said
    """
    parts = [*_parts(log.entries)]
    part = parts[-1] if parts else ()
    attempts = [*attempts_of(part)]
    success = _success(attempts, succeeded)
    faults = [*_faults(log, parts, attempts, succeeded)]
    if success is None:
        return StudyTask(part, tuple(attempts)), tuple(faults)
    counted = tuple(attempt for attempt in attempts if attempt.at_s <= success.at_s)
    entries = _until(part, success)
    return StudyTask(entries, counted, success, len(attempts) - len(counted)), tuple(faults)


def attempts_of(entries: Sequence[LogEntry]) -> Iterator[Attempt]:
    """The attempts to run, in their order."""
    going: LogEntry | None = None
    for index, entry in enumerate(entries):
        if entry.event == TRY_RUN and not _leads_to_run(entries, index):
            yield Attempt(entry.line, entry.at_s, is_run=False)
        elif entry.event == RUN:
            if going is not None:
                yield Attempt(going.line, going.at_s)
            going = entry
        elif is_end(entry) and going is not None:
            yield Attempt(going.line, going.at_s, True, entry.at_s, is_completion(entry))
            going = None
    if going is not None:
        yield Attempt(going.line, going.at_s)


def _leads_to_run(entries: Sequence[LogEntry], index: int) -> bool:
    """Whether this is the press of a button that the thesis's logger wrote down before what came of it."""
    if index + 1 == len(entries) or entries[index + 1].event != RUN:
        return False
    return entries[index + 1].at_s - entries[index].at_s <= 1.0 and not entries[index].has_fraction


def _parts(entries: Sequence[LogEntry]) -> Iterator[tuple[LogEntry, ...]]:
    """The parts of a log; what is before the first new application belongs to none, where there is one."""
    news = [index for index, entry in enumerate(entries) if _is_new(entries, index)]
    if not news:
        yield tuple(entries)
        return
    begins = [news[0]]
    for new in news[1:]:
        if any(is_completion(entry) for entry in entries[begins[-1] : new]):
            begins.append(new)
    for begin, end in zip(begins, [*begins[1:], len(entries)], strict=True):
        yield tuple(entries[begin:end])


def _is_new(entries: Sequence[LogEntry], index: int) -> bool:
    """Whether a new application is asked for: of request and answer the request counts, where there is one."""
    entry = entries[index]
    if entry.event == TRY_NEW:
        return True
    if is_request(entry):
        later = (entries[at] for at in range(index + 1, len(entries)))
        return next((after.event for after in later if _ends_request(after)), "") == NEW
    return entry.event == NEW and not _is_requested(entries, index)


def _is_requested(entries: Sequence[LogEntry], index: int) -> bool:
    """Whether a request stands before this new application, and nothing between them has ended it."""
    earlier = (entries[at] for at in range(index - 1, -1, -1))
    before = next((entry for entry in earlier if _ends_request(entry)), None)
    return before is not None and is_request(before)


def _ends_request(entry: LogEntry) -> bool:
    return entry.event == CLOSE or _begins_task(entry)


def _success(attempts: Sequence[Attempt], succeeded: int | None) -> Attempt | None:
    if succeeded is not None:
        return next((attempt for number, attempt in enumerate(attempts, 1) if number == succeeded), None)
    return next((attempt for attempt in attempts if attempt.is_completed), None)


def _begins_task(entry: LogEntry) -> bool:
    return entry.event == NEW or is_request(entry)


def _until(part: Sequence[LogEntry], success: Attempt) -> tuple[LogEntry, ...]:
    """The entries up to the end of the run that succeeded; to its beginning where its end is not known."""
    begun = next(i for i, entry in enumerate(part) if (entry.line, entry.at_s) == (success.line, success.at_s))
    ends = [i for i in range(begun, len(part)) if is_end(part[i]) and part[i].at_s == success.end_s]
    return tuple(part[: (ends[0] if ends else begun) + 1])


def _faults(
    log: StudyLog, parts: Sequence[Sequence[LogEntry]], attempts: Sequence[Attempt], succeeded: int | None
) -> Iterator[Fault]:
    entries = parts[-1] if parts else ()
    if not entries:
        return
    place = Place(log.name, entries[0].line)
    if not _begins_task(entries[0]):
        yield Fault(place, Reason.of("study.no_new"), Reason.of("study.counts_from_first"))
    if len(parts) > 1:
        before = Reason.of("study.parts_before", count=len(parts) - 1)
        yield Fault(place, before, Reason.of("study.counts_last"), is_note=True)
    if succeeded is not None and succeeded > len(attempts):
        there = Reason.of("study.no_such_attempt", number=succeeded, count=len(attempts))
        yield Fault(place, there, Reason.of("study.counts_as_none"))
    for attempt in attempts:
        if attempt.is_run and attempt.end_s is None:
            yield Fault(
                Place(log.name, attempt.line), Reason.of("study.run_without_end"), Reason.of("study.not_run_time")
            )
    completed = sum(attempt.is_completed for attempt in attempts)
    if succeeded is None and completed > 1:
        first = next(attempt for attempt in attempts if attempt.is_completed)
        several = Reason.of("study.several_completed", count=completed)
        yield Fault(Place(log.name, first.line), several, Reason.of("study.first_counts"), is_note=True)
    yield from _loose_ends(log, entries)


def _loose_ends(log: StudyLog, entries: Sequence[LogEntry]) -> Iterator[Fault]:
    """Ends of runs that have not begun."""
    is_going = False
    for entry in entries:
        if entry.event == RUN:
            is_going = True
        elif is_end(entry):
            if not is_going:
                place = Place(log.name, entry.line)
                yield Fault(place, Reason.of("study.end_without_run"), Reason.of("study.line_left_out"))
            is_going = False
