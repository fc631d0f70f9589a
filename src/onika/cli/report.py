"""`onika report`: all that an issue needs of a run in one file, shown before it is written."""

import argparse
import os
import sys
from pathlib import Path

from onika.cli.argument_kinds import directory
from onika.cli.language import say
from onika.cli.search_path import site_here
from onika.desk.environment.lone_review import read_alone
from onika.desk.environment.shared.report import ReportPart, report_parts, write_report
from onika.record.black_box_folder import black_box_folder, black_boxes
from onika.record.reader import UNREADABLE, complaint
from onika.words.reason import Reason

_KB = 1000
_TEXTS = (".txt", ".appl")


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_report")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("file", nargs="?", type=Path, metavar="RUN.mcap", help=say(Reason.of("cli.report_file")))
    parser.add_argument("-o", dest="out", type=Path, metavar="OUT.zip", help=say(Reason.of("cli.report_out")))
    parser.add_argument("--yes", action="store_true", help=say(Reason.of("cli.report_yes")))
    parser.add_argument("--overwrite", action="store_true", help=say(Reason.of("cli.text_overwrite")))
    parser.add_argument(
        "--local", action="append", default=[], type=directory, metavar="DIR", help=say(Reason.of("cli.check_local"))
    )


def carry_out(given: argparse.Namespace) -> int:
    """Show what is in it, and write it if that is wanted; 1 where it is not, 2 where there is nothing to report."""
    file = given.file or next(iter(black_boxes(black_box_folder(os.environ))), None)
    if file is None:
        return _failed(Reason.of("cli.report_nothing"))
    out = given.out or Path(f"{file.stem}-report.zip")
    if out.exists() and not given.overwrite:
        return _failed(Reason.of("cli.share_there", path=str(out)))
    site = site_here(given.local)
    reading = read_alone(file, site)
    if isinstance(reading, Reason):
        return _failed(reading)
    try:
        parts = report_parts(reading.subject, site, str(Path.home()))
    except UNREADABLE as wrong:
        return _failed(complaint(file, wrong))
    finally:
        reading.subject.review.close()
    _show(out, parts)
    if not given.yes and not _is_wanted(parts):
        print(say(Reason.of("cli.report_unwritten")), file=sys.stderr)
        return 1
    try:
        write_report(out, parts)
    except OSError as wrong:
        return _failed(complaint(out, wrong))
    print(say(Reason.of("cli.share_written", path=str(out), size=out.stat().st_size / _KB**2)))
    return 0


def _show(out: Path, parts: tuple[ReportPart, ...]) -> None:
    print(say(Reason.of("cli.report_holds", path=str(out))))
    for part in parts:
        size = len(part.content) / _KB
        print(say(Reason.of("cli.report_part", name=part.name, size=size, about=part.about)))
    print(say(Reason.of("cli.report_clean")))


def _is_wanted(parts: tuple[ReportPart, ...]) -> bool:
    """Whether who sits at the terminal wants it, who may read its texts before; nobody there is no."""
    if not sys.stdin.isatty():
        return False
    while (answer := input(say(Reason.of("cli.report_question"))).strip().lower()) == "v":
        for part in parts:
            if part.name.endswith(_TEXTS):
                print(f"\n{part.name}\n\n{part.content.decode(errors='replace')}")
    return answer in say(Reason.of("cli.report_yes_words")).split()


def _failed(reason: Reason) -> int:
    print(say(reason), file=sys.stderr)
    return 2
