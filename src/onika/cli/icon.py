"""`onika icon`: make the icon of a configuration or an application."""

import argparse
import sys
from pathlib import Path

from onika.cli.argument_kinds import directory
from onika.cli.language import say
from onika.cli.search_path import site_here
from onika.desk.plan.iconify import IconifiedFile, iconify
from onika.words.reason import Reason


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_icon")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("path", type=Path, metavar="FILE", help=say(Reason.of("cli.icon_path")))
    parser.add_argument("--desc", metavar="TEXT", help=say(Reason.of("cli.icon_desc")))
    parser.add_argument("--picture", type=Path, metavar="FILE.onk", help=say(Reason.of("cli.icon_picture")))
    parser.add_argument("--replace", action="store_true", help=say(Reason.of("cli.icon_replace")))
    parser.add_argument(
        "--local", action="append", default=[], type=directory, metavar="DIR", help=say(Reason.of("cli.check_local"))
    )


def carry_out(given: argparse.Namespace) -> int:
    """Make it; 0 if it was made."""
    made = iconify(
        given.path, site_here(given.local), description=given.desc, picture=given.picture, replaces=given.replace
    )
    if not isinstance(made, IconifiedFile):
        for reason in made:
            print(say(reason.sentence), file=sys.stderr)
        return 1
    for note in made.notes:
        print(say(Reason.of("cli.note", text=note.sentence)))
    path, kind, targets = str(made.path), made.onikon.type, made.onikon.more_targets
    if targets:
        print(say(Reason.of("cli.icon_made_with", path=path, kind=kind, targets=targets)))
    else:
        print(say(Reason.of("cli.icon_made", path=path, kind=kind)))
    return 0
