"""Completes console lines: lists the words that may stand where the cursor is."""

from collections.abc import Callable, Sequence
from pathlib import Path

from onika.desk.console.command import Command, find
from onika.desk.console.session import ConsoleSession
from onika.desk.console.site_library import SiteLibrary
from onika.desk.console.steering_lines import where
from onika.model.lifecycle import State
from onika.wire import live
from onika.wire.foresight import Foreseen, Foresight, WhatIf

_FOUND = 200


class Completion:
    """Knows the commands and, from the session, tasks, variables and all else by name."""

    def __init__(self, session: ConsoleSession, commands: Sequence[Command]) -> None:
        self._session = session
        self._commands = commands

    def candidates(self, before: str) -> list[str]:
        """What the last word of the text before the cursor may become, in order; each begins with that word."""
        words = before.split()
        if not before or before[-1].isspace():
            words.append("")
        *passed, typed = words or [""]
        if before.startswith("<"):
            return _files(typed.removeprefix("<"), "<")
        if not passed:
            return sorted(command.name for command in self._commands if command.name.startswith(typed))
        return sorted({name for name in self._offered(passed, typed) if name.startswith(typed)})[:_FOUND]

    def _offered(self, passed: list[str], typed: str) -> Sequence[str]:
        matches = find(passed[0], self._commands)
        if len(matches) != 1 or not matches[0].takes:
            return ()
        takes = matches[0].takes
        kind = takes[min(len(passed) - 1, len(takes) - 1)]
        if typed.startswith("@"):
            return [f"@{name}" for base in self._session.site.directories for name in base.onikons]
        offer = _KINDS.get(kind)
        if offer is None:
            return ()
        return offer(self._session, self._commands, typed)


def _tasks(session: ConsoleSession, _commands: Sequence[Command], _typed: str) -> list[str]:
    others = [
        f"{subsystem.name}/{task.task.name}"
        for subsystem in session.standing().subsystems
        if subsystem.name != session.subsystem
        for task in subsystem.tasks
    ]
    return [*session.tasks(), *others]


def _asking(session: ConsoleSession, _commands: Sequence[Command], _typed: str) -> list[str]:
    return [name if home == session.subsystem else f"{home}/{name}" for home, name in session.questions]


def _variables(session: ConsoleSession, _commands: Sequence[Command], typed: str) -> list[str]:
    subsystem, slash, _ = typed.rpartition("/")
    answer = session.ask(live.Read(subsystem or session.subsystem))
    names = answer.values if isinstance(answer, live.Values) else {}
    return [f"{subsystem}{slash}{name}" for name in names]


def _foresights(session: ConsoleSession) -> tuple[Foresight, ...]:
    answer = session.ask(WhatIf())
    if isinstance(answer, Foreseen):
        return answer.foresights
    return ()


def _library(session: ConsoleSession) -> SiteLibrary:
    return SiteLibrary(session.site, session.place)


def _spawn_words(session: ConsoleSession, _commands: Sequence[Command], _typed: str) -> list[str]:
    units = [unit.name for unit in session.standing().rtpus]
    library = _library(session)
    return [*library.tasks, *library.configurations, "on", "as", "at", "of", *units]


def _files(typed: str, before: str = "") -> list[str]:
    """Files and folders that begin so; folders end with a stroke."""
    folder, slash, start = typed.rpartition("/")
    try:
        entries = sorted(Path(folder or ("/" if slash else ".")).expanduser().iterdir())
    except OSError:
        return []
    names = [
        entry.name + ("/" if entry.is_dir() else "") for entry in entries if start or not entry.name.startswith(".")
    ]
    return [f"{before}{folder}{slash}{name}" for name in names if name.startswith(start)]


_KINDS: dict[str, Callable[[ConsoleSession, Sequence[Command], str], list[str]]] = {
    "task": _tasks,
    "asking": _asking,
    "variable": _variables,
    "library": lambda session, commands, typed: ["all", *_library(session).tasks],
    "spawn_word": _spawn_words,
    "configuration": lambda session, commands, typed: list(_library(session).configurations),
    "application": lambda session, commands, typed: list(_library(session).applications),
    "subsystem": lambda session, commands, typed: [subsystem.name for subsystem in session.standing().subsystems],
    "fault": lambda session, commands, typed: [foresight.fault for foresight in _foresights(session)],
    "foreseen": lambda session, commands, typed: [foresight.subject for foresight in _foresights(session)],
    "flow": lambda session, commands, typed: [position.subsystem for position in where(session)],
    "command": lambda session, commands, typed: [command.name for command in commands],
    "again_word": lambda session, commands, typed: ["hold", *(unit.name for unit in session.standing().rtpus)],
    "rtpu_word": lambda session, commands, typed: ["add"],
    "lost_unit": lambda session, commands, typed: [unit.name for unit in session.standing().rtpus if unit.is_lost],
    "state": lambda session, commands, typed: [state.value.lower() for state in State],
    "file": lambda session, commands, typed: _files(typed),
    "world": lambda session, commands, typed: list(session.standing().worlds),
    "quit_word": lambda session, commands, typed: ["runtime"],
}
