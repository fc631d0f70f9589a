"""Carries out commands side by side: those in front one after another, and one behind them, which gets what they leave.

Usage: python tools/side_by_side.py COMMAND [COMMAND ...] --behind COMMAND

Each is a line for the shell. Those in front wait for much, and meet the machine's clock; the one behind only computes,
and gives way to them. What those in front print is shown as it comes, what the one behind prints when all have ended.
All are carried out, also where one fails; then this ends with 1.
"""

import argparse
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from typing import IO

GIVES_WAY = 10
"""How nice the one behind is: where there is no more than one processor for all, it gets a tenth."""

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
    with tempfile.TemporaryFile() as output:
        behind = _begin_behind(asked.behind, output)
        try:
            codes = [_carry_out(command) for command in asked.front]
            codes.append(behind.wait())
        finally:
            _end(behind)
            _show(asked.behind, output)
        print(f"{asked.behind}: {time.monotonic() - begun_s:.0f} s, behind the others", flush=True)
    return int(any(codes))


def _carry_out(command: str) -> int:
    print(command, flush=True)
    begun_s = time.monotonic()
    code = subprocess.run(command, shell=True, check=False).returncode
    print(f"{command}: {time.monotonic() - begun_s:.0f} s", flush=True)
    return code


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


def _show(command: str, output: IO[bytes]) -> None:
    output.seek(0)
    print(command, flush=True)
    sys.stdout.buffer.write(output.read())
    sys.stdout.flush()


def _leave(_number: int, _frame: object) -> None:
    sys.exit(128 + signal.SIGTERM)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
