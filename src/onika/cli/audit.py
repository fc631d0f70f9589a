"""`onika audit`: show what a runtime was commanded to do, by whom, and whether that record is complete."""

import argparse
import os
import sys
from pathlib import Path

from onika.cli.language import say
from onika.desk.run.audit_text import lines, verdict
from onika.files import trail
from onika.words.reason import Reason


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_audit")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("file", nargs="?", type=Path, metavar="FILE", help=say(Reason.of("cli.audit_file")))
    parser.add_argument("--last", type=int, metavar="N", help=say(Reason.of("cli.audit_last")))
    parser.add_argument("--quiet", action="store_true", help=say(Reason.of("cli.audit_quiet")))
    parser.add_argument("--head", metavar="HASH", help=say(Reason.of("cli.audit_head")))


def carry_out(given: argparse.Namespace) -> int:
    """Show and check it; 0 whole, 1 not, 2 there is none."""
    path = given.file or trail.usual_path(os.environ)
    paths = [path] if given.file else trail.beside(path)  # runtimes that ran side by side wrote one each
    if not any(map(trail.older, paths)):
        print(say(Reason.of("cli.no_trail", path=str(path))), file=sys.stderr)
        return 2
    readings = []
    for each in paths:
        if len(paths) > 1:
            print(say(Reason.of("cli.trail_of", path=str(each))))
        readings.append(_shown(each, given))
    if given.head and not any(given.head in records.hashes for records in readings):
        print(say(Reason.of("cli.no_head", head=given.head)), file=sys.stderr)
        return 1
    return 1 if any(records.faults for records in readings) else 0


def _shown(path: Path, given: argparse.Namespace) -> trail.TrailReading:
    """Print the records of one trail, what is wrong with it, and whether it is whole."""
    records = trail.read(trail.older(path))
    shown = [] if given.quiet else list(lines(records))
    for line in shown if given.last is None else shown[-given.last :] if given.last > 0 else []:
        print(say(line))
    for note in records.notes:
        print(say(Reason.of("cli.note", text=note)))
    for fault in records.faults:
        print(say(fault.sentence), file=sys.stderr)
    print(say(verdict(records)))
    return records
