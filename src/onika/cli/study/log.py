"""`onika study log`: the diary of a session as one file, handed over by whom it is about (requirements H01, H08)."""

import argparse
import os
import re
import sys
from collections.abc import Sequence
from pathlib import Path

from onika.cli.language import say
from onika.files import text, whole
from onika.files.state import session_log
from onika.files.state.state_directory import state_directory
from onika.words.fault import Refusal
from onika.words.reason import Reason


def purpose() -> Reason:
    """What the verb is for."""
    return Reason.of("replay.purpose_log")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the verb takes."""
    parser.add_argument(
        "session", nargs="?", default="", metavar="SESSION", help=say(Reason.of("replay.option_session"))
    )
    parser.add_argument("-o", dest="out", type=Path, metavar="FILE", help=say(Reason.of("replay.option_out")))
    parser.add_argument("--overwrite", action="store_true", help=say(Reason.of("replay.option_overwrite")))


def carry_out(given: argparse.Namespace) -> int:
    """Write the file, or list the sessions where none is asked for; 1 where it could not be written."""
    sessions = _sessions(state_directory(os.environ) / "diary")
    if given.out is None:
        return _listed(sessions)
    wanted = given.session or next(reversed(sessions), "")
    parts = sessions.get(wanted, [])
    if not parts:
        return _failed(Reason.of("replay.no_session", name=wanted))
    content = _joined(parts)
    mark = whole.ANYTHING if given.overwrite else whole.ABSENT
    outcome = whole.write(given.out, content, mark)
    if isinstance(outcome, Refusal):
        return _failed(outcome.sentence)
    lines, faults = session_log.read(content, given.out.name)
    for fault in faults:
        print(say(fault.sentence), file=sys.stderr)
    print(say(Reason.of("replay.handed_over", path=str(given.out), count=len(lines), session=wanted)))
    return 0


def _sessions(folder: Path) -> dict[str, list[Path]]:
    """The files of each session, by its name, oldest first."""
    sessions: dict[str, list[tuple[int, Path]]] = {}
    for path in folder.glob("*.log"):
        name, number = _part_of(path, folder)
        sessions.setdefault(name, []).append((number, path))
    return {name: [path for _, path in sorted(sessions[name])] for name in sorted(sessions)}


def _part_of(path: Path, folder: Path) -> tuple[str, int]:
    """Its session and its number: `NAME-2.log` goes on where `NAME.log` is."""
    match = re.fullmatch(r"(.+)-(\d{1,4})", path.stem)
    if match is not None and (folder / f"{match[1]}.log").is_file():
        return match[1], int(match[2])
    return path.stem, 1


def _joined(parts: Sequence[Path]) -> str:
    """The text of a session; raises OSError for what cannot be read."""
    texts = [text.load(path, str(path))[0] or "" for path in parts]
    first, *rest = texts
    return "".join([first, *(part.removeprefix(session_log.HEADER + "\n") for part in rest)])


def _listed(sessions: dict[str, list[Path]]) -> int:
    for name, parts in sessions.items():
        size = sum(path.stat().st_size for path in parts)
        print(say(Reason.of("replay.session_listed", name=name, size=size)))
    if not sessions:
        print(say(Reason.of("replay.no_diary")))
    return 0


def _failed(reason: Reason) -> int:
    print(say(reason), file=sys.stderr)
    return 1
