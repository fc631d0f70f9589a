"""`onika study design`: who comes when, with which variant (requirement H03)."""

import argparse
import sys
from pathlib import Path

from onika.cli.language import say
from onika.files import whole
from onika.study.design import order
from onika.study.table import written
from onika.words.fault import Refusal
from onika.words.reason import Reason

_MOST = 10_000
_MOST_SEED = 2**31 - 1


def purpose() -> Reason:
    """What the verb is for."""
    return Reason.of("cli.study_design")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the verb takes."""
    variants, subjects = say(Reason.of("cli.study_variants")), say(Reason.of("cli.study_subjects"))
    parser.add_argument("--variants", type=_variants, required=True, metavar="A,B,C", help=variants)
    parser.add_argument("--subjects", type=_count, required=True, metavar="N", help=subjects)
    seed = say(Reason.of("cli.study_seed", default=0))
    parser.add_argument("--seed", type=_seed, default=0, metavar="N", help=seed)
    parser.add_argument("-o", dest="out", type=Path, metavar="FILE", help=say(Reason.of("cli.study_design_out")))
    parser.set_defaults(complain=parser.error)


def carry_out(given: argparse.Namespace) -> int:
    """Print or write the table; 2 where the file is there already."""
    if given.subjects < len(given.variants):
        few = Reason.of("cli.study_too_few", least=len(given.variants), count=given.subjects)
        given.complain(say(few))
    text = written(("subject", "group"), order(given.variants, given.subjects, given.seed))
    if given.out is None:
        sys.stdout.write(text)
        return 0
    outcome = whole.write(given.out, text, whole.ABSENT)
    if isinstance(outcome, Refusal):
        print(say(outcome.sentence), file=sys.stderr)
        return 2
    print(given.out)
    return 0


def _variants(text: str) -> tuple[str, ...]:
    names = tuple(name.strip() for name in text.split(","))
    if len(names) < 2 or "" in names or len(set(names)) < len(names) or not text.isprintable():
        raise argparse.ArgumentTypeError(say(Reason.of("cli.study_no_variants", text=text)))
    return names


def _count(text: str) -> int:
    return _whole(text, 1, _MOST)


def _seed(text: str) -> int:
    return _whole(text, 0, _MOST_SEED)


def _whole(text: str, low: int, high: int) -> int:
    if text.isdecimal() and text.isascii() and len(text) < 12 and low <= int(text) <= high:
        return int(text)
    raise argparse.ArgumentTypeError(say(Reason.of("cli.study_whole", low=low, high=high, text=text)))
