"""Carries out commands side by side: those in front one after another, and one behind them, which gets what they leave.

Usage: python tools/side_by_side.py COMMAND [COMMAND ...] --behind COMMAND

Each is a line for the shell. Those in front wait for much, and meet the machine's clock; the one behind only computes,
and gives way to them. What those in front print is shown as it comes, what the one behind prints when all have ended.
All are carried out, also where one fails; then this ends with 1, and the last lines of what failed come once more: who
reads only the end of the output sees why.
"""

import argparse
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterable, Sequence
from typing import IO, cast

GIVES_WAY = 10
"""How nice the one behind is: where there is no more than one processor for all, it gets a tenth."""

_LAST_LINES = 40
"""So many of what failed are shown once more at the end."""

_PIECE = 65536

_GIVE_WAY = f"{{ echo {GIVES_WAY} > /proc/self/autogroup; }} 2> /dev/null"
"""Where the kernel shares the processors between sessions, being nice counts within one's own only."""


def main(words: Sequence[str]) -> int:
    """Carry them out, and say how long each took."""
    parser = argparse.ArgumentParser(description="commands side by side")
    parser.add_argument("front", nargs="+", metavar="COMMAND", help="in front, one after another")
    parser.add_argument("--behind", required=True, metavar="COMMAND", help="behind them")
    asked = parser.parse_args(words)
    signal.signal(signal.SIGTERM, _leave)
    begun_s = time.monotonic()
    failed: dict[str, list[str]] = {}
    with tempfile.TemporaryFile() as output:
        behind = _begin_behind(asked.behind, output)
        try:
            for command in asked.front:
                failed |= _carry_out(command)
            behind.wait()
        finally:
            _end(behind)
            last_lines = _show(asked.behind, output)
        print(f"{asked.behind}: {time.monotonic() - begun_s:.0f} s, behind the others", flush=True)
    if behind.returncode:
        failed[asked.behind] = last_lines
    for command, lines in failed.items():
        print(f"\nfailed: {command}", *lines, sep="\n", flush=True)
    return int(bool(failed))


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


def _begin_behind(command: str, output: IO[bytes]) -> "subprocess.Popen[bytes]":
    return subprocess.Popen(
        ["nice", "-n", str(GIVES_WAY), "sh", "-c", f"{_GIVE_WAY}; {command}"],
        stdin=subprocess.DEVNULL,
        stdout=output,
        stderr=subprocess.STDOUT,
        start_new_session=True,
    )


def _end(behind: "subprocess.Popen[bytes]") -> None:
    """Where it is still there, because somebody has had enough of all."""
    if behind.poll() is None:
        os.killpg(behind.pid, signal.SIGKILL)
        behind.wait()


def _show(command: str, output: IO[bytes]) -> list[str]:
    output.seek(0)
    print(command, flush=True)
    return _pass_on(output)


def _leave(_number: int, _frame: object) -> None:
    sys.exit(128 + signal.SIGTERM)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
