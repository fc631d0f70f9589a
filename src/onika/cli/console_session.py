"""A session at a runtime: the console that this terminal can show, connected to a running runtime."""

import os
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING

from onika.cli.conversation import LineDesk, converse, run_batch, serve
from onika.cli.language import say
from onika.cli.plain_console import PlainConsole
from onika.desk.console.console import Console
from onika.desk.console.display import ConsoleDisplay, Tone
from onika.desk.console.session import ConsoleSession, Runtime
from onika.files.state.state_directory import state_directory
from onika.process.orderly_exit import in_order
from onika.store.site import Site
from onika.words.reason import Reason

if TYPE_CHECKING:
    from onika.cli.terminal import Terminal


class _LaterDisplay:
    """A display that is chosen once the console is there, for a terminal completes what is typed with its help."""

    def __init__(self) -> None:
        self.display: ConsoleDisplay | None = None

    def say(self, line: Reason, tone: Tone = Tone.PLAIN) -> None:
        """Pass it on."""
        if self.display is not None:
            self.display.say(line, tone)


def sit_down(runtime: Runtime, site: Site, script: Path | None, *, has_console: bool = True) -> int:
    """Hold the conversation, or carry out the script alone, or only serve; the exit code."""
    later = _LaterDisplay()
    session = ConsoleSession(runtime, site, later, time.monotonic, in_words=say)
    console = Console(session)
    with in_order(), _desk(console) if has_console else PlainConsole() as desk:
        later.display = desk
        faults = session.begin()
        for fault in faults:
            desk.say(fault.sentence, Tone.FAULT)
        if faults:
            return 1
        for fault in site.absent():
            desk.say(fault.sentence, Tone.NOTE)
        _welcome(session, desk)
        if has_console:
            return converse(console, desk, script)
        if script is None:
            return serve(console)
        return run_batch(console, desk, script)


def _welcome(session: ConsoleSession, desk: LineDesk) -> None:
    standing = session.standing()
    units = ", ".join(rtpu.name for rtpu in standing.rtpus)
    if standing.is_virtual:
        welcome = Reason.of("cli.welcome_virtual", units=units)
    else:
        welcome = Reason.of("cli.welcome", units=units)
    desk.say(welcome, Tone.DIM)
    for address in standing.addresses:
        desk.say(Reason.of("cli.reached_at", address=address), Tone.DIM)


def _desk(console: Console) -> "Terminal | PlainConsole":
    is_terminal = sys.stdin is not None and sys.stdin.isatty() and sys.stdout.isatty()
    if is_terminal and os.environ.get("TERM", "dumb") != "dumb":
        from onika.cli.terminal import Terminal  # within: its library takes long to load

        return Terminal(console.completion.candidates, _history())
    return PlainConsole()


def _history() -> Path:
    """Where lines are kept for the next console: in the state directory."""
    return state_directory(os.environ) / "console_history"
