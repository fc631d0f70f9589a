"""Carries out commands side by side: those in front one after another, and others behind, which get what they leave.

Usage: python tools/side_by_side.py COMMAND [COMMAND ...] --behind COMMAND [--behind COMMAND ...]

Each is a line for the shell. Those in front wait for much, and meet the machine's clock; those behind only compute,
all at once, and give way. What those in front print is shown as it comes, what those behind print when all have ended.
All are carried out, also where one fails; then this ends with 1, and the last lines of what failed come once more: who
reads only the end of the output sees why.
"""

import argparse
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterable, Sequence
from contextlib import suppress
from typing import IO, cast

GIVES_WAY = 10
"""How nice one behind is: where there is no more than one processor for all, it gets a tenth."""

_LAST_LINES = 40
"""So many of what failed are shown once more at the end."""

_PIECE = 65536

_GIVE_WAY = f"{{ echo {GIVES_WAY} > /proc/self/autogroup; }} 2> /dev/null"
"""Where the kernel shares the processors between sessions, being nice counts within one's own only."""


def main(words: Sequence[str]) -> int:
    """Carry them out, and say how long each took."""
    parser = argparse.ArgumentParser(description="commands side by side")
    parser.add_argument("front", nargs="+", metavar="COMMAND", help="in front, one after another")
    parser.add_argument("--behind", required=True, action="append", metavar="COMMAND", help="behind them, all at once")
    asked = parser.parse_args(words)
    signal.signal(signal.SIGTERM, _leave)
    failed: dict[str, list[str]] = {}
    behind = [_Behind(command) for command in asked.behind]
    try:
        for command in asked.front:
            failed |= _carry_out(command)
        for each in behind:
            each.wait()
    finally:
        for each in behind:
            failed |= each.end()
    for command, lines in failed.items():
        print(f"\nfailed: {command}", *lines, sep="\n", flush=True)
    return int(bool(failed))


class _Behind:
    """One that was begun behind the others."""

    def __init__(self, command: str) -> None:
        self._command = command
        self._output = tempfile.TemporaryFile()  # noqa: SIM115 - it stays open until all is shown
        self._begun_s = time.monotonic()
        self._took_s = 0.0
        self._process = subprocess.Popen(
            ["nice", "-n", str(GIVES_WAY), "sh", "-c", f"{_GIVE_WAY}; {command}"],
            stdin=subprocess.DEVNULL,
            stdout=self._output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        self._ended = threading.Event()
        threading.Thread(target=self._watch).start()

    def wait(self) -> None:
        """Until it has ended; who is interrupted in it may wait again, as one may not for a thread (bpo-45274)."""
        self._ended.wait()

    def end(self) -> dict[str, list[str]]:
        """End it where it is there still, since somebody has had enough; show it; its last lines, if it failed."""
        if not self._ended.is_set():
            with suppress(ProcessLookupError):  # it has ended by itself in this moment
                os.killpg(self._process.pid, signal.SIGKILL)
            self.wait()
        print(self._command, flush=True)
        with self._output as output:
            output.seek(0)
            last_lines = _pass_on(output)
        print(f"{self._command}: {self._took_s:.0f} s, behind the others", flush=True)
        return {self._command: last_lines} if self._process.returncode else {}

    def _watch(self) -> None:
        self._process.wait()
        self._took_s = time.monotonic() - self._begun_s
        self._ended.set()


def _carry_out(command: str) -> dict[str, list[str]]:
    """Its last lines, where it fails."""
    print(command, flush=True)
    begun_s = time.monotonic()
    with subprocess.Popen(command, shell=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, bufsize=0) as process:
        output = cast("IO[bytes]", process.stdout)
        last_lines = _pass_on(iter(lambda: output.read(_PIECE), b""))
    print(f"{command}: {time.monotonic() - begun_s:.0f} s", flush=True)
    return {command: last_lines} if process.returncode else {}


def _pass_on(pieces: Iterable[bytes]) -> list[str]:
    """Show what comes as it comes; its last lines."""
    kept = b""
    for piece in pieces:
        sys.stdout.buffer.write(piece)
        sys.stdout.flush()
        kept = b"\n".join((kept + piece).split(b"\n")[-_LAST_LINES - 1 :])
    return kept.decode(errors="replace").splitlines()


def _leave(_number: int, _frame: object) -> None:
    sys.exit(128 + signal.SIGTERM)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
