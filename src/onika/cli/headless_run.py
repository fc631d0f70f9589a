"""An application that is run from the command line: by what is given there, shown, drawn and kept as is asked."""

import argparse
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, TextIO

from onika.cli.argument_kinds import joined_answers
from onika.cli.language import say
from onika.cli.lines.json_lines import JsonLines
from onika.cli.plain_display import PlainDisplay
from onika.cli.run import is_virtual
from onika.cli.search_path import site_here
from onika.desk.run import world_picture
from onika.desk.run.outcome import Outcome
from onika.desk.run.run import Opens, run
from onika.desk.run.settings import RecordingSource, RunSettings, RuntimeLocation
from onika.link.child.launcher import RuntimeStart
from onika.process.orderly_exit import in_order
from onika.store.site import Site
from onika.words.reason import NOTHING, Reason

if TYPE_CHECKING:
    from onika.cli.live_display import LiveDisplay


def run_application(given: argparse.Namespace, start: RuntimeStart | None) -> int:
    """Run it, on a runtime that comes up already where there is one; the exit code."""
    watcher = _watcher(given)
    settings = _settings(given, watcher.can_steer)
    objection = NOTHING if given.keep_test is None else _unkeepable(settings, given.keep_test)
    if objection:
        given.complain(say(Reason.of("cli.not_kept", objection=objection)))
    with in_order(), watcher:
        outcome = run(settings, site_here(given.local), watcher, _opens(settings), start)
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
        is_virtual=is_virtual(given),
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


def _places(given: argparse.Namespace) -> tuple[tuple[str, RuntimeLocation], ...]:
    places = [at for at in given.at if isinstance(at, tuple)]
    tokens = {url: _token_of(flow, given) for flow, url in reversed(places)}
    return tuple((flow, RuntimeLocation(url, tokens[url], given.ca)) for flow, url in places)


def _token_of(flow: str, given: argparse.Namespace) -> str:
    tokens = dict(given.tokens)
    return str(tokens.get(flow, tokens.get("", "")))
