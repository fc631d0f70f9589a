"""`onika runtime`: start a runtime and operate it by hand, by lines or by a script."""

import argparse
import sys
from contextlib import ExitStack

from onika.cli.argument_kinds import directory, scale, script_file
from onika.cli.language import say
from onika.cli.search_path import site_here
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.link.lost import LinkLost
from onika.words.name import TASK_NAME
from onika.words.reason import Reason

SHORTEST_S, LONGEST_S = 0.2, 3.0
"""Three beats; and after three seconds a session is lost altogether."""


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_runtime")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.set_defaults(complain=parser.error)
    parser.add_argument("--virtual", action="store_true", help=say(Reason.of("cli.runtime_virtual")))
    parser.add_argument("--scale", type=scale, metavar="X", help=say(Reason.of("cli.runtime_scale")))
    parser.add_argument(
        "--rtpu", action="append", default=[], type=unit, metavar="NAME",
        help=say(Reason.of("cli.runtime_rtpu")),
    )  # fmt: skip
    parser.add_argument("--script", type=script_file, metavar="FILE", help=say(Reason.of("cli.console_script")))
    parser.add_argument("--no-console", action="store_true", help=say(Reason.of("cli.runtime_no_console")))
    parser.add_argument("--hand-over", action="store_true", help=say(Reason.of("cli.runtime_hand_over")))
    parser.add_argument("--stay", action="store_true", help=say(Reason.of("cli.runtime_stay")))
    parser.add_argument("--listen", metavar="HOST:PORT", help=say(Reason.of("cli.runtime_listen")))
    parser.add_argument("--cert", metavar="FILE", help=say(Reason.of("cli.runtime_cert")))
    parser.add_argument("--key", metavar="FILE", help=say(Reason.of("cli.runtime_key")))
    parser.add_argument("--users", metavar="FILE", help=say(Reason.of("cli.runtime_users")))
    parser.add_argument("--name", action="append", default=[], metavar="HOST", help=say(Reason.of("cli.runtime_name")))
    parser.add_argument("--accept-code", action="store_true", help=say(Reason.of("cli.runtime_accept_code")))
    parser.add_argument(
        "--library", action="append", default=[], metavar="ADDRESS", help=say(Reason.of("cli.runtime_library"))
    )
    parser.add_argument("--audit", metavar="FILE", help=say(Reason.of("cli.runtime_audit")))
    parser.add_argument("--lease", type=lease, metavar="SECONDS", help=say(Reason.of("cli.runtime_lease")))
    parser.add_argument("--robot", metavar="NAME", help=say(Reason.of("cli.runtime_robot")))
    parser.add_argument("--book", metavar="FILE", help=say(Reason.of("cli.runtime_book")))
    parser.add_argument("--require-booking", action="store_true", help=say(Reason.of("cli.runtime_require_booking")))
    parser.add_argument("--no-fifo", action="store_true", help=say(Reason.of("cli.page_no_fifo")))
    parser.add_argument("--no-black-box", action="store_true", help=say(Reason.of("cli.no_black_box")))
    add_base(parser)


def carry_out(given: argparse.Namespace) -> int:
    """Start it and sit down at it."""
    from onika.cli.console_session import sit_down  # within: it takes long to load, and other commands use the rest

    listen = _listen(given)
    _judge(given, listens=bool(listen))
    rtpus = tuple(dict.fromkeys(given.rtpu)) or ("rt0",)
    site = site_here(given.base)
    scaled = () if given.scale is None else ("--scale", f"{given.scale:g}")
    is_virtual = given.virtual or given.scale is not None
    options = (*listen, *scaled, *_held(given), *_booked(given))
    if given.hand_over:
        return _hand_over(given, rtpus, is_virtual=is_virtual, options=options)
    launched = LaunchedRuntime(rtpus, is_virtual, not given.no_fifo, options, not given.no_black_box)
    with ExitStack() as stack:
        try:
            runtime = stack.enter_context(launched)
        except LinkLost as lost:
            # who asked to listen is told by the runtime itself what is missing for that
            if not listen:
                print(say(lost.reason), file=sys.stderr)
                return 1
            print(launched.printed().strip(), file=sys.stderr)
            return 2
        return sit_down(runtime, site, given.script, has_console=not given.no_console)


def _judge(given: argparse.Namespace, *, listens: bool) -> None:
    """End where options do not go together."""
    if given.stay and not given.hand_over:
        given.complain(say(Reason.of("cli.stay_by_hand_over")))
    if given.hand_over and (listens or given.script is not None):
        given.complain(say(Reason.of("cli.hand_over_alone")))
    if not given.robot and (given.book or given.require_booking):
        given.complain(say(Reason.of("cli.robot_expected")))
    if given.no_console and given.script is None and not listens:
        given.complain(say(Reason.of("cli.unreachable")))


def _hand_over(given: argparse.Namespace, rtpus: tuple[str, ...], *, is_virtual: bool, options: tuple[str, ...]) -> int:
    from onika.cli.hand_over import LISTEN, hand_over, hand_over_staying  # within: only who is called by ssh needs it

    if not given.stay:
        options = (*LISTEN, *options)
        return hand_over(LaunchedRuntime(rtpus, is_virtual, not given.no_fifo, options, not given.no_black_box))
    words = [word for name in rtpus for word in ("--rtpu", name)]
    words += ["--virtual"] * is_virtual + ["--no-fifo"] * given.no_fifo + ["--no-black-box"] * given.no_black_box
    return hand_over_staying((*words, *options))


def add_base(parser: argparse.ArgumentParser) -> None:
    """Where tasks, configurations and applications are looked for first."""
    parser.add_argument(
        "--base", "--local", action="append", default=[], type=directory, metavar="DIR",
        help=say(Reason.of("cli.runtime_local")),
    )  # fmt: skip


def _listen(given: argparse.Namespace) -> tuple[str, ...]:
    """The words for the runtime program about its network channel."""
    named = {"--cert": given.cert, "--key": given.key, "--users": given.users}
    words = [word for option, value in named.items() if value for word in (option, value)]
    words += [word for name in given.name for word in ("--name", name)]
    words += [word for address in given.library for word in ("--library", address)]
    words += ["--accept-code"] * given.accept_code
    if given.listen:
        return ("--listen", given.listen, *words)
    if words:
        given.complain(say(Reason.of("cli.listen_expected", option=words[0])))
    return ()


def _held(given: argparse.Namespace) -> tuple[str, ...]:
    """The words about who holds what, and where that is written down."""
    audit = () if given.audit is None else ("--audit", given.audit)
    if given.lease is None:
        return audit
    return (*audit, "--lease", f"{given.lease:g}")


def _booked(given: argparse.Namespace) -> tuple[str, ...]:
    """The words about the times for which its robot is booked."""
    if not given.robot:
        return ()
    book = ("--book", given.book) if given.book else ()
    return ("--robot", given.robot, *book, *(["--require-booking"] * given.require_booking))


def lease(text: str) -> float:
    """A time-out of holders; raises ArgumentTypeError for what is none."""
    try:
        seconds = float(text)
    except ValueError:
        seconds = 0.0
    if not SHORTEST_S <= seconds <= LONGEST_S:
        raise argparse.ArgumentTypeError(
            say(Reason.of("cli.lease_expected", least=SHORTEST_S, most=LONGEST_S, text=text))
        )
    return seconds


def unit(text: str) -> str:
    """The name of a processing unit; raises ArgumentTypeError for what is none."""
    if not TASK_NAME.match(text):
        raise argparse.ArgumentTypeError(say(Reason.of("cli.unit_expected", text=text)))
    return text
