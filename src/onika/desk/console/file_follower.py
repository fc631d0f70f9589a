"""Follows the code files of tasks: when one changes, the task's code is exchanged (requirements A14, X15)."""

from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path

from onika.desk.console.display import Tone
from onika.desk.console.session import ConsoleSession, Faults
from onika.desk.console.task_lines import missing
from onika.desk.console.tuning_lines import code_file, exchange
from onika.words.fault import Place
from onika.words.reason import Reason

Words = tuple[str, ...]
_PERIOD_S = 1.0
_TRIES = 5


@dataclass(slots=True)
class _FileStamp:
    """What a file was like when it was last looked at."""

    path: Path
    time_ns: int
    digest: str
    tries: int = 0
    """How often this content was refused by the runtime, without anything being wrong with it."""


class FileFollower:
    """The code files that are followed; each is looked at once a second: first at its time, then at its content."""

    def __init__(self) -> None:
        self._files: dict[tuple[str, str], _FileStamp] = {}
        self._due_s = 0.0

    def command(self, session: ConsoleSession, words: Words) -> Faults:
        """`follow TASK [FILE]`; `follow off [TASK]` ends it; without words it says what is followed."""
        if not words:
            self._say_followed(session)
            return ()
        if words[0] == "off":
            gone = {session.address(word) for word in words[1:]} or set(self._files)
            self._files = {address: file for address, file in self._files.items() if address not in gone}
            return ()
        subsystem, name = session.address(words[0])
        faults = missing(session, subsystem, (name,))
        if faults:
            return faults
        path = Path(words[1]) if len(words) > 1 else code_file(session, subsystem, name)
        if path is None:
            return session.no(Reason.of("console.code_file_unknown", word=words[0]))
        look = _look(path)
        if look is None:
            return session.no(Reason.of("console.code_file_missing", path=str(path)))
        self._files[subsystem, name] = look
        session.say(Reason.of("console.follows", task=f"{subsystem}/{name}", path=str(path)), Tone.DIM)
        return ()

    def _say_followed(self, session: ConsoleSession) -> None:
        for (subsystem, name), file in self._files.items():
            session.say(Reason.of("console.follows", task=f"{subsystem}/{name}", path=str(file.path)))
        if not self._files:
            session.say(Reason.of("console.nothing_followed"), Tone.DIM)

    def tick(self, session: ConsoleSession) -> None:
        """Exchange what has changed, when it is time to look."""
        if not self._files or session.clock() < self._due_s:
            return
        self._due_s = session.clock() + _PERIOD_S
        for (subsystem, name), file in list(self._files.items()):
            if name not in session.tasks(subsystem):
                del self._files[subsystem, name]
                session.say(Reason.of("console.no_more_followed", task=f"{subsystem}/{name}"), Tone.NOTE)
            elif _has_changed(file) or 0 < file.tries < _TRIES:
                self._exchange(session, subsystem, name, file)

    def _exchange(self, session: ConsoleSession, subsystem: str, name: str, file: _FileStamp) -> None:
        former, session.place = session.place, Place(str(file.path))
        try:
            faults = exchange(session, subsystem, name, file.path)
        finally:
            session.place = former
        is_refused = bool(faults) and all(fault.place == Place(str(file.path)) for fault in faults)
        file.tries = file.tries + 1 if is_refused else 0
        for fault in faults:
            session.say(fault.sentence, Tone.FAULT)
        if is_refused and file.tries < _TRIES:
            session.say(Reason.of("console.old_code_for_now", task=f"{subsystem}/{name}"), Tone.NOTE)
        elif faults:
            session.say(Reason.of("console.old_code", task=f"{subsystem}/{name}"), Tone.NOTE)
        else:
            session.say(Reason.of("console.new_code", task=f"{subsystem}/{name}", path=str(file.path)), Tone.GOOD)


def _look(path: Path) -> _FileStamp | None:
    try:
        return _FileStamp(path, path.stat().st_mtime_ns, sha256(path.read_bytes()).hexdigest())
    except OSError:
        return None


def _has_changed(file: _FileStamp) -> bool:
    """Whether there is new content; a file that is just being exchanged for another is looked at next time."""
    try:
        if file.path.stat().st_mtime_ns == file.time_ns:
            return False
    except OSError:
        return False
    new = _look(file.path)
    if new is None:
        return False
    changed = new.digest != file.digest
    file.time_ns, file.digest = new.time_ns, new.digest
    if changed:
        file.tries = 0
    return changed
