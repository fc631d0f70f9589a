"""`onika test`: do kept runs again and say what is not as it was."""

import argparse
import os
import sys
from pathlib import Path

from onika.cli.orderly_exit import in_order
from onika.cli.search_path import directory, site_here
from onika.desk.trial import junit
from onika.desk.trial.home import FOLDER
from onika.desk.trial.trial import Trial, find, try_all


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument(
        "paths", nargs="*", type=Path, metavar="PATH", help=f"test files, and folders with some ({FOLDER})"
    )
    parser.add_argument("-k", dest="word", default="", metavar="WORD", help="only tests with this word in their names")
    parser.add_argument("--junit", type=Path, metavar="OUT.xml", help="write the outcome for a build server")
    parser.add_argument(
        "--shake", type=_count, default=0, metavar="N",
        help="do each also N times with other seeds and the things of its world a little elsewhere (0)",
    )  # fmt: skip
    parser.add_argument(
        "--jobs", type=_count, default=0, metavar="N", help="so many at a time (one for each processor)"
    )
    parser.add_argument(
        "--local", action="append", default=[], type=directory, metavar="DIR", help="a base directory to look in first"
    )


def carry_out(given: argparse.Namespace) -> int:
    """Do them; 0 if all are passed, 1 if one is not, 2 if there is none."""
    files, faults = find(given.paths or [Path(FOLDER)], given.word)
    for fault in faults:
        print(fault, file=sys.stderr)
    if faults or not files:
        if not faults:
            print(f"no test has {given.word!r} in its name", file=sys.stderr)
        return 2
    done = []
    with in_order():
        for trial in try_all(
            files, site_here(given.local), workers=given.jobs or os.cpu_count() or 1, shakes=given.shake
        ):
            _tell(trial)
            done.append(trial)
    failed = sum(not trial.verdict.is_passed for trial in done)
    print(f"{len(done) - failed} of {len(done)} passed" + (f", {failed} failed" if failed else ""))
    if given.junit is not None:
        given.junit.write_bytes(junit.document(done))
    return 1 if failed else 0


def _tell(trial: Trial) -> None:
    outcome = "passed" if trial.verdict.is_passed else "FAILED"
    print(f"{outcome}  {trial.name}  {trial.verdict.lasted_s:.2f} s, in {trial.wall_s:.1f} s of wall time", flush=True)
    for text in trial.verdict.failures:
        print(f"    {text}")
    for text in trial.verdict.notes:
        print(f"    note: {text}")


def _count(text: str) -> int:
    if not text.isdigit() or not text.isascii() or len(text) > 4:
        raise argparse.ArgumentTypeError(f"expected a whole number of at most 4 digits, found {text!r}")
    return int(text)
