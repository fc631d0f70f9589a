"""`onika icon`: make the icon of a configuration or an application."""

import argparse
import sys
from pathlib import Path

from onika.cli.search_path import directory, site_here
from onika.desk.plan.iconify import Made, iconify


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("path", type=Path, metavar="FILE", help="NAME.conf or NAME.appl of a base directory")
    parser.add_argument("--desc", metavar="TEXT", help="what it does, in a few words")
    parser.add_argument("--picture", type=Path, metavar="FILE.onk", help="an icon whose picture it takes")
    parser.add_argument("--replace", action="store_true", help="replace the icon of something else of that name")
    parser.add_argument(
        "--local", action="append", default=[], type=directory, metavar="DIR", help="a base directory to look in first"
    )


def carry_out(given: argparse.Namespace) -> int:
    """Make it; 0 if it was made."""
    made = iconify(
        given.path,
        site_here(given.local),
        description=given.desc,
        picture=given.picture,
        replaces=given.replace,
    )
    if not isinstance(made, Made):
        for reason in made:
            print(reason, file=sys.stderr)
        return 1
    for note in made.notes:
        print(f"note: {note}")
    print(f"{made.path}: {' with '.join((made.onikon.type, *made.onikon.more_targets))}")
    return 0
