"""`onika runtime`: start a runtime and operate it by hand, by lines or by a script."""

import argparse
import re
import sys
from contextlib import ExitStack
from pathlib import Path

from onika.cli.console_session import sit_down
from onika.cli.search_path import directory, site_here
from onika.cli.time_scale import scale
from onika.desk.run.runtime import Runtime
from onika.link.lost import LinkLost
from onika.words.name import TASK_NAME

SHORTEST_S, LONGEST_S = 0.2, 3.0
"""Three beats; and after three seconds a session is lost altogether."""
_LISTENING = re.compile(r"^onika runtime: listening on ([^\s,]+)", re.MULTILINE)


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.set_defaults(complain=parser.error)
    parser.add_argument("--virtual", action="store_true", help="in virtual time, which passes when a line says so")
    parser.add_argument(
        "--scale", type=scale, metavar="X", help="in virtual time that passes by itself, X times as fast as wall time"
    )
    parser.add_argument(
        "--rtpu", action="append", default=[], type=unit, metavar="NAME",
        help="a processing unit; may be given several times (rt0)",
    )  # fmt: skip
    parser.add_argument("--script", type=script_file, metavar="FILE", help="lines to carry out first")
    parser.add_argument(
        "--no-console", action="store_true", help="end after the script, or only serve those who connect"
    )
    parser.add_argument("--listen", metavar="HOST:PORT", help="let others connect; on this machine with a token")
    parser.add_argument("--cert", metavar="FILE", help="certificate, to listen to other machines")
    parser.add_argument("--key", metavar="FILE", help="key of the certificate")
    parser.add_argument("--users", metavar="FILE", help="who may connect: lines of name, role, SHA-256 of a token")
    parser.add_argument("--name", action="append", default=[], metavar="HOST", help="another name of this machine")
    parser.add_argument("--accept-code", action="store_true", help="take modules from other machines, too")
    parser.add_argument(
        "--audit",
        metavar="FILE",
        help="where commands and changes of holder are written down (~/.local/state); off: nowhere",
    )
    parser.add_argument(
        "--lease",
        type=lease,
        metavar="SECONDS",
        help="after how long a silent holder holds nothing any more (as the way allows, 0.25 to 1.0)",
    )
    parser.add_argument("--no-fifo", action="store_true", help="do not ask for real-time scheduling")
    add_base(parser)


def carry_out(given: argparse.Namespace) -> int:
    """Start it and sit down at it."""
    listen = _listen(given)
    if given.no_console and given.script is None and not listen:
        given.complain("expected --listen or --script with --no-console, found neither: nobody could reach the runtime")
    rtpus = tuple(dict.fromkeys(given.rtpu)) or ("rt0",)
    site = site_here(given.base)
    scaled = () if given.scale is None else ("--scale", f"{given.scale:g}")
    is_virtual = given.virtual or given.scale is not None
    launched = Runtime(rtpus, is_virtual, not given.no_fifo, (*listen, *scaled, *_held(given)))
    with ExitStack() as stack:
        try:
            runtime = stack.enter_context(launched)
        except LinkLost as lost:
            # who asked to listen is told by the runtime itself what is missing for that
            print(launched.printed().strip() if listen else lost, file=sys.stderr)
            return 2 if listen else 1
        addresses = tuple(_LISTENING.findall(runtime.printed())) if listen else ()
        return sit_down(runtime, site, given.script, has_console=not given.no_console, addresses=addresses)


def add_base(parser: argparse.ArgumentParser) -> None:
    """Where tasks, configurations and applications are looked for first."""
    parser.add_argument(
        "--base", "--local", action="append", default=[], type=directory, metavar="DIR",
        help="a base directory to look in first; may be given several times",
    )  # fmt: skip


def script_file(text: str) -> Path:
    """A script on the command line; raises ArgumentTypeError where there is none."""
    path = Path(text)
    if not path.is_file():
        raise argparse.ArgumentTypeError(f"expected a file of lines, found none at {text!r}")
    return path


def _listen(given: argparse.Namespace) -> tuple[str, ...]:
    """The words for the runtime program about its network channel."""
    named = {"--cert": given.cert, "--key": given.key, "--users": given.users}
    words = [word for option, value in named.items() if value for word in (option, value)]
    words += [word for name in given.name for word in ("--name", name)]
    words += ["--accept-code"] * given.accept_code
    if given.listen:
        return ("--listen", given.listen, *words)
    if words:
        given.complain(f"expected --listen HOST:PORT with {words[0]}, found none")
    return ()


def _held(given: argparse.Namespace) -> tuple[str, ...]:
    """The words about who holds what, and where that is written down."""
    audit = () if given.audit is None else ("--audit", given.audit)
    return audit if given.lease is None else (*audit, "--lease", f"{given.lease:g}")


def lease(text: str) -> float:
    """A time-out of holders; raises ArgumentTypeError for what is none."""
    try:
        seconds = float(text)
    except ValueError:
        seconds = 0.0
    if not SHORTEST_S <= seconds <= LONGEST_S:
        raise argparse.ArgumentTypeError(f"expected {SHORTEST_S:g} to {LONGEST_S:g} seconds, found {text!r}")
    return seconds


def unit(text: str) -> str:
    """The name of a processing unit; raises ArgumentTypeError for what is none."""
    if not TASK_NAME.match(text):
        expected = "a name of letters, digits and _ . - that begins with a letter"
        raise argparse.ArgumentTypeError(f"expected {expected}, found {text!r}")
    return text
