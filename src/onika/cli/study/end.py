"""`onika study end`: the session of a subject is ended, and its log stands where the report reads it (H09)."""

import argparse

from onika.cli.language import say
from onika.cli.study.prepare import add_subject, refused
from onika.study.preparation import end
from onika.words.reason import Reason


def purpose() -> Reason:
    """What the verb is for."""
    return Reason.of("cli.study_end")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the verb takes."""
    add_subject(parser)


def carry_out(given: argparse.Namespace) -> int:
    """Do it; 2 where it is refused."""
    paths = end(given.study, given.subject)
    if isinstance(paths, Reason):
        return refused(paths)
    for path in paths:
        print(path)
    print(say(Reason.of("cli.study_ended", subject=given.subject)))
    return 0
