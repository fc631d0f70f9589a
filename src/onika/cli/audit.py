"""`onika audit`: show what a runtime was commanded to do, by whom, and whether that record is complete."""

import argparse
import os
import sys
from pathlib import Path

from onika.desk.run.audit_text import lines, verdict
from onika.files import trail


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("file", nargs="?", type=Path, metavar="FILE", help="the trail (that of this user's runtime)")
    parser.add_argument("--last", type=int, metavar="N", help="show only so many records")
    parser.add_argument("--quiet", action="store_true", help="show only whether it is whole")
    parser.add_argument("--head", metavar="HASH", help="a head that was noted before, and must still be in it")


def carry_out(given: argparse.Namespace) -> int:
    """Show and check it; 0 whole, 1 not, 2 there is none."""
    path = given.file or trail.usual_path(os.environ)
    files = trail.older(path)
    if not files:
        print(f"expected an audit trail at {path}, found none", file=sys.stderr)
        return 2
    records = trail.read(files)
    shown = [] if given.quiet else list(lines(records))
    for line in shown if given.last is None else shown[-given.last :] if given.last > 0 else []:
        print(line)
    for note in records.notes:
        print(f"note: {note}")
    for fault in records.faults:
        print(fault, file=sys.stderr)
    print(verdict(records))
    if given.head and given.head not in records.hashes:
        print(f"expected {given.head} in the trail, found no such line: lines were taken off its end", file=sys.stderr)
        return 1
    return 1 if records.faults else 0
