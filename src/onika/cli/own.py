"""`onika own`: the files of one's own that stand before shipped ones, what differs, and the way back."""

import argparse
import difflib
import os
import sys
import time
from pathlib import Path

from onika.cli.argument_kinds import directory
from onika.cli.language import say
from onika.cli.search_path import site_here
from onika.files.state.state_directory import state_directory
from onika.store.own_copy import OwnCopy, gone_back, own_copies, own_copy
from onika.store.replaced_texts import ReplacedTexts
from onika.store.site import Site
from onika.words.fault import Refusal
from onika.words.reason import Reason


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_own")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.add_argument("path", nargs="?", type=Path, metavar="FILE", help=say(Reason.of("cli.own_path")))
    parser.add_argument("--back", action="store_true", help=say(Reason.of("cli.own_back")))
    parser.add_argument(
        "--local", action="append", default=[], type=directory, metavar="DIR", help=say(Reason.of("cli.check_local"))
    )


def carry_out(given: argparse.Namespace) -> int:
    """List them, show what differs of one, or go back from it; 0 where that could be done."""
    site = site_here(given.local)
    if given.path is None:
        for copy in own_copies(site):
            print(say(Reason.of("cli.own_over", path=str(copy.own), base=copy.laboratory)))
        return 0
    chosen = own_copy(given.path.absolute(), site)
    if chosen is None:
        return _no(Reason.of("desk.no_own_copy", path=str(given.path)))
    return _back(chosen, site) if given.back else _compared(chosen)


def _compared(copy: OwnCopy) -> int:
    both = copy.texts()
    if isinstance(both, Refusal):
        return _no(both.reason)
    own, shipped = (text.splitlines(keepends=True) for text in both)
    for line in difflib.unified_diff(shipped, own, str(copy.shipped), str(copy.own)):
        print(line.rstrip("\r\n"))
    return 0


def _back(copy: OwnCopy, site: Site) -> int:
    done = gone_back(copy, site, ReplacedTexts(state_directory(os.environ)), time.time())
    if isinstance(done, Refusal):
        return _no(done.reason)
    print(say(Reason.of("desk.gone_back", path=str(copy.own), base=copy.laboratory)))
    return 0


def _no(reason: Reason) -> int:
    print(say(reason), file=sys.stderr)
    return 1
