"""`onika check`: read files and say everything that is wrong with them."""

import argparse
from pathlib import Path

from onika.cli.argument_kinds import directory
from onika.cli.language import say
from onika.cli.lines.fault_lines import fault_lines
from onika.cli.search_path import site_here
from onika.desk.run.survey import survey
from onika.words.reason import Reason


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_check")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("paths", nargs="+", type=Path, metavar="PATH", help=say(Reason.of("cli.check_paths")))
    parser.add_argument("--all", action="store_true", help=say(Reason.of("cli.check_all")))
    parser.add_argument(
        "--local", action="append", default=[], type=directory, metavar="DIR", help=say(Reason.of("cli.check_local"))
    )


def carry_out(given: argparse.Namespace) -> int:
    """Check them; 0 if all is well."""
    files, faults = 0, []
    notes: list[Reason] = []
    for path in given.paths:
        read, new_faults = survey(path, site_here(given.local), notes.append)
        files += len(read)
        faults += [fault for fault in new_faults if fault not in faults]
    for line in fault_lines(faults, is_whole=given.all):
        print(say(line))
    for text in dict.fromkeys(notes):
        print(say(Reason.of("cli.note", text=text)))
    count = str(len(faults)) if faults else Reason.of("cli.none")
    print(say(Reason.of("cli.checked", files=files, count=count, faults=len(faults))))
    return 1 if faults else 0
