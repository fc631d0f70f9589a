"""`onika text`: write an application as text in the words of AL, and read it back."""

import argparse
import sys
from pathlib import Path

from onika.cli.argument_kinds import directory
from onika.cli.language import say
from onika.cli.search_path import site_here
from onika.desk.plan.application_text import convert, is_text, keep, unfit
from onika.words.fault import Fault, Refusal
from onika.words.reason import Reason


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_text")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("file", metavar="NAME|FILE", help=say(Reason.of("cli.text_file")))
    parser.add_argument("-o", dest="out", type=Path, metavar="OUT", help=say(Reason.of("cli.text_out")))
    parser.add_argument("--overwrite", action="store_true", help=say(Reason.of("cli.text_overwrite")))
    parser.add_argument("--whole", action="store_true", help=say(Reason.of("cli.text_whole")))
    parser.add_argument(
        "--local", action="append", default=[], type=directory, metavar="DIR", help=say(Reason.of("cli.check_local"))
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
        print(say(Reason.of("cli.note", text=note.sentence)), file=sys.stderr)
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


def _failed(*reasons: Fault | Refusal) -> int:
    for reason in reasons:
        print(say(reason.sentence), file=sys.stderr)
    return 1
