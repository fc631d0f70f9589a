"""`onika recording`: look at a recorded run, write its variables as a table, compare or measure it."""

import argparse
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from onika.cli import response_table
from onika.cli.language import say
from onika.desk.run.recording_digest import digest_lines
from onika.desk.run.run_review import Review
from onika.record import columns
from onika.record.black_box_span import SEEN_WITHIN_S, BlackBoxSpan
from onika.record.difference import both_hold, first_difference
from onika.record.reader import UNREADABLE, Reader, complaint
from onika.record.run import RunRecord
from onika.record.tolerance import usual
from onika.words.reason import Reason


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_recording")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    acts = parser.add_subparsers(dest="act", metavar="ACT", required=True)
    show = acts.add_parser("show", help=say(Reason.of("cli.recording_show")))
    show.add_argument("file", type=Path, metavar="RUN.mcap")
    table = acts.add_parser("csv", help=say(Reason.of("cli.recording_csv")))
    table.add_argument("file", type=Path, metavar="RUN.mcap")
    table.add_argument("variables", nargs="*", metavar="NAME", help=say(Reason.of("cli.recording_variables")))
    table.add_argument("--output", type=Path, metavar="FILE.csv", help=say(Reason.of("cli.recording_output")))
    response_table.describe(acts.add_parser("response", help=say(Reason.of("cli.recording_response"))))
    compare = acts.add_parser(
        "diff", help=say(Reason.of("cli.recording_diff")), epilog=say(Reason.of("cli.recording_diff_epilog"))
    )
    compare.add_argument("one", type=Path, metavar="A.mcap")
    compare.add_argument("other", type=Path, metavar="B.mcap")
    compare.add_argument("--tolerance", type=_amount, metavar="X", help=say(Reason.of("cli.recording_tolerance")))
    compare.add_argument("--part", type=_amount, metavar="X", help=say(Reason.of("cli.recording_part")))
    compare.add_argument("--time", type=_amount, metavar="S", help=say(Reason.of("cli.recording_time")))


def carry_out(given: argparse.Namespace) -> int:
    """Do it; 2 where a file is no recording."""
    try:
        match given.act:
            case "show":
                return _show(given.file)
            case "csv":
                return _table(given)
            case "response":
                return _respond(given)
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
        raise _UnreadableRecording(say(complaint(path, wrong))) from None


def _show(path: Path) -> int:
    with _reading(path), Review(path) as review:
        lines = [say(line) for line in digest_lines(review)]
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
            unknown = Reason.of("cli.no_variable", path=str(path), variables=tuple(review.series), name=strange[0])
            raise _UnreadableRecording(say(unknown))
        if output is None:
            with _reading(path):
                columns.write(sys.stdout, series)
            _tell_cut(review)
            return 0
        if output.exists() and output.samefile(path):
            raise _UnreadableRecording(say(Reason.of("cli.table_over_recording", path=str(output))))
        try:
            stream = output.open("w", newline="", encoding="utf-8")
        except OSError as wrong:
            raise _UnreadableRecording(say(complaint(output, wrong))) from None
        with stream, _reading(path):
            rows = columns.write(stream, series)
    print(say(Reason.of("cli.table_written", rows=rows, variables=len(series), path=str(output))))
    _tell_cut(review)
    return 0


def _respond(given: argparse.Namespace) -> int:
    if given.output is not None and given.output.exists() and given.output.samefile(given.file):
        raise _UnreadableRecording(say(Reason.of("cli.table_over_recording", path=str(given.output))))
    with _reading(given.file), Review(given.file) as review:
        response_table.write(review, given)
        _tell_cut(review)
    return 0


def _tell_cut(review: Review) -> None:
    """A table ends as any other does, and nobody would see that the run went on."""
    if not review.is_whole:
        cut = Reason.of("cli.table_cut", path=str(review.path), seconds=review.span_s[1])
        print(say(cut), file=sys.stderr)


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
    print(say(Reason.of("cli.no_difference") if difference is None else difference.sentence))
    if tolerance.is_of_places:
        bounds = Reason.of(
            "cli.tolerance", value=tolerance.value, percent=100 * tolerance.part, seconds=tolerance.seconds
        )
        print(say(bounds))
    if any(BlackBoxSpan.of(reader.notes) for reader in readers):
        first, last = both_hold(readers[0], readers[1])
        end = min(last, max(reader.span[1] for reader in readers))
        within = max(tolerance.seconds, SEEN_WITHIN_S)
        part = Reason.of("cli.black_box_compared", begin=first * 1e-9, end=end * 1e-9, seconds=within)
        print(say(part))
    for reader in readers:
        if not reader.is_whole:
            print(say(Reason.of("cli.comparison_cut", path=str(reader.path), seconds=reader.span[1] * 1e-9)))
    return 0 if difference is None else 1


def _amount(text: str) -> float:
    try:
        amount = float(text)
    except ValueError:
        amount = -1.0
    if not 0.0 <= amount <= 1e9:
        raise argparse.ArgumentTypeError(say(Reason.of("cli.amount_expected", text=text)))
    return amount
