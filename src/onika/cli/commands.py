"""The commands by name, and the parser that knows them."""

import argparse
import gc
import os
import sys
from collections.abc import Iterable
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

from onika import __version__
from onika.cli.language import say, speaking
from onika.files.state.access import guard
from onika.files.state.state_directory import guarded, state_directory
from onika.link.lost import LinkLost
from onika.words import argument_words
from onika.words.reason import Reason, reason_of
from onika.words.sentence import LANGUAGES
from onika.words.system_error import system_reason_with_place

if TYPE_CHECKING:
    from _typeshed import SupportsWrite

KEEPING = frozenset(("page", "run", "share", "test", "sweep", "runtime", "site", "class", "console", "user"))
"""Commands that keep something in the state directory, or let others in by what lies there."""

COMMANDS = (
    "page",
    "run",
    "test",
    "sweep",
    "runtime",
    "site",
    "class",
    "recording",
    "share",
    "report",
    "study",
    "console",
    "check",
    "new",
    "icon",
    "own",
    "library",
    "fabric",
    "text",
    "user",
    "audit",
    "doctor",
)
"""In the order in which the help shows them; each is a file beside this one."""

FILES = {"class": "classroom"}
"""Of a command whose name is a word of Python."""


class CommandParser(argparse.ArgumentParser):
    """A parser whose help is out, or the command has failed; the usual one says nothing of a full disk."""

    def print_help(self, file: "SupportsWrite[str] | None" = None) -> None:
        """Write it; raises OSError."""
        out = sys.stdout if file is None else file
        if out is not None:
            out.write(self.format_help())
        _flush()


def carry_out(words: list[str] | None) -> int:
    """Carry out a command line; the exit code."""
    argument_words.translate()
    wanted, rest = _language_first(sys.argv[1:] if words is None else words)
    with speaking(wanted):
        try:
            given = _parse(_whole(rest))
            gc.enable()
            if given.command in KEEPING and not _is_ours(state_directory(os.environ)):
                return 2
            code: int = _command(given.command).carry_out(given)
            _flush()
            return code
        except (KeyboardInterrupt, OSError, UnicodeError, LinkLost) as ending:
            return _ended(ending)


def _flush() -> None:
    if sys.stdout is not None:
        sys.stdout.flush()


def _is_ours(state: Path) -> bool:
    """Whether nobody else can use what is kept there, as far as that cannot be mended; what is to be told is told."""
    report = guard(guarded(state))
    for sentence in report.sentences:
        _say_last(sentence, 0)
    return not report.refused


def _ended(ending: BaseException) -> int:
    """Say why a command ended otherwise than by itself; its exit code."""
    match ending:
        case KeyboardInterrupt():
            return _say_last(Reason.of("cli.stopped"), 130)
        case BrokenPipeError():
            _drop_output()  # whoever read our output has seen enough; what was to be done was not done
            return 1
        case LinkLost() | TimeoutError():
            return _say_last(reason_of(ending), 1)
        case OSError():
            _drop_output()
            return _say_last(Reason.of("cli.system_error", why=system_reason_with_place(ending)), 1)
        case _:
            return _say_last(Reason.of("cli.letters_lack", why=Reason.plain(str(ending))), 1)


def _say_last(reason: Reason, code: int) -> int:
    """Say it on the error output, whatever its letters are."""
    if sys.stderr is not None:
        letters = sys.stderr.encoding or "ascii"
        sys.stderr.write(say(reason).encode(letters, "backslashreplace").decode(letters) + "\n")
    return code


def _drop_output() -> None:
    """So that the interpreter does not complain once more when it ends."""
    if sys.stdout is not None:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)


def _parse(words: list[str]) -> argparse.Namespace:
    """What is given; all commands are loaded only where the words name none, since together they take long to load."""
    named = words[:1] if words[0] in COMMANDS else COMMANDS
    return _parser(named).parse_args(words)


def _command(name: str) -> ModuleType:
    return import_module(f"onika.cli.{FILES.get(name, name)}")


def _parser(names: Iterable[str]) -> argparse.ArgumentParser:
    parser = CommandParser(prog="onika", description=say(Reason.of("cli.description")))
    parser.add_argument(
        "--version", action="version", version=f"onika {__version__}", help=say(Reason.of("cli.version_option"))
    )
    _add_language(parser)
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    for name in names:
        command = _command(name)
        purpose = say(command.purpose())
        description = purpose[:1].upper() + purpose[1:] + "."
        command.describe(commands.add_parser(name, help=purpose, description=description))
    return parser


def _add_language(parser: argparse.ArgumentParser) -> None:
    purpose = Reason.of("cli.language_option", languages=LANGUAGES, default=LANGUAGES[0])
    parser.add_argument("--lang", choices=LANGUAGES, help=say(purpose))


def _language_first(words: list[str]) -> tuple[str | None, list[str]]:
    """The language that the first words name, as every parser speaks it, and the words behind them."""
    parser = argparse.ArgumentParser(prog="onika", add_help=False, allow_abbrev=False)
    _add_language(parser)
    count = 2 if words[:1] == ["--lang"] else int(words[:1] != [] and words[0].startswith("--lang="))
    wanted: str | None = parser.parse_args(words[:count]).lang
    return wanted, words[count:]


def _whole(words: list[str]) -> list[str]:
    """`onika` alone, and with options only, opens the page."""
    if words and (words[0] in ("-h", "--help", "--version") or not words[0].startswith("-")):
        return words
    return ["page", *words]
