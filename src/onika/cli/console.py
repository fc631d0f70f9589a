"""`onika console`: operate a runtime by hand that runs already."""

import argparse
from pathlib import Path

from onika.cli.console_session import sit_down
from onika.cli.runtime import add_base, script_file
from onika.cli.search_path import site_here
from onika.desk.run.runtime import connect
from onika.link.token import read_token


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.set_defaults(complain=parser.error)
    parser.add_argument("url", metavar="URL", help="ws://HOST:PORT on this machine, wss://HOST:PORT on another")
    parser.add_argument(
        "--token-file", type=Path, metavar="FILE", help="the token (ONIKA_TOKEN; here that of this user)"
    )
    parser.add_argument("--ca", type=Path, metavar="FILE", help="certificates to trust beside the system's")
    parser.add_argument("--script", type=script_file, metavar="FILE", help="lines to carry out first")
    parser.add_argument("--no-console", action="store_true", help="end after the script")
    add_base(parser)


def carry_out(given: argparse.Namespace) -> int:
    """Connect and sit down at it; the runtime lives on afterwards."""
    if given.no_console and given.script is None:
        given.complain("expected --script with --no-console, found none: there is nothing to do")
    try:
        token = "" if given.token_file is None else read_token(given.token_file)
        reached = connect(given.url, token, given.ca)
    except ValueError as wrong:
        given.complain(str(wrong))
    with reached as runtime:
        return sit_down(runtime, site_here(given.base), given.script, has_console=not given.no_console)
