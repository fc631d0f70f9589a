"""`onika check`: read files and say everything that is wrong with them."""

import argparse
from pathlib import Path

from onika.cli.search_path import directory, site_here
from onika.desk.run.survey import survey


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("paths", nargs="+", type=Path, metavar="PATH", help="a base directory or one file")
    parser.add_argument(
        "--local", action="append", default=[], type=directory, metavar="DIR", help="a base directory to look in first"
    )


def carry_out(given: argparse.Namespace) -> int:
    """Check them; 0 if all is well."""
    files, faults = 0, []
    notes: list[str] = []
    for path in given.paths:
        read, new_faults = survey(path, site_here(given.local), notes.append)
        files += len(read)
        faults += [fault for fault in new_faults if fault not in faults]
    for fault in faults:
        print(fault)
    for text in dict.fromkeys(notes):
        print(f"note: {text}")
    print(f"{files} file{'s' if files != 1 else ''} read, {len(faults) or 'no'} fault{'s' if len(faults) != 1 else ''}")
    return 1 if faults else 0
