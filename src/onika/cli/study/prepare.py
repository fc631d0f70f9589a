"""`onika study prepare`: the session of a subject is readied (requirement H09)."""

import argparse
import os
import shlex
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType

from onika.cli.language import say
from onika.cli.page import window
from onika.cli.search_path import add_dictionaries, chosen_dictionaries, site_here
from onika.cli.study.calibration import add_calibration, is_calibrated, page_of_workcell
from onika.study.preparation import VARIANTS, Session, end, planned, prepare
from onika.web.page_window import PageWindow
from onika.words.reason import Reason

_KEPT = ("XDG_STATE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "ONIKA_LOCAL", "ONIKA_DIR")
"""What would lead out of the subject's home."""
_WINDOW = "1280x900+0+0"
"""Dictionary, workspace and workcell stand in it side by side."""


def purpose() -> Reason:
    """What the verb is for."""
    return Reason.of("cli.study_prepare")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the verb takes."""
    add_subject(parser)
    parser.add_argument("--variant", choices=VARIANTS, default="", help=say(Reason.of("cli.study_variant")))
    parser.add_argument("--window", type=window, metavar="SIZE", help=say(Reason.of("cli.page_window")))
    add_dictionaries(parser)
    add_calibration(parser)
    parser.add_argument("--open", action="store_true", help=say(Reason.of("cli.study_opens")))


def add_subject(parser: argparse.ArgumentParser) -> None:
    """The study and the subject."""
    parser.add_argument("study", type=Path, metavar="NAME", help=say(Reason.of("cli.study_of")))
    parser.add_argument("subject", metavar="SUBJECT", help=say(Reason.of("cli.study_whom")))


def carry_out(given: argparse.Namespace) -> int:
    """Do it, and start the page or say how; 2 where it is refused."""
    if not given.study.is_dir():
        return refused(Reason.of("cli.study_no_folder", path=str(given.study)))
    plan = planned(given.study, given.subject, given.variant)
    if isinstance(plan, Reason):
        return refused(plan)
    dictionaries = chosen_dictionaries(site_here([]), given.dictionary)
    if isinstance(dictionaries, Reason):
        return refused(dictionaries)
    if not is_calibrated(given):
        return 1
    session = prepare(given.study, given.subject, given.variant)
    if isinstance(session, Reason):
        return refused(session)
    for subject in session.put_away:
        print(say(Reason.of("cli.study_put_away", subject=subject)))
    shown = tuple(word for name in given.dictionary for word in ("--dictionary", name))
    words = (*page_words(session, given.window or PageWindow.read(_WINDOW)), *shown, *page_of_workcell(given))
    if given.open:
        print(say(Reason.of("cli.study_opened", subject=session.subject, variant=session.variant)), flush=True)
        _print_steps(session)
        return _carried_through(given.study, session, (*words, "--ends-with-window"))
    print(say(Reason.of("cli.study_ready", subject=session.subject, variant=session.variant)))
    unset = [word for name in _KEPT for word in ("-u", name)]
    print(f"  {shlex.join(['env', *unset, f'HOME={session.home}', 'onika', *words])}")
    _print_steps(session)
    ending = shlex.join(["onika", "study", "end", str(given.study), session.subject])
    print(say(Reason.of("cli.study_step_end", command=ending)))
    return 0


def page_words(session: Session, window: PageWindow) -> tuple[str, ...]:
    """How the page of a session is started: in its window, held to its variant, with its own empty programs."""
    return (
        "page", "--upper", "--presentation", session.variant, "--window", str(window),
        "--base", str(session.home / "programs"),
    )  # fmt: skip


def _print_steps(session: Session) -> None:
    is_words = session.variant == "words"
    print(say(Reason.of("cli.study_step_windows_words" if is_words else "cli.study_step_windows")))
    print(say(Reason.of("cli.study_step_cell")))


def _carried_through(study: Path, session: Session, words: tuple[str, ...]) -> int:
    """The page until its window is closed or it is ended by Ctrl-C, or this program by SIGTERM or SIGHUP; then the end.

    Where the page never came up, the session is taken back.
    """
    kept = {name: value for name, value in os.environ.items() if name not in _KEPT}
    command = [sys.executable, sys.argv[0], *words]
    page = subprocess.Popen(command, env={**kept, "HOME": str(session.home)})  # noqa: S603 - this very program
    with _passed_on(page):
        code: int | None = None
        while code is None:
            try:
                code = page.wait()
            except KeyboardInterrupt:
                continue  # the page hears it, too
    ended = end(study, session.subject)
    if isinstance(ended, Reason):
        return refused(ended)
    print(say(Reason.of("cli.study_ended", subject=session.subject)))
    return 0


@contextmanager
def _passed_on(page: subprocess.Popen[bytes]) -> Iterator[None]:
    """Within it SIGTERM and SIGHUP end the page, not this program: the session is still to be ended."""

    def pass_on(_number: int, _frame: FrameType | None) -> None:
        page.send_signal(signal.SIGTERM)

    former = {number: signal.signal(number, pass_on) for number in (signal.SIGTERM, signal.SIGHUP)}
    try:
        yield
    finally:
        for number, handler in former.items():
            signal.signal(number, handler)


def refused(why: Reason) -> int:
    """Say why; the exit code."""
    print(say(why), file=sys.stderr)
    return 2
