"""`onika recording`: look at a recorded run, write its variables as a table, or find where two runs differ."""

import argparse
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from onika.desk.run.recording_digest import digest_lines
from onika.desk.run.run_review import Review
from onika.record import columns
from onika.record.difference import first_difference
from onika.record.reader import UNREADABLE, Reader, complaint
from onika.record.run import RunRecord
from onika.record.tolerance import usual


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    acts = parser.add_subparsers(dest="act", metavar="ACT", required=True)
    show = acts.add_parser("show", help="what was run, when, how it ended, and what is in the file")
    show.add_argument("file", type=Path, metavar="RUN.mcap")
    table = acts.add_parser("csv", help="variables as a table: a row for each time at which one of them changed")
    table.add_argument("file", type=Path, metavar="RUN.mcap")
    table.add_argument("variables", nargs="*", metavar="NAME", help="by name or as subsystem/NAME (all)")
    table.add_argument("--output", type=Path, metavar="FILE.csv", help="where to (the standard output)")
    compare = acts.add_parser(
        "diff",
        help="the first difference of two runs; the exit code is 1 where there is one",
        epilog="In brackets: what is meant where nothing is said, in virtual time; and where a run was in wall time. "
        "There speeds and forces are not compared unless it is said by how much values may differ.",
    )
    compare.add_argument("one", type=Path, metavar="A.mcap")
    compare.add_argument("other", type=Path, metavar="B.mcap")
    compare.add_argument("--tolerance", type=_amount, metavar="X", help="values may differ by this (0; 0.002)")
    compare.add_argument("--part", type=_amount, metavar="X", help="and by this part of themselves (0; 0.001)")
    compare.add_argument("--time", type=_amount, metavar="S", help="times may differ by seconds (0; 0.1)")


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
    except _UnreadableRecording as wrong:
        print(wrong, file=sys.stderr)
        return 2


class _UnreadableRecording(Exception):
    """A file is no recording, or what was asked is not in it."""


@contextmanager
def _reading(path: Path) -> Iterator[None]:
    try:
        yield
    except BrokenPipeError:
        raise
    except UNREADABLE as wrong:
        raise _UnreadableRecording(complaint(path, wrong)) from None


def _show(path: Path) -> int:
    with _reading(path), Review(path) as review:
        lines = list(digest_lines(review))
    print("\n".join(lines))
    return 0


def _table(given: argparse.Namespace) -> int:
    path, output = given.file, given.output
    with _reading(path):
        review = Review(path)
    with review:
        wanted = given.variables
        series = [
            variable
            for name, variable in review.series.items()
            if not wanted or name in wanted or variable.name in wanted
        ]
        names = {*review.series, *(variable.name for variable in series)}
        strange = [name for name in wanted if name not in names]
        if strange:
            raise _UnreadableRecording(f"{path}: expected one of {', '.join(review.series)}, found {strange[0]!r}")
        if output is None:
            with _reading(path):
                columns.write(sys.stdout, series)
            _tell_cut(review)
            return 0
        if output.exists() and output.samefile(path):
            raise _UnreadableRecording(f"{output}: expected another file than the recording itself; nothing is written")
        try:
            stream = output.open("w", newline="", encoding="utf-8")
        except OSError as wrong:
            raise _UnreadableRecording(complaint(output, wrong)) from None
        with stream, _reading(path):
            rows = columns.write(stream, series)
    print(f"{_counted(rows, 'row')} of {_counted(len(series), 'variable')}: {output}")
    _tell_cut(review)
    return 0


def _tell_cut(review: Review) -> None:
    """A table ends as any other does, and nobody would see that the run went on."""
    if not review.is_whole:
        print(f"{review.path} was cut short: the table ends at {review.span_s[1]:.9g} s", file=sys.stderr)


def _compare(given: argparse.Namespace) -> int:
    readers, is_virtual = [], True
    for path in (given.one, given.other):
        with _reading(path):
            readers.append(Reader(path))
            is_virtual &= RunRecord.read(readers[-1]).is_virtual
    tolerance = usual(is_virtual, given.tolerance, given.part, given.time)
    difference = None
    with _reading(given.one):  # a part that is spoilt tells its own file
        difference = first_difference(readers[0], readers[1], tolerance)
    print(difference or "no difference")
    if tolerance.is_of_places:
        print(
            f"in wall time: values within {tolerance.value:g} and {tolerance.part:.1%}, times within "
            f"{tolerance.seconds:g} s; speeds and forces are not compared"
        )
    for reader in readers:
        if not reader.is_whole:
            print(f"{reader.path} was cut short: compared up to {reader.span[1] * 1e-9:.9g} s")
    return 0 if difference is None else 1


def _counted(number: int, what: str) -> str:
    return f"{number} {what}{'' if number == 1 else 's'}"


def _amount(text: str) -> float:
    try:
        amount = float(text)
    except ValueError:
        amount = -1.0
    if not 0.0 <= amount <= 1e9:
        raise argparse.ArgumentTypeError(f"expected a number from 0 on, found {text!r}")
    return amount
