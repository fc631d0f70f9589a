"""The diary: a line of every meaningful act, refused ones too, written beside what happens (requirement H01)."""

import os
import threading
import time
from collections.abc import Callable
from pathlib import Path
from queue import SimpleQueue

from onika.desk.environment.application_entry import ApplicationNames
from onika.desk.environment.diary_entry import HEADER, DiaryEntry, entry
from onika.desk.environment.environment import ActAnswer
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.state.model import Model
from onika.files.state_directory import make_own
from onika.wire import act, page
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason


def note(model: Model, _asked: act.Note, _outside: Services) -> Done:
    """What the page alone knows of is for the diary, and changes nothing."""
    return Done(model)


class Diary:
    """An observer of an environment; lines are written in a thread, so that no disk keeps an act waiting.

    folder  where the file of this session is made
    model   what is open now: whether a diary is wanted, and what documents are called
    say     shows everybody a line; once, where the diary cannot be written
    clock   seconds since 1970
    """

    def __init__(
        self,
        folder: Path,
        model: Callable[[], Model],
        say: Callable[[page.Say], None],
        clock: Callable[[], float] = time.time,
    ) -> None:
        self._model = model
        self._say = say
        self._clock = clock
        self._names = ApplicationNames()
        self._lines: SimpleQueue[str | None] = SimpleQueue()
        self._wrong = NOTHING
        """Why nothing can be written any more."""
        self._is_told = False
        self.path = folder / time.strftime(f"%Y-%m-%dT%H-%M-%S-{os.getpid()}.log", time.localtime(clock()))
        self._thread = threading.Thread(target=self._write, daemon=True)
        self._thread.start()
        self._put(DiaryEntry("Start_Onika"))

    def observe(self, command: act.AnyAct, _by: str, answer: ActAnswer) -> None:
        """An act has been answered."""
        if self._wrong and not self._is_told:
            self._is_told = True
            self._say(page.Say("warning", self._wrong))
        model = self._model()
        self._names.known |= {document.id: document.name for document in model.documents.values()}
        opened = answer.value if isinstance(answer.value, str) else ""
        self._names.look(model, (getattr(command, "doc", ""), opened))
        line = entry(command, answer, self._names.known)
        if line is not None:
            self._put(line)

    def close(self, timeout_s: float = 1.0) -> None:
        """Write what is still to be written."""
        self._put(DiaryEntry("Quit_Onika"))
        self._lines.put(None)
        self._thread.join(timeout_s)

    def _put(self, line: DiaryEntry) -> None:
        if self._model().settings.keeps_diary:
            self._lines.put(line.line(self._clock()))

    def _write(self) -> None:
        """Write line after line; after the first error none any more."""
        line = self._lines.get()
        if line is None:
            return
        try:
            make_own(self.path.parent)
            with self.path.open("a", encoding="utf-8", errors="replace") as file:
                file.write(HEADER + "\n")
                while line is not None:
                    file.write(line + "\n")
                    file.flush()
                    line = self._lines.get()
        except OSError as error:
            self._wrong = Reason.of("run.diary_unwritten", path=str(self.path), why=system_reason(error))
