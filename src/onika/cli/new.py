"""`onika new module`: make a module, its `.rmod` and its test from a template."""

import argparse
import sys
from pathlib import Path

from onika.desk.plan.module_template import create_module


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("kind", choices=["module"], help="what to make")
    parser.add_argument("name", metavar="NAME", help="the name of the module and of its first task")
    parser.add_argument("--in", dest="base", type=Path, default=Path(), metavar="DIR", help="the base directory (here)")


def carry_out(given: argparse.Namespace) -> int:
    """Make it."""
    try:
        paths = create_module(given.name, given.base)
    except (ValueError, OSError) as wrong:
        print(wrong, file=sys.stderr)
        return 1
    for path in paths:
        print(path)
    print(f"try it: onika check {given.base}; python -m pytest {paths[-1]}")
    return 0
