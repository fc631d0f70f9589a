"""The calibration with which a session begins: an application is run in its workcell, and its result is told (§E.1)."""

import argparse
from pathlib import Path

from onika.cli.argument_kinds import runtime_address
from onika.cli.language import say
from onika.cli.plain_display import PlainDisplay
from onika.cli.search_path import site_here
from onika.desk.run.run import run
from onika.desk.run.settings import RunSettings, RuntimeLocation
from onika.link.token import read_token
from onika.process.orderly_exit import in_order
from onika.words.reason import NOTHING, Reason, reason_of

APPLICATION = "calibrate"


def add_calibration(parser: argparse.ArgumentParser) -> None:
    """What is run, where, and what becomes of a failure."""
    parser.add_argument(
        "--calibration", default=APPLICATION, metavar="NAME|FILE", help=say(Reason.of("cli.study_calibration"))
    )
    left = parser.add_mutually_exclusive_group()
    left.add_argument("--no-calibration", action="store_true", help=say(Reason.of("cli.study_no_calibration")))
    left.add_argument("--uncalibrated", action="store_true", help=say(Reason.of("cli.study_uncalibrated")))

    parser.add_argument("--runtime", type=runtime_address, metavar="URL", help=say(Reason.of("cli.study_runtime")))
    parser.add_argument("--token-file", type=_token_file, metavar="FILE", help=say(Reason.of("cli.run_token_file")))


def is_calibrated(given: argparse.Namespace) -> bool:
    """Calibrate, and tell what came of it; False where nothing shall go on."""
    if given.no_calibration:
        return True
    print(say(Reason.of("cli.study_calibrates", name=given.calibration)), flush=True)
    settings = _settings(given)
    watcher = PlainDisplay()
    with in_order(), watcher:
        outcome = run(settings, site_here([]), watcher)
    watcher.ended(outcome, NOTHING)
    if outcome.exit_code == 0:
        print(say(Reason.of("cli.study_calibrated")), flush=True)
        return True
    said = "cli.study_went_on" if given.uncalibrated else "cli.study_not_calibrated"
    print(say(Reason.of(said)), flush=True)
    return bool(given.uncalibrated)


def page_of_workcell(given: argparse.Namespace) -> tuple[str, ...]:
    """How the page is led to the workcell; empty: it has a simulated one of its own."""
    if given.runtime is None:
        return ()
    token = () if given.token_file is None else ("--token-file", str(given.token_file))
    return ("--connect", given.runtime, *token)


def _settings(given: argparse.Namespace) -> RunSettings:
    """In a simulated workcell in virtual time, elsewhere as it is."""
    if given.runtime is None:
        return RunSettings(given.calibration, is_virtual=True, has_black_box=False)
    token = "" if given.token_file is None else read_token(given.token_file)
    return RunSettings(given.calibration, elsewhere=RuntimeLocation(given.runtime, token))


def _token_file(text: str) -> Path:
    """A file with a token, as a word of a command line."""
    try:
        read_token(Path(text))
    except (OSError, ValueError) as wrong:
        raise argparse.ArgumentTypeError(say(Reason.of("cli.token_expected", reason=reason_of(wrong)))) from None
    return Path(text).absolute()
