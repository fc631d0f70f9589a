"""`onika new module`: make a module, its `.rmod` and its test from a template."""

import argparse
import sys
from pathlib import Path

from onika.cli.language import say
from onika.desk.plan.module_template import create_module
from onika.words.reason import Reason, reason_of


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_new")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("kind", choices=["module"], help=say(Reason.of("cli.new_kind")))
    parser.add_argument("name", metavar="NAME", help=say(Reason.of("cli.new_name")))
    parser.add_argument(
        "--in", dest="base", type=Path, default=Path(), metavar="DIR", help=say(Reason.of("cli.new_in"))
    )


def carry_out(given: argparse.Namespace) -> int:
    """Make it."""
    try:
        paths = create_module(given.name, given.base)
    except (ValueError, OSError) as wrong:
        print(say(reason_of(wrong)), file=sys.stderr)
        return 1
    for path in paths:
        print(path)
    print(say(Reason.of("cli.new_next", base=str(given.base), test=str(paths[-1]))))
    return 0
