"""A log of what a subject did: the seven columns of §E.2, as this Onika or that of the thesis wrote them (H02).

What can be read is read. A line that cannot be is left out with its number, and so are the fewest lines without which
the times of all others never go back: a log that was edited or mixed has some.
"""

from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from onika.files.state import session_log
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

COLUMNS = 7
_TITLES = ("time", "event")
_OF_NOBODY = frozenset(("runtime_event", "runtime_reply", "runtime_lost", "file_changed"))
"""What a log has for the replay of a session: no subject did it."""
_SHOWN = 10
"""Lines of one kind that are told one by one; of more only the number is."""
_LONGEST = 40
_LATEST_S = 1e11
"""A time beyond it is none: seconds since 1970, thousands of years."""


@dataclass(frozen=True, slots=True)
class LogEntry:
    """A line: its number, its time in seconds since 1970, and six words."""

    line: int
    at_s: float
    event: str
    object: str = "none"
    id: str = "0"
    associated: str = "none"
    associated_id: str = "0"
    window: str = "root"
    has_fraction: bool = True
    """Whether its time is written with parts of a second, as this Onika does and that of the thesis did not."""


@dataclass(frozen=True, slots=True)
class StudyLog:
    """The entries of a log in their order."""

    name: str
    entries: tuple[LogEntry, ...] = ()

    @property
    def is_in_seconds(self) -> bool:
        """Whether times are whole seconds, as the thesis's logger wrote them."""
        return not any(entry.has_fraction for entry in self.entries)


def elapsed_s(begin_s: float, end_s: float) -> float:
    """Seconds from one time to another; times since 1970 are exact to a quarter of a microsecond only."""
    return round(end_s - begin_s, 6)


def read(text: str, name: str) -> tuple[StudyLog, tuple[Fault, ...]]:
    """The log of a text, and what of it cannot be read."""
    entries, faults = _of_session(text, name) if _has_records(text) else _of_columns(text, name)
    kept = _in_order(entries)
    numbers = {entry.line for entry in kept}
    faults += [_stray(name, entry) for entry in entries if entry.line not in numbers]
    log = StudyLog(name, tuple(entry for entry in kept if entry.event not in _OF_NOBODY))
    return log, tuple(_bounded(faults, name))


def _has_records(text: str) -> bool:
    """Whether lines have, behind the seven columns, what tells whether they are as they were written."""
    return any(line.count("\t") > COLUMNS for line in text.split("\n") if not _is_head(line))


def _of_session(text: str, name: str) -> tuple[list[LogEntry], list[Fault]]:
    """The entries of a log that says of each line whether it was changed, whose it is and what lacks."""
    lines, wrong = session_log.read(text, name)
    entries = [_of_line(line) for line in sorted(lines, key=lambda line: line.number)]
    return entries, [fault for fault in wrong if not _is_later_part(fault)]


def _of_line(line: session_log.LogLine) -> LogEntry:
    things = (line.object, line.id, line.associated, line.associated_id)
    return LogEntry(line.number, line.at_s, line.event, *things, line.window)


def _is_later_part(fault: Fault) -> bool:
    """Whether only the beginning of the session lacks, which another file has, or else `doubts` tells."""
    return fault.reason.key == "replay.lines_lack" and fault.reason.args["first"] == 0


def _of_columns(text: str, name: str) -> tuple[list[LogEntry], list[Fault]]:
    """The entries of a log of seven columns."""
    entries: list[LogEntry] = []
    faults: list[Fault] = []
    for number, line in enumerate(text.split("\n"), start=1):
        if not line.strip() or _is_head(line):
            continue
        entry = _entry(number, line.rstrip("\r"))
        if isinstance(entry, Reason):
            faults.append(Fault(Place(name, number), entry, Reason.of("study.line_left_out")))
        else:
            entries.append(entry)
    return entries, faults


def doubts(logs: Sequence[StudyLog]) -> Iterator[Fault]:
    """What makes doubtful whether logs, one behind the other, are one session and whole."""
    every = [(log.name, entry) for log in logs for entry in log.entries]
    for name, entry in [(name, entry) for name, entry in every if entry.event == "Start_Onika"][1:]:
        place = Place(name, entry.line)
        yield Fault(place, Reason.of("study.second_session"), Reason.of("study.break_between"), is_note=True)
    if not every or all(log.is_in_seconds for log in logs):
        return  # the logger of the thesis wrote down no end
    (first, begin), (last, end) = every[0], every[-1]
    if begin.event != "Start_Onika":
        yield Fault(Place(first, begin.line), Reason.of("study.no_start"), Reason.of("study.read_as_is"))
    if end.event != "Quit_Onika":
        yield Fault(Place(last, end.line), Reason.of("study.no_end"), Reason.of("study.read_as_is"))


def _is_head(line: str) -> bool:
    return tuple(line.lower().split()[:2]) == _TITLES


def _entry(number: int, line: str) -> LogEntry | Reason:
    """The entry of a line, or what is wrong with it."""
    words = line.split("\t")
    if len(words) == 1:
        words = line.split()
    if len(words) != COLUMNS:
        return Reason.of("study.columns", count=len(words), columns=COLUMNS)
    at_s = _seconds(words[0])
    if at_s is None:
        return Reason.of("study.no_time", text=words[0][:_LONGEST])
    event, thing, thing_id, associated, associated_id, window = (word.strip() for word in words[1:])
    has_fraction = "." in words[0] or "," in words[0]
    return LogEntry(number, at_s, event, thing, thing_id, associated, associated_id, window, has_fraction)


def _seconds(word: str) -> float | None:
    try:
        seconds = float(word.replace(",", "."))  # a spreadsheet of another country has a decimal comma
    except ValueError:
        return None
    if not 0.0 <= seconds < _LATEST_S:  # as is said of what is no number, too
        return None
    return seconds


def _in_order(entries: Sequence[LogEntry]) -> list[LogEntry]:
    """The longest row of entries whose times never go back."""
    ends: list[float] = []
    """The least time with which a row of this length ends, and"""
    at: list[int] = []
    """which entry that is."""
    before: list[int] = []
    for index, entry in enumerate(entries):
        length = bisect_right(ends, entry.at_s)
        before.append(at[length - 1] if length else -1)
        if length == len(ends):
            ends.append(entry.at_s)
            at.append(index)
        else:
            ends[length], at[length] = entry.at_s, index
    row: list[LogEntry] = []
    index = at[-1] if at else -1
    while index >= 0:
        row.append(entries[index])
        index = before[index]
    return row[::-1]


def _stray(name: str, entry: LogEntry) -> Fault:
    return Fault(
        Place(name, entry.line), Reason.of("study.time_goes_back", at=entry.at_s), Reason.of("study.line_left_out")
    )


def _bounded(faults: Sequence[Fault], name: str) -> Iterator[Fault]:
    """The faults, but of very many of one kind only the first and how many more there are."""
    kinds: dict[str, list[Fault]] = {}
    for fault in faults:
        kinds.setdefault(fault.reason.key, []).append(fault)
    for kind in kinds.values():
        yield from kind[:_SHOWN]
        if len(kind) > _SHOWN:
            more = Reason.of("study.more_lines", count=len(kind) - _SHOWN)
            yield Fault(Place(name, kind[_SHOWN].place.line), more, kind[_SHOWN].instead)
