"""The verbs of `onika study`; each is a file beside this one."""

import argparse
from types import ModuleType

from onika.cli.language import say
from onika.cli.study import design, end, log, new, prepare, replay, report
from onika.words.reason import Reason

VERBS: dict[str, ModuleType] = {
    "new": new,
    "design": design,
    "prepare": prepare,
    "end": end,
    "report": report,
    "log": log,
    "replay": replay,
}
"""In the order in which the help shows them."""


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_study")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    verbs = parser.add_subparsers(dest="verb", metavar="VERB", required=True)
    for name, verb in VERBS.items():
        verb.describe(verbs.add_parser(name, help=say(verb.purpose())))


def carry_out(given: argparse.Namespace) -> int:
    """Do it; the exit code is that of the verb."""
    code: int = VERBS[given.verb].carry_out(given)
    return code
