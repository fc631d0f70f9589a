"""`onika study prepare`: the session of a subject is readied (requirement H09)."""

import argparse
import shlex
import sys
from pathlib import Path

from onika.cli.language import say
from onika.study.preparation import VARIANTS, prepare
from onika.words.reason import Reason

_KEPT = ("XDG_STATE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "ONIKA_LOCAL", "ONIKA_DIR")
"""What would lead out of the subject's home."""


def purpose() -> Reason:
    """What the verb is for."""
    return Reason.of("cli.study_prepare")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the verb takes."""
    add_subject(parser)
    parser.add_argument("--variant", choices=VARIANTS, default="", help=say(Reason.of("cli.study_variant")))


def add_subject(parser: argparse.ArgumentParser) -> None:
    """The study and the subject."""
    parser.add_argument("study", type=Path, metavar="NAME", help=say(Reason.of("cli.study_of")))
    parser.add_argument("subject", metavar="SUBJECT", help=say(Reason.of("cli.study_whom")))


def carry_out(given: argparse.Namespace) -> int:
    """Do it, and say how the page is started; 2 where it is refused."""
    if not given.study.is_dir():
        return refused(Reason.of("cli.study_no_folder", path=str(given.study)))
    session = prepare(given.study, given.subject, given.variant)
    if isinstance(session, Reason):
        return refused(session)
    unset = [word for name in _KEPT for word in ("-u", name)]
    programs = str(session.home / "programs")
    command = shlex.join(
        ["env", *unset, f"HOME={session.home}", "onika", "page", "--upper", "--no-browser", "--base", programs]
    )
    print(say(Reason.of("cli.study_ready", subject=session.subject, variant=session.variant)))
    print(f"  {command}")
    ending = shlex.join(["onika", "study", "end", str(given.study), session.subject])
    print(say(Reason.of("cli.study_step_variant", variant=session.variant)))
    print(say(Reason.of("cli.study_step_windows")))
    print(say(Reason.of("cli.study_step_cell")))
    print(say(Reason.of("cli.study_step_end", command=ending)))
    return 0


def refused(why: Reason) -> int:
    """Say why; the exit code."""
    print(say(why), file=sys.stderr)
    return 2
