"""The console itself: carries out lines, one command each, and runs scripts of them (requirement A16)."""

from collections.abc import Sequence
from pathlib import Path

from onika.desk.console import commands
from onika.desk.console.command import Command, find
from onika.desk.console.completion import Completion
from onika.desk.console.display import Tone
from onika.desk.console.file_follower import FileFollower
from onika.desk.console.session import TYPED, ConsoleSession, Faults
from onika.desk.console.time_lines import ended
from onika.desk.console.variable_watch import VariableWatch
from onika.desk.run import script_lines
from onika.wire import request
from onika.words.fault import Place
from onika.words.reason import Reason, reason_of

Words = tuple[str, ...]
_DEEPEST = 16


class Console:
    """Lines in, faults out; what is found goes to the session's face."""

    def __init__(self, session: ConsoleSession) -> None:
        self.session = session
        self.is_over = False
        self._depth = 0
        self._watch = VariableWatch()
        self._follow = FileFollower()
        session.ticks += [lambda: self._watch.tick(session), lambda: self._follow.tick(session)]
        self._groups = self._vocabulary()
        self._commands = [command for _, group in self._groups for command in group]
        self.completion = Completion(session, self._commands)

    def carry_out(self, line: str, place: Place = TYPED) -> Faults:
        """Carry out one line; an empty one is nothing. Raises LinkLost where the runtime is gone."""
        session, former = self.session, self.session.place
        session.place = place
        try:
            return self._carry_out(script_lines.bare(line))
        except TimeoutError as late:
            return session.no(Reason.of("console.no_answer", cause=reason_of(late)), Reason.of("console.perhaps_done"))
        finally:
            session.place = former

    def answer(self, line: str) -> Faults:
        """Carry out a line while a task asks: its answer, unless it begins with the full name of a command."""
        first = line.split(None, 1)[0] if line.strip() else ""
        if not self.session.questions or any(command.name == first for command in self._commands):
            return self.carry_out(line)
        subsystem, name = next(iter(self.session.questions))
        return self.carry_out(f"answer {subsystem}/{name} {line}")

    def run_script(self, path: Path) -> Faults:
        """Carry out a file to its end, or to its first line that fails."""
        lines, faults = script_lines.load(path)
        if lines is None:
            return faults
        if self._depth == _DEEPEST:
            return self.session.no(Reason.of("console.scripts_too_deep", deepest=_DEEPEST, path=str(path)))
        former, self.session.in_script = self.session.in_script, True
        self._depth += 1
        try:
            return self._run(lines)
        finally:
            self._depth -= 1
            self.session.in_script = former

    def finish(self) -> Faults:
        """After the last line: the end of a run that goes on, whose outcome counts."""
        if self.session.running and not self.is_over:
            return ended(self.session)
        return ()

    def _run(self, lines: list[tuple[Place, str]]) -> Faults:
        for place, line in lines:
            self.session.say(Reason.plain(f"> {line}"), Tone.DIM)
            faults = self.carry_out(line, place)
            if faults:
                own = any(fault.place == place for fault in faults)
                self.session.place = place
                failed = Reason.of("console.script_line_failed", line=line)
                last = () if own else self.session.no(failed, Reason.of("console.script_ends"))
                return (*faults, *last)
            self.session.hear()
            if self.is_over:
                return ()
        return ()

    def _carry_out(self, line: str) -> Faults:
        if line.startswith("<"):  # as the thesis's console has it (§E.1)
            line = f"source {line[1:]}"
        name, _, rest = line.partition(" ")
        if not name:
            return ()
        matches = find(name, self._commands)
        if len(matches) != 1:
            return self.session.no(_not_one(name, matches))
        try:
            words = matches[0].words(rest.strip())
        except ValueError as wrong:
            return self.session.no(Reason.of("console.usage", usage=matches[0].usage, line=reason_of(wrong)))
        return matches[0].carry_out(self.session, words)

    # -- lines about the console itself

    def _vocabulary(self) -> list[tuple[Reason, tuple[Command, ...]]]:
        watch = Command(
            "watch",
            "watch NAME… [HZ]  |  watch off  |  watch only",
            Reason.of("console.does_watch"),
            self._watch.command,
            ("variable",),
            more=Reason.of("console.more_watch"),
        )
        follow = Command(
            "follow",
            "follow TASK [FILE]  |  follow off [TASK…]",
            Reason.of("console.does_follow"),
            self._follow.command,
            ("task", "file"),
        )
        own = (
            Command("source", "source FILE  |  <FILE", Reason.of("console.does_source"), self._source, ("file",), 1, 1),
            Command("help", "help [COMMAND]", Reason.of("console.does_help"), self._help, ("command",), 0, 1),
            Command(
                "quit",
                "quit [runtime]",
                Reason.of("console.does_quit"),
                self._quit,
                ("quit_word",),
                0,
                1,
                more=Reason.of("console.more_quit"),
            ),
        )
        return [
            (Reason.of("console.group_tasks"), commands.TASKS),
            (Reason.of("console.group_changes"), (*commands.CHANGES, follow)),
            (Reason.of("console.group_looks"), (*commands.LOOKS, watch)),
            (Reason.of("console.group_flows"), commands.FLOWS),
            (Reason.of("console.group_whole"), commands.WHOLE),
            (Reason.of("console.group_own"), own),
        ]

    def _source(self, session: ConsoleSession, words: Words) -> Faults:
        del session
        return self.run_script(Path(words[0]).expanduser())

    def _help(self, session: ConsoleSession, words: Words) -> Faults:
        if words:
            matches = find(words[0], self._commands)
            if not matches:
                return session.no(Reason.of("console.command_unknown", word=words[0]))
            for match in matches:
                session.say(Reason.plain(match.usage), Tone.HEAD)
                for reason in (match.purpose, match.more):
                    for line in session.in_words(reason).splitlines():
                        session.say(Reason.plain(f"  {line}"))
            return ()
        width = max(len(command.name) for command in self._commands)
        for title, group in self._groups:
            session.say(title, Tone.HEAD)
            for command in group:
                line = f"  {command.name:<{width}}  {session.in_words(command.purpose)}"
                session.say(Reason.plain(line))
        session.say(Reason.of("console.help_hint"), Tone.DIM)
        return ()

    def _quit(self, session: ConsoleSession, words: Words) -> Faults:
        if words and words != ("runtime",):
            return session.no(Reason.of("console.quit_usage", word=words[0]))
        if words:
            faults = session.order(request.Quit())
            if faults:
                return faults
        self.is_over = True
        return ()


def _not_one(name: str, matches: Sequence[Command]) -> Reason:
    """Why a name is not that of one command."""
    if matches:
        return Reason.of("console.several_commands", names=tuple(command.name for command in matches), name=name)
    return Reason.of("console.not_one_command", name=name)
