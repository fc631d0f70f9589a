"""`onika test`: do kept runs again and say what is not as it was."""

import argparse
import os
import sys
from pathlib import Path

from onika.cli.argument_kinds import directory
from onika.cli.language import say
from onika.cli.search_path import site_here
from onika.desk.trial import junit
from onika.desk.trial.home import FOLDER
from onika.desk.trial.trial import Trial, find, try_all
from onika.process.orderly_exit import in_order
from onika.words.reason import NOTHING, Reason


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_test")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument(
        "paths", nargs="*", type=Path, metavar="PATH", help=say(Reason.of("cli.test_paths", folder=FOLDER))
    )
    parser.add_argument("-k", dest="word", default="", metavar="WORD", help=say(Reason.of("cli.test_word")))
    parser.add_argument("--junit", type=Path, metavar="OUT.xml", help=say(Reason.of("cli.test_junit")))
    parser.add_argument(
        "--shake", type=_count, default=0, metavar="N",
        help=say(Reason.of("cli.test_shake")),
    )  # fmt: skip
    parser.add_argument("--jobs", type=_count, default=0, metavar="N", help=say(Reason.of("cli.test_jobs")))
    parser.add_argument(
        "--local", action="append", default=[], type=directory, metavar="DIR", help=say(Reason.of("cli.check_local"))
    )


def carry_out(given: argparse.Namespace) -> int:
    """Do them; 0 if all are passed, 1 if one is not, 2 if there is none."""
    files, faults = find(given.paths or [Path(FOLDER)], given.word)
    if not faults and not files:
        print(say(Reason.of("cli.no_test", word=given.word)), file=sys.stderr)
    for fault in faults:
        print(say(fault.sentence), file=sys.stderr)
    if faults or not files:
        return 2
    done = []
    with in_order():
        for trial in try_all(
            files, site_here(given.local), workers=given.jobs or os.cpu_count() or 1, shakes=given.shake
        ):
            _tell(trial)
            done.append(trial)
    failed = sum(not trial.verdict.is_passed for trial in done)
    failures = Reason.of("cli.tests_failed", number=failed) if failed else NOTHING
    print(say(Reason.of("cli.tests_passed", passed=len(done) - failed, number=len(done), failures=failures)))
    if given.junit is not None:
        given.junit.write_bytes(junit.document(done))
    return 1 if failed else 0


def _tell(trial: Trial) -> None:
    outcome = Reason.of("cli.test_passed") if trial.verdict.is_passed else Reason.of("cli.test_failed")
    took = Reason.of("cli.test_took", seconds=trial.verdict.lasted_s, wall=trial.wall_s)
    print(f"{say(outcome)}  {say(trial.name)}  {say(took)}", flush=True)
    for failure in trial.verdict.failures:
        print(f"    {say(failure)}")
    for text in trial.verdict.notes:
        print(f"    {say(Reason.of('cli.note', text=text))}")


def _count(text: str) -> int:
    if not text.isdigit() or not text.isascii() or len(text) > 4:
        raise argparse.ArgumentTypeError(say(Reason.of("cli.whole_expected", digits=4, text=text)))
    return int(text)
