"""`onika run`: run an application on a robot or simulator, headless."""

import argparse
import os
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, TextIO

from onika.cli.language import say
from onika.cli.lines.json_lines import JsonLines
from onika.cli.orderly_exit import in_order
from onika.cli.plain_display import PlainDisplay
from onika.cli.runtime import script_file
from onika.cli.search_path import directory, site_here
from onika.cli.time_scale import scale
from onika.desk.run import world_picture
from onika.desk.run.outcome import Outcome
from onika.desk.run.run import Opens, run
from onika.desk.run.settings import RecordingSource, RunSettings, RuntimeLocation
from onika.desk.sweep.variation import Variation
from onika.link.starting.runtime_address import address_of
from onika.link.token import read_token
from onika.model.redirect import Redirect
from onika.store.site import Site
from onika.words.condition import Condition
from onika.words.reason import NOTHING, Reason, reason_of

if TYPE_CHECKING:
    from onika.cli.live_display import LiveDisplay


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
    watcher = _watcher(given)
    settings = _settings(given, watcher.can_steer)
    objection = NOTHING if given.keep_test is None else _unkeepable(settings, given.keep_test)
    if objection:
        given.complain(say(Reason.of("cli.not_kept", objection=objection)))
    with in_order(), watcher:
        outcome = run(settings, site_here(given.local), watcher, _opens(settings))
    drawn = _draw(outcome, given.picture) if given.picture is not None else NOTHING
    watcher.ended(outcome, drawn)
    if given.keep_test is not None and outcome.exit_code == 0:
        return _keep(given.keep_test, settings, site_here(given.local), outcome)
    return outcome.exit_code


def _watcher(given: argparse.Namespace) -> "JsonLines | LiveDisplay | PlainDisplay":
    """What shows the run: JSON for programs, a live display on a terminal that can do it, else plain lines."""
    if given.json:
        return JsonLines()
    if _is_terminal(sys.stdout) and os.environ.get("TERM") != "dumb":
        from onika.cli.live_display import LiveDisplay  # within: its libraries take long to load

        return LiveDisplay()
    return PlainDisplay()


def _settings(given: argparse.Namespace, can_steer: bool) -> RunSettings:
    return RunSettings(
        name=given.application,
        is_virtual=given.virtual or given.scale is not None or given.source is not None,
        expectations=tuple(given.expect),
        settle_s=given.settle,
        seed=given.seed,
        answers=joined_answers(given.answer),
        may_ask=_is_terminal(sys.stdin) and not given.json,
        wants_picture=given.picture is not None,
        with_fifo=not given.no_fifo,
        has_black_box=not given.no_black_box,
        scale=given.scale,
        subsystems=tuple(given.subsystem),
        on_loss=given.on_loss,
        on_error=given.on_error or ("wait" if can_steer or given.script is not None else "abort"),
        script=given.script,
        redirects=tuple(given.redirect),
        shake=given.shake,
        values=tuple(given.vary),
        record=given.record,
        source=None if given.source is None else RecordingSource(given.source, given.at[0] if given.at else None),
        places=_places(given),
        elsewhere=None if given.runtime is None else RuntimeLocation(given.runtime, _token_of("", given), given.ca),
    )


def _opens(settings: RunSettings) -> Opens | None:
    """What the flows run on where they run on several runtimes."""
    if not settings.places:
        return None
    from onika.desk.joined.joined_runtimes import opens  # within: only who joins runtimes needs all that

    return opens(settings)


def _unkeepable(settings: RunSettings, path: Path) -> Reason:
    """Why such a run cannot be kept as a test."""
    from onika.desk.trial.keeping import unkeepable  # within: only who keeps a test needs all that

    return unkeepable(settings, path)


