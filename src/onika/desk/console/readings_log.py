"""Writes a log of the current readings: one file, whole or not at all (requirement A12).

Lines that begin with `#` say when and what; the others are those of `readings_text`.
"""

from datetime import datetime
from pathlib import Path

from onika.desk.console.inspection import refused
from onika.desk.console.session import ConsoleSession, Faults
from onika.desk.run.readings_text import HEADER, rows
from onika.files import whole
from onika.wire import live
from onika.words.fault import Refusal
from onika.words.reason import Reason

Words = tuple[str, ...]


def log(session: ConsoleSession, words: Words) -> Faults:
    """Write the present readings of all subsystems, or of those named, to a file; an old one is replaced."""
    path = Path(words[0]).expanduser()
    subsystems = words[1:] or tuple(subsystem.name for subsystem in session.look_again().subsystems)
    lines: list[str] = []
    for subsystem in subsystems:
        answer = session.ask(live.Read(subsystem))
        if not isinstance(answer, live.Values):
            return refused(session, Reason.of("console.variables_of", subsystem=subsystem), answer)
        lines += rows(subsystem, answer)
    moment = datetime.now().astimezone().isoformat(timespec="seconds")
    head = f"# {session.in_words(Reason.of('console.readings_at', moment=moment))}\n{HEADER}"
    written = whole.write(path, head + "".join(line + "\n" for line in lines), whole.ANYTHING)
    if isinstance(written, Refusal):
        return session.no(Reason.of("console.unwritable", reason=written.sentence), Reason.of("desk.nothing_written"))
    session.say(Reason.of("console.variables_logged", path=str(path), count=len(lines)))
    return ()
