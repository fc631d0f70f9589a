"""The commands by name, and the parser that knows them."""

import argparse
import sys

from onika import __version__
from onika.cli import audit, check, console, doctor, icon, new, page, recording, run, runtime, test, text
from onika.link.lost import LinkLost

_COMMANDS = {
    "page": page,
    "run": run,
    "test": test,
    "runtime": runtime,
    "recording": recording,
    "console": console,
    "check": check,
    "new": new,
    "icon": icon,
    "text": text,
    "audit": audit,
    "doctor": doctor,
}


def carry_out(words: list[str] | None) -> int:
    """Carry out a command line; the exit code."""
    parser = argparse.ArgumentParser(prog="onika", description="Programs for robots from tasks, jobs and targets.")
    parser.add_argument("--version", action="version", version=f"onika {__version__}")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    for name, command in _COMMANDS.items():
        purpose = (command.__doc__ or "").partition(": ")[2].partition("\n")[0].rstrip(".")
        command.describe(commands.add_parser(name, help=purpose, description=purpose.capitalize() + "."))
    given = parser.parse_args(_whole(sys.argv[1:] if words is None else words))
    try:
        code: int = _COMMANDS[given.command].carry_out(given)
        return code
    except (LinkLost, TimeoutError) as lost:
        print(lost, file=sys.stderr)
        return 1


def _whole(words: list[str]) -> list[str]:
    """`onika` alone, and with options only, opens the page."""
    if words and (words[0] in ("-h", "--help", "--version") or not words[0].startswith("-")):
        return words
    return ["page", *words]
