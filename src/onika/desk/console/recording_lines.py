"""The console command `record`: a subsystem that is held by hand is recorded into a file, or no more (X05)."""

from pathlib import Path

from onika.desk.console.session import ConsoleSession, Faults
from onika.wire import live
from onika.words.reason import Reason

Words = tuple[str, ...]
OFF = "off"


def record(session: ConsoleSession, words: Words) -> Faults:
    """Begin the recording of a subsystem, the chosen one where none is named, or end it; a file is not replaced."""
    subsystem, place = (session.subsystem, words[0]) if len(words) == 1 else words
    if place == OFF:
        return _asked(session, live.Record(subsystem))
    path = Path(place).expanduser().absolute()
    if _is_there(path):
        return session.no(Reason.of("console.recording_exists", path=str(path)))
    return _asked(session, live.Record(subsystem, str(path)))


def _is_there(path: Path) -> bool:
    """Whether a file has this name; what is no name the runtime refuses."""
    try:
        return path.exists()
    except (OSError, ValueError):
        return False


def _asked(session: ConsoleSession, message: live.Record) -> Faults:
    faults = session.order(message)
    session.hear()
    return faults
