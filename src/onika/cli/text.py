"""`onika text`: write an application as text in the words of AL, and read it back."""

import argparse
import sys
from pathlib import Path

from onika.cli.search_path import directory, site_here
from onika.desk.plan.application_text import convert, is_text, keep, unfit


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("file", metavar="NAME|FILE", help="an application, or a text: what ends with .al")
    parser.add_argument("-o", dest="out", type=Path, metavar="OUT", help="the file to write (standard output)")
    parser.add_argument("--overwrite", action="store_true", help="replace OUT if it is there")
    parser.add_argument("--whole", action="store_true", help="a text that needs no dictionary to be read back")
    parser.add_argument(
        "--local", action="append", default=[], type=directory, metavar="DIR", help="a base directory to look in first"
    )


def carry_out(given: argparse.Namespace) -> int:
    """Convert it; 0 if that was done."""
    site = site_here(given.local)
    path = Path(given.file)
    if not is_text(path):
        path = site.application_file(given.file) or path
    wrong = unfit(path, given.out) if given.out else None
    if wrong:
        return _failed(wrong)
    converted = convert(path, given.out, site, is_whole=given.whole)
    for note in converted.notes:
        print(f"note: {note}", file=sys.stderr)
    if converted.application is None:
        return _failed(*converted.faults)
    if given.out is None:
        sys.stdout.write(converted.content)
        return 0
    refusal = keep(converted, given.out, overwrites=given.overwrite)
    if refusal:
        return _failed(refusal)
    print(given.out)
    return 0


def _failed(*reasons: object) -> int:
    for reason in reasons:
        print(reason, file=sys.stderr)
    return 1
