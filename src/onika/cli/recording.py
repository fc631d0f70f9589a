"""`onika recording`: look at a recorded run, write its variables as a table, or tell where two runs differ."""

import argparse
import sys
from pathlib import Path

from onika.desk.digest import told
from onika.desk.review import Review
from onika.record import columns
from onika.record.difference import Tolerance, first_difference
from onika.record.reader import Reader


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    acts = parser.add_subparsers(dest="act", metavar="ACT", required=True)
    show = acts.add_parser("show", help="what was run, when, how it ended, and what is in the file")
    show.add_argument("file", type=Path, metavar="RUN.mcap")
    table = acts.add_parser("csv", help="variables as a table: a row for each time at which one of them changed")
    table.add_argument("file", type=Path, metavar="RUN.mcap")
    table.add_argument("variables", nargs="*", metavar="NAME", help="by name or as subsystem/NAME (all)")
    table.add_argument("--output", type=Path, metavar="FILE.csv", help="where to (the standard output)")
    compare = acts.add_parser("diff", help="the first difference of two runs; the exit code is 1 where there is one")
    compare.add_argument("one", type=Path, metavar="A.mcap")
    compare.add_argument("other", type=Path, metavar="B.mcap")
    compare.add_argument("--tolerance", type=_amount, default=0.0, metavar="X", help="values may differ by this (0)")
    compare.add_argument("--part", type=_amount, default=0.0, metavar="X", help="and by this part of themselves (0)")
    compare.add_argument("--time", type=_amount, default=0.0, metavar="S", help="times may differ by seconds (0)")


def carry_out(given: argparse.Namespace) -> int:
    """Do it; 2 where a file is no recording."""
    try:
        match given.act:
            case "show":
                return _show(given.file)
            case "csv":
                return _table(given)
            case _:
                return _compare(given)
    except (ValueError, OSError) as wrong:
        print(wrong, file=sys.stderr)
        return 2


def _show(path: Path) -> int:
    with Review(path) as review:
        for line in told(review):
            print(line)
    return 0


def _table(given: argparse.Namespace) -> int:
    with Review(given.file) as review:
        wanted = given.variables
        series = [one for name, one in review.series.items() if not wanted or name in wanted or one.name in wanted]
        known = {*review.series, *(one.name for one in series)}
        strange = [name for name in wanted if name not in known]
        if strange:
            raise ValueError(f"{given.file}: expected one of {', '.join(review.series)}, found {strange[0]!r}")
        if given.output is None:
            columns.write(sys.stdout, series)
            return 0
        with given.output.open("w", newline="", encoding="utf-8") as stream:
            rows = columns.write(stream, series)
    print(f"{rows} rows of {len(series)} variables: {given.output}")
    return 0


def _compare(given: argparse.Namespace) -> int:
    tolerance = Tolerance(given.tolerance, given.part, given.time)
    found = first_difference(Reader(given.one), Reader(given.other), tolerance)
    print(found or "no difference")
    return 0 if found is None else 1


def _amount(text: str) -> float:
    try:
        amount = float(text)
    except ValueError:
        amount = -1.0
    if not 0.0 <= amount <= 1e9:
        raise argparse.ArgumentTypeError(f"expected a number from 0 on, found {text!r}")
    return amount
