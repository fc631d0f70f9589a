"""The diary: a line of every meaningful act, refused ones too, and of every run's end (requirement H01)."""

import os
import secrets
import threading
import time
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from pathlib import Path
from queue import SimpleQueue
from types import MappingProxyType
from typing import Any

import msgspec
from msgspec import Struct

from onika.desk.environment.application_entry import ApplicationNames
from onika.desk.environment.diary_entry import DiaryEntry, end_of, entries, is_of_user
from onika.desk.environment.diary_record import LARGEST, DiaryRecord
from onika.desk.environment.environment import ActAnswer
from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.session_start import SessionStart
from onika.desk.environment.state.model import Model
from onika.files import text
from onika.files.state import session_log
from onika.files.state.state_directory import make_own
from onika.wire import act, page
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason

KEPT = 200
"""Files of sessions that are kept; with one more the oldest goes."""
NOWHERE = SessionStart()
NO_RECORD: Mapping[str, Any] = MappingProxyType({})
LIMIT = 4 * 1024 * 1024
"""Bytes of a file before the session goes on in a next one."""


def note(model: Model, _asked: act.Note, _outside: Services) -> Done:
    """What the page alone knows of is for the diary, and changes nothing."""
    return Done(model)


def no_replay(_model: Model, _command: act.SteerReplay, _outside: Services) -> No:
    """Only where a session is replayed it can be steered."""
    return No(Reason.of("replay.none_here"))


class Diary:
    """An observer of an environment; lines are written in a thread, so that no disk keeps an act waiting.

    folder  where the file of this session is made
    model   what is open now: whether a diary is wanted, and what documents are called
    say     shows everybody a line; once, where the diary cannot be written
    clock   seconds since 1970
    start   with what the session begins, for the first line
    limit   bytes of a file, and
    kept    files that are kept of all sessions, so that the folder never outgrows the two multiplied
    """

    def __init__(
        self,
        folder: Path,
        model: Callable[[], Model],
        say: Callable[[page.Say], None],
        clock: Callable[[], float] = time.time,
        start: SessionStart = NOWHERE,
        limit: int = LIMIT,
        kept: int = KEPT,
    ) -> None:
        self._limit, self._kept = limit, kept
        self._model = model
        self._say = say
        self._clock = clock
        self._names = ApplicationNames()
        self._record = DiaryRecord(secrets.token_hex(4), start.places, start.home)
        self._placed = 0
        """Places in the session that are given away: an act has its place when it begins, its line when it ends."""
        self._lines: SimpleQueue[str | None] = SimpleQueue()
        self._wrong = NOTHING
        """Why nothing can be written any more."""
        self._is_told = False
        self.path = folder / time.strftime(f"%Y-%m-%dT%H-%M-%S-{os.getpid()}.log", time.localtime(clock()))
        self._thread = threading.Thread(target=self._write, daemon=True)
        self._thread.start()
        self._put(DiaryEntry("Start_Onika"), {"start": start.facts(model())})

    def observe(self, command: act.AnyAct, by: str) -> Callable[[ActAnswer], None]:
        """An act begins; what is returned is told how it was answered."""
        return partial(self._answered, command, by, self._place() if is_of_user(command) else 0)

    def hear(self, station: str, request: str, message: Struct) -> None:
        """A runtime has told something, or replied to a request of this kind."""
        content = self._record.of_message(station, request, message)
        if content is not None:
            event = ("runtime_event", "runtime_reply")[bool(request)]
            self._put(DiaryEntry(event, type(message).__name__, request, station), content)

    def follow(self, before: Model, after: Model) -> None:
        """What is open has changed: runs that came to their end are written down, and runtimes that were lost."""
        for name, runtime in after.every_station.items():
            if runtime.state == "lost" and before.runtime_at(name).state != "lost":
                content = {"lost": msgspec.to_builtins(runtime.text), "station": name}
                self._put(DiaryEntry("runtime_lost", runtime.text.key, name), content)
        if before.run is after.run and before.beside is after.beside:
            return
        going = {run.view.number for run in before.going}
        for run in after.every_run:
            if run.is_over and run.view.number in going:
                self._put(end_of(run))

    def look(self, changed: Iterable[Path]) -> None:
        """Others have written or removed these files: what stands there now is needed to rebuild what follows."""
        for path in sorted(changed):
            content, _ = text.load(path, str(path))
            is_kept = content is not None and len(content) <= LARGEST
            record = {"file": str(path), **({"text": content} if is_kept else {}), "is_there": path.exists()}
            self._put(DiaryEntry("file_changed", path.name, str(path)), record)

    def close(self, timeout_s: float = 1.0) -> None:
        """Write what is still to be written."""
        self._put(DiaryEntry("Quit_Onika"))
        self._lines.put(None)
        self._thread.join(timeout_s)

    def _answered(self, command: act.AnyAct, by: str, place: int, answer: ActAnswer) -> None:
        if self._wrong and not self._is_told:
            self._is_told = True
            self._say(page.Say("warning", self._wrong))
        model = self._model()
        self._names.names |= {document.id: document.name for document in model.documents.values()}
        opened = answer.value if isinstance(answer.value, str) else ""
        self._names.look(model, (getattr(command, "doc", ""), opened))
        first, *rest = entries(command, answer, self._names.names) or (None,)
        if first is None:
            return
        record = {} if isinstance(command, act.Note) else self._record.of_act(command, by, answer)
        self._put(first, record, place)
        for line in rest:
            self._put(line)

    def _place(self) -> int:
        self._placed += 1
        return self._placed - 1

    def _put(self, line: DiaryEntry, record: Mapping[str, Any] = NO_RECORD, place: int | None = None) -> None:
        place = self._place() if place is None else place
        if self._model().settings.keeps_diary:
            columns = [self._record.nameless(column) for column in line.columns(self._clock())]
            self._lines.put(session_log.line(columns, self._record.text(place, record)))

    def _write(self) -> None:
        """Write line after line; after the first error none any more."""
        line = self._lines.get()
        if line is None:
            return
        first = self.path
        try:
            make_own(self.path.parent)
            line, number = self._fill(line), 1
            while line is not None:
                number += 1
                self.path = first.with_name(f"{first.stem}-{number}.log")
                line = self._fill(line)
        except OSError as error:
            self._wrong = Reason.of("run.diary_unwritten", path=str(self.path), why=system_reason(error))

    def _fill(self, line: str | None) -> str | None:
        """Write a file until it is full; the line that belongs into the next one, None at the end."""
        descriptor = os.open(self.path, os.O_WRONLY | os.O_APPEND | os.O_CREAT | os.O_CLOEXEC, 0o600)
        with os.fdopen(descriptor, "a", encoding="utf-8", errors="replace") as file:
            _throw_away(self.path.parent, self._kept)
            file.write(session_log.HEADER + "\n")
            while line is not None and file.tell() < self._limit:
                file.write(line + "\n")
                file.flush()
                line = self._lines.get()
        return line


def _throw_away(folder: Path, kept: int) -> None:
    """The oldest sessions go; names begin with the moment at which a session began."""
    for path in sorted(folder.glob("*.log"))[:-kept]:
        path.unlink(missing_ok=True)
