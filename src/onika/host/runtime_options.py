"""The command line of a runtime."""

import argparse
import json
import os

from onika.words.own_language import own_language
from onika.words.reason import Reason, in_language


def options(words: list[str]) -> argparse.Namespace:
    """What is given; the end, with the reason, where that is wrong or nobody could come in."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--link-fd", type=int)
    parser.add_argument("--parent", type=int)
    parser.add_argument("--options-fd", type=int)
    parser.add_argument("--last-words", type=int)
    parser.add_argument("--virtual", action="store_true")
    parser.add_argument("--scale", type=float)
    parser.add_argument("--shake", type=int)
    parser.add_argument("--world-value", action="append", default=[])
    parser.add_argument("--forecast", action="store_true")
    parser.add_argument("--no-fifo", action="store_true")
    parser.add_argument("--no-black-box", action="store_true")
    parser.add_argument("--audit", default="")
    parser.add_argument("--lease", type=float)
    parser.add_argument("--rtpu", action="append", default=[])
    parser.add_argument("--listen", default="", metavar="HOST:PORT")
    parser.add_argument("--cert", default="")
    parser.add_argument("--key", default="")
    parser.add_argument("--users", default="")
    parser.add_argument("--name", action="append", default=[])
    parser.add_argument("--accept-code", action="store_true")
    parser.add_argument("--library", action="append", default=[], metavar="ADDRESS")
    parser.add_argument("--stay", default="", metavar="FILE")
    parser.add_argument("--robot", default="", metavar="NAME")
    parser.add_argument("--book", default="", metavar="FILE")
    parser.add_argument("--require-booking", action="store_true")
    parser.add_argument("--world", action="append", default=[], metavar="NAME")
    given = parser.parse_args(words)
    if (given.link_fd is None) != (given.parent is None) or (given.link_fd is None and not given.listen):
        parser.error(in_language(Reason.of("host.no_way_in"), own_language()))
    return given


def followed(words: list[str], descriptor: int) -> argparse.Namespace:
    """These options and those that follow on a descriptor, as JSON; the quiet end where it is closed without any."""
    with os.fdopen(descriptor, "rb") as source:
        more = source.read()
    if not more:
        raise SystemExit(0)
    return options([*words, *json.loads(more)])
