"""`onika run`: run an application on a robot or simulator, headless."""

import argparse
import re
from contextlib import ExitStack
from pathlib import Path

from onika.cli.argument_kinds import (
    answer_of,
    directory,
    expectation_of,
    redirect_of,
    runtime_address,
    scale,
    script_file,
    seconds_of,
)
from onika.cli.language import say
from onika.link.child.launcher import RuntimeStart
from onika.link.token import read_token
from onika.words.reason import Reason, reason_of


def purpose() -> Reason:
    """What the command is for."""
    return Reason.of("cli.purpose_run")


def describe(parser: argparse.ArgumentParser) -> None:
    """What the command takes."""
    parser.set_defaults(complain=parser.error)
    parser.add_argument(
        "application", nargs="?", default="", metavar="NAME|FILE", help=say(Reason.of("cli.run_application"))
    )
    parser.add_argument("--record", type=_new_file, metavar="RUN.mcap", help=say(Reason.of("cli.run_record")))
    parser.add_argument(
        "--from", dest="source", type=Path, metavar="RUN.mcap",
        help=say(Reason.of("cli.run_from")),
    )  # fmt: skip
    parser.add_argument(
        "--at", action="append", default=[], type=_at, metavar="S|FLOW=URL", help=say(Reason.of("cli.run_at"))
    )
    parser.add_argument("--virtual", action="store_true", help=say(Reason.of("cli.run_virtual")))
    parser.add_argument(
        "--expect", action="append", default=[], type=expectation_of, metavar="'LAMP == 1'",
        help=say(Reason.of("cli.run_expect")),
    )  # fmt: skip
    parser.add_argument("--settle", type=seconds_of, default=0.5, metavar="S", help=say(Reason.of("cli.run_settle")))
    parser.add_argument(
        "--answer", action="append", default=[], type=answer_of, metavar="TASK.NAME=VALUES",
        help=say(Reason.of("cli.run_answer")),
    )  # fmt: skip
    parser.add_argument("--picture", type=_new_file, metavar="OUT.png", help=say(Reason.of("cli.run_picture")))
    parser.add_argument("--keep-test", type=_new_file, metavar="OUT.test", help=say(Reason.of("cli.run_keep_test")))
    parser.add_argument("--json", action="store_true", help=say(Reason.of("cli.run_json")))
    parser.add_argument("--seed", type=_whole, default=0, metavar="N", help=say(Reason.of("cli.run_seed")))
    parser.add_argument("--shake", type=_whole, metavar="N", help=say(Reason.of("cli.run_shake")))
    parser.add_argument(
        "--vary", action="append", default=[], type=_value, metavar="TASK.NAME=VALUE",
        help=say(Reason.of("cli.run_vary")),
    )  # fmt: skip
    parser.add_argument(
        "--local", action="append", default=[], type=directory, metavar="DIR", help=say(Reason.of("cli.check_local"))
    )
    parser.add_argument("--no-fifo", action="store_true", help=say(Reason.of("cli.page_no_fifo")))
    parser.add_argument("--no-black-box", action="store_true", help=say(Reason.of("cli.no_black_box")))
    parser.add_argument("--runtime", type=runtime_address, metavar="URL", help=say(Reason.of("cli.run_runtime")))
    parser.add_argument(
        "--token-file", dest="tokens", action="append", default=[], type=_token, metavar="[FLOW=]FILE",
        help=say(Reason.of("cli.run_token_file")),
    )  # fmt: skip
    parser.add_argument("--scale", type=scale, metavar="X", help=say(Reason.of("cli.run_scale")))
    parser.add_argument(
        "--subsystem", action="append", default=[], metavar="NAME", help=say(Reason.of("cli.run_subsystem"))
    )
    parser.add_argument(
        "--redirect", action="append", default=[], type=redirect_of, metavar="[FLOW:]OLD=NEW",
        help=say(Reason.of("cli.run_redirect")),
    )  # fmt: skip
    parser.add_argument("--script", type=script_file, metavar="FILE", help=say(Reason.of("cli.run_script")))
    parser.add_argument(
        "--on-error", choices=("abort", "wait"),
        help=say(Reason.of("cli.run_on_error")),
    )  # fmt: skip
    parser.add_argument(
        "--on-loss", choices=("stop", "finish", "run"), default="stop",
        help=say(Reason.of("cli.run_on_loss")),
    )  # fmt: skip
    parser.add_argument("--ca", type=Path, metavar="FILE", help=say(Reason.of("cli.run_ca")))


def carry_out(given: argparse.Namespace) -> int:
    """Run it."""
    if bool(given.application) == (given.source is not None):
        given.complain(say(Reason.of("cli.no_application")))
    instants = [at for at in given.at if isinstance(at, float)]
    if instants and (given.source is None or len(given.at) > 1):
        given.complain(say(Reason.of("cli.at_alone")))
    with ExitStack() as ending:
        start = None if given.runtime is not None or given.at else ending.enter_context(_start(given))
        from onika.cli.headless_run import run_application  # within: the runtime comes up meanwhile

        return run_application(given, start)


def _start(given: argparse.Namespace) -> RuntimeStart:
    """The runtime, whose libraries take as long to load as those of this program."""
    virtual = is_virtual(given)
    return RuntimeStart(["--virtual"] * virtual, has_modules=virtual, has_more=True)


def is_virtual(given: argparse.Namespace) -> bool:
    """Whether time is virtual, as it is wherever something is repeated or scaled, too."""
    return given.virtual or given.scale is not None or given.source is not None


def _token(text: str) -> tuple[str, str]:
    """The flow that it is for, empty: any, and the token."""
    flow, equals, path = text.partition("=")
    try:
        return (flow.strip(), read_token(Path(path))) if equals else ("", read_token(Path(text)))
    except (OSError, ValueError) as wrong:
        raise argparse.ArgumentTypeError(say(Reason.of("cli.token_expected", reason=reason_of(wrong)))) from None


def _new_file(text: str) -> Path:
    path = Path(text)
    if path.is_dir() or not path.absolute().parent.is_dir():
        raise argparse.ArgumentTypeError(say(Reason.of("cli.new_file_expected", text=text)))
    return path


def _instant(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = -1.0
    if not 0.0 <= seconds <= 1e6:
        raise argparse.ArgumentTypeError(say(Reason.of("cli.seconds_expected", most="1000000", text=text)))
    return seconds


def _at(text: str) -> float | tuple[str, str]:
    """An instant, or a flow and the runtime where it runs."""
    flow, equals, url = text.partition("=")
    return (flow.strip(), runtime_address(url)) if equals else _instant(text)


def _whole(text: str) -> int:
    if not re.fullmatch(r"[+-]?[0-9]{1,18}", text):
        raise argparse.ArgumentTypeError(say(Reason.of("cli.whole_expected", digits=18, text=text)))
    return int(text)


def _value(text: str) -> tuple[str, float]:
    from onika.desk.sweep.variation import Variation  # within: only who varies something needs it

    try:
        variation = Variation.parse(text)
        if len(variation.choices) != 1:
            raise ValueError(Reason.of("sweep.one_value", text=text))
    except ValueError as wrong:
        raise argparse.ArgumentTypeError(say(reason_of(wrong))) from None
    return variation.name, variation.choices[0]
