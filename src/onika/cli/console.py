"""`onika console`: operate a runtime by hand that runs already."""

import argparse
from pathlib import Path

from onika.cli.argument_kinds import script_file
from onika.cli.console_session import sit_down
from onika.cli.language import say
from onika.cli.runtime import add_base
from onika.cli.search_path import site_here
from onika.desk.run.remote_runtime import connect
from onika.link.token import read_token
from onika.words.reason import Reason, reason_of


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_console")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.set_defaults(complain=parser.error)
    parser.add_argument("url", metavar="URL", help=say(Reason.of("cli.console_url")))
    parser.add_argument("--token-file", type=Path, metavar="FILE", help=say(Reason.of("cli.console_token_file")))
    parser.add_argument("--ca", type=Path, metavar="FILE", help=say(Reason.of("cli.console_ca")))
    parser.add_argument("--script", type=script_file, metavar="FILE", help=say(Reason.of("cli.console_script")))
    parser.add_argument("--no-console", action="store_true", help=say(Reason.of("cli.console_no_console")))
    add_base(parser)


def carry_out(given: argparse.Namespace) -> int:
    """Connect and sit down at it; the runtime lives on afterwards."""
    if given.no_console and given.script is None:
        given.complain(say(Reason.of("cli.nothing_to_do")))
    try:
        token = "" if given.token_file is None else read_token(given.token_file)
        reached = connect(given.url, token, given.ca)
    except ValueError as wrong:
        given.complain(say(reason_of(wrong)))
    with reached as runtime:
        return sit_down(runtime, site_here(given.base), given.script, has_console=not given.no_console)
