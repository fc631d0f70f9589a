"""`onika new module`, `guest`, `robot`: a module or a guest from a template, or of a model all that runs a robot."""

import argparse
import sys
from importlib.util import find_spec
from pathlib import Path

from onika.cli.language import say
from onika.cli.search_path import site_here
from onika.desk.plan.guest_template import create_guest
from onika.desk.plan.module_template import create_module
from onika.desk.plan.robot_files import create_robot
from onika.words.reason import Reason, reason_of


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_new")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("kind", choices=["module", "guest", "robot"], help=say(Reason.of("cli.new_kind")))
    parser.add_argument("name", metavar="NAME", help=say(Reason.of("cli.new_name")))
    parser.add_argument(
        "--in", dest="base", type=Path, default=Path(), metavar="DIR", help=say(Reason.of("cli.new_in"))
    )
    parser.add_argument("--name", dest="called", default="", metavar="NAME", help=say(Reason.of("cli.new_robot_name")))


def carry_out(given: argparse.Namespace) -> int:
    """Make it."""
    try:
        return _robot(given) if given.kind == "robot" else _from_template(given)
    except (ValueError, OSError) as wrong:
        print(say(reason_of(wrong)), file=sys.stderr)
        return 1


def _from_template(given: argparse.Namespace) -> int:
    create = create_guest if given.kind == "guest" else create_module
    paths = create(given.name, given.base)
    for path in paths:
        print(path)
    key = "cli.new_next" if find_spec("pytest") else "cli.new_next_with_pytest"
    print(say(Reason.of(key, base=str(given.base), test=str(paths[-1]))))
    return 0


def _robot(given: argparse.Namespace) -> int:
    made = create_robot(Path(given.name), given.base, site_here([]), given.called, say)
    for path in made.paths:
        print(path)
    for note in made.notes:
        print(say(Reason.of("cli.note", text=note)))
    print(say(Reason.of("cli.new_robot_next", base=str(given.base), tour=made.tour)))
    return 0