def _keep(path: Path, settings: RunSettings, site: Site, outcome: Outcome) -> int:
    """Keep the run as a test; told on the error output, as JSON lines may go to the other one."""
    from onika.desk.trial.keeping import keep_in  # within: only who keeps a test needs all that

    seen = outcome.result.hash if outcome.result is not None else ""
    with in_order():
        is_kept, report = keep_in(path, settings, site, workers=os.cpu_count() or 1, seen=seen, say=say)
    if not is_kept:
        for reason in report:
            sys.stderr.write(f"{say(Reason.of('cli.test_not_kept', line=reason))}\n")
        return 1
    content, *notes = report
    for line in (Reason.of("cli.test_in", path=str(path), content=content), *notes):
        sys.stderr.write(f"{say(Reason.of('cli.test_kept', line=line))}\n")
    return 0


def _is_terminal(stream: TextIO | None) -> bool:
    """Whether a person is there; a closed stream is None."""
    return stream is not None and stream.isatty()


def _draw(outcome: Outcome, path: Path) -> Reason:
    """Draw the first world; what to say of it."""
    if outcome.result is None:
        return NOTHING
    for snapshot in outcome.snapshots.values():
        return world_picture.draw(snapshot, path) or Reason.of("cli.picture", path=str(path))
    return Reason.of("cli.no_picture")


def joined_answers(answers: list[tuple[str, str, str]]) -> tuple[tuple[str, str, str], ...]:
    """One line of values for each input, in the order in which they were given."""
    lines: dict[tuple[str, str], list[str]] = {}
    for task, name, values in answers:
        lines.setdefault((task, name), []).append(values)
    return tuple((task, name, " ".join(parts)) for (task, name), parts in lines.items())


def expectation_of(text: str) -> Condition:
    """A condition, as a word of a command line."""
    try:
        return Condition.parse(text)
    except ValueError as wrong:
        raise argparse.ArgumentTypeError(say(reason_of(wrong))) from None


def redirect_of(text: str) -> Redirect:
    """A redirection, as a word of a command line."""
    try:
        return Redirect.parse(text)
    except ValueError as wrong:
        raise argparse.ArgumentTypeError(say(reason_of(wrong))) from None


def runtime_address(text: str) -> str:
    """The address of a runtime, as a word of a command line."""
    try:
        return str(address_of(text))
    except ValueError as wrong:
        raise argparse.ArgumentTypeError(say(reason_of(wrong))) from None


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


def seconds_of(text: str) -> float:
    """Seconds, as a word of a command line."""
    try:
        seconds = float(text)
    except ValueError:
        seconds = -1.0
    if not 0.0 <= seconds <= 3600.0:
        raise argparse.ArgumentTypeError(say(Reason.of("cli.seconds_expected", most="3600", text=text)))
    return seconds


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


def _places(given: argparse.Namespace) -> tuple[tuple[str, RuntimeLocation], ...]:
    places = [at for at in given.at if isinstance(at, tuple)]
    tokens = {url: _token_of(flow, given) for flow, url in reversed(places)}
    return tuple((flow, RuntimeLocation(url, tokens[url], given.ca)) for flow, url in places)


def _token_of(flow: str, given: argparse.Namespace) -> str:
    tokens = dict(given.tokens)
    return str(tokens.get(flow, tokens.get("", "")))


def _whole(text: str) -> int:
    if not re.fullmatch(r"[+-]?[0-9]{1,18}", text):
        raise argparse.ArgumentTypeError(say(Reason.of("cli.whole_expected", digits=18, text=text)))
    return int(text)


def _value(text: str) -> tuple[str, float]:
    try:
        variation = Variation.parse(text)
        if len(variation.choices) != 1:
            raise ValueError(Reason.of("sweep.one_value", text=text))
    except ValueError as wrong:
        raise argparse.ArgumentTypeError(say(reason_of(wrong))) from None
    return variation.name, variation.choices[0]


def answer_of(text: str) -> tuple[str, str, str]:
    """A task, the name of an input and its values, as a word of a command line."""
    address, equals, values = text.partition("=")
    task, dot, name = address.strip().rpartition(".")
    if not (equals and dot and task and name):
        raise argparse.ArgumentTypeError(say(Reason.of("cli.answer_expected", text=text)))
    return task, name, values.replace(",", " ").strip()
