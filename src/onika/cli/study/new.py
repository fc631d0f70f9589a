"""`onika study new`: a folder with the papers of a study (requirement H05)."""

import argparse
import sys
from pathlib import Path

from onika.cli.language import say
from onika.study.folder import SUBJECTS
from onika.study.kit import PAPERS, create
from onika.words.reason import Reason


def purpose() -> Reason:
    """What the verb is for."""
    return Reason.of("cli.study_new")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the verb takes."""
    parser.add_argument("study", type=Path, metavar="NAME", help=say(Reason.of("cli.study_new_name")))


def carry_out(given: argparse.Namespace) -> int:
    """Make it; 2 where something of that name is there."""
    try:
        create(given.study)
    except FileExistsError:
        print(say(Reason.of("cli.study_there", path=str(given.study))), file=sys.stderr)
        return 2
    print(say(Reason.of("cli.study_made", path=str(given.study / PAPERS), table=str(given.study / SUBJECTS))))
    return 0
