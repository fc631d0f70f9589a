"""The commands of buttons while they run: each in a process group of its own, so that all of it can be ended (G02)."""

import os
import select
import shutil
import signal
import subprocess
import threading
import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import replace

from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.state.model import Model
from onika.model.button import Button
from onika.wire.view import ButtonView
from onika.words.fault import Refusal
from onika.words.reason import NOTHING, Reason

KEPT = 8192
"""Bytes of a command's output that are shown: the last ones."""

_APART_S = 0.1
"""Between two looks at the output."""

_GRACE_S = 2.0
"""From the friendly end of a command to the other one."""

Tell = Callable[[Callable[[Model], Done]], None]
"""How a change gets into the environment's own thread, in order."""


class Commands:
    """The commands that run.

    tell         told what a command has printed and how it ended
    environment  the variables that commands get
    """

    def __init__(self, tell: Tell, environment: Mapping[str, str]) -> None:
        self._tell = tell
        self._environment = dict(environment)
        self._running: dict[str, _Command] = {}
        self._is_closed = False

    def start(self, button: Button) -> Reason | Refusal:
        """Run a command; gives a sentence where it does not run as it was asked, else an empty one."""
        terminal = _terminal(self._environment) if button.spawns_terminal else ()
        line = (*terminal, "/bin/sh", "-c", _in_front(button.command))
        try:
            command = _Command(line, self._environment)
        except (OSError, ValueError) as wrong:
            return Refusal(Reason.plain(str(wrong)))
        self._running[button.name] = command
        command.begin(self._shower(button.name))
        lacks_terminal = button.spawns_terminal and not terminal
        if lacks_terminal:
            return Reason.of("run.no_terminal", name=button.name)
        return NOTHING

    def halt(self, name: str) -> bool:
        """End a command; False where it does not run."""
        command = self._running.get(name)
        return command is not None and command.end()

    def close(self) -> None:
        """Ask all of them to end; what they have to save is theirs. Nothing more is told."""
        self._is_closed = True
        for command in self._running.values():
            command.end()

    def _shower(self, name: str) -> "Callable[[str, int | None], None]":
        """Show a command's output and, once it has ended, its exit code."""

        def show(output: str, code: int | None) -> None:
            if not self._is_closed:
                self._tell(lambda model: _shown(model, name, output, code))

        return show


class _Command:
    """A command from its beginning to its end; raises OSError or ValueError where it cannot begin."""

    def __init__(self, line: tuple[str, ...], environment: Mapping[str, str]) -> None:
        self._output, ours = os.pipe()
        try:
            self._process = subprocess.Popen(  # noqa: S603 - the user's own command is what is asked for
                line,
                stdin=subprocess.DEVNULL,
                stdout=ours,
                stderr=subprocess.STDOUT,
                env=environment,
                start_new_session=True,
            )
        except BaseException:
            os.close(self._output)
            raise
        finally:
            os.close(ours)
        self._guard = threading.Lock()
        self._has_ended = False
        self._timer = threading.Timer(_GRACE_S, self.kill)
        self._timer.daemon = True

    def begin(self, show: Callable[[str, int | None], None]) -> None:
        """Follow it in a thread of its own."""
        self.thread = threading.Thread(target=self._follow, args=(show,), daemon=True)
        self.thread.start()

    def _follow(self, show: Callable[[str, int | None], None]) -> None:
        """Show what is printed until all have closed the output and the command has ended."""
        tail = bytearray()
        try:
            while _more(self._output, tail):
                show(_text(tail), None)
        finally:
            os.close(self._output)
        os.waitid(os.P_PID, self._process.pid, os.WEXITED | os.WNOWAIT)
        with self._guard:  # until here its number is nobody else's
            self._has_ended = True
            code = self._process.wait()
        self._timer.cancel()
        show(_text(tail), code)

    def end(self) -> bool:
        """Ask all of it to end, and end it where it does not within the grace."""
        if not self._signal(signal.SIGTERM):
            return False
        if not self._timer.is_alive() and not self._timer.finished.is_set():
            self._timer.start()
        return True

    def kill(self) -> None:
        """End all of it."""
        self._signal(signal.SIGKILL)

    def _signal(self, number: signal.Signals) -> bool:
        with self._guard:
            if not self._has_ended:
                with suppress(PermissionError):  # it may have become another user's
                    os.killpg(self._process.pid, number)
            return not self._has_ended


def _more(output: int, tail: bytearray) -> bool:
    """Take what is printed in the next while into the tail; False once nobody can print any more."""
    waiting = select.poll()  # unlike select, for descriptors of any number
    waiting.register(output, select.POLLIN)
    waiting.poll()
    until = time.monotonic() + _APART_S
    while True:
        data = os.read(output, 65536)
        if not data:
            return False
        tail += data
        del tail[:-KEPT]
        left_s = until - time.monotonic()
        if left_s <= 0 or not waiting.poll(left_s * 1e3):
            return True


def _text(tail: bytearray) -> str:
    """The end of what was printed; a sign that was cut in two at its beginning is left out."""
    start = 0
    if len(tail) == KEPT:
        while start < 3 and tail[start] & 0xC0 == 0x80:
            start += 1
    return tail[start:].decode("utf-8", errors="replace")


def _in_front(command: str) -> str:
    """The command without the ampersand at its end: it runs beside everything in any case (§A.6)."""
    bare = command.rstrip()
    is_background = bare.endswith("&") and not bare.endswith("&&")
    return bare[:-1] if is_background else command


def _terminal(environment: Mapping[str, str]) -> tuple[str, ...]:
    """A terminal that can be opened, with the word before its command; none without a screen."""
    if not (environment.get("DISPLAY") or environment.get("WAYLAND_DISPLAY")):
        return ()
    for name in (environment.get("TERMINAL", ""), "x-terminal-emulator", "xterm"):
        if name and (path := shutil.which(name, path=environment.get("PATH"))):
            return path, "-e"
    return ()


def _shown(model: Model, name: str, output: str, code: int | None) -> Done:
    """A command's output, and its exit code once it has ended; what nobody shows any more is not shown."""
    if name not in model.runs:
        return Done(model)
    run = ButtonView("", 0, is_running=code is None, output=output, code=code)
    return Done(replace(model, runs={**model.runs, name: run}))
