"""A contestant: one program that does a contest's work, in a process of its own, a round at a time.

It is started as `python -m beside.CONTEST.NAME`, says its version, and then measures one round for each size that it
reads. All contestants of a contest are treated alike: linear algebra in one thread, fine timers, no collection of
garbage while a round is measured.
"""

import gc
import json
import os
import select
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping
from contextlib import suppress
from pathlib import Path

from onika.host.processes.realtime_scheduling import fine_timers, still_garbage
from onika.link.child.launcher import ONE_THREAD

Figures = Mapping[str, float | list[float]]
"""What one round found, by name."""

HOME = Path(__file__).parents[1]
PATIENCE_S = 60.0
"""A contestant that says nothing for so long is given up."""


def serve(version: str, measure: Callable[[int], Figures]) -> None:
    """Be a contestant: `measure` is called for each size and answers with its figures."""
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # what a library prints must not stand among the answers
    fine_timers()
    still_garbage()
    print(json.dumps({"version": version}), file=answers, flush=True)
    for line in sys.stdin:
        print(json.dumps(measure(int(line))), file=answers, flush=True)
        gc.collect()


class Absent(Exception):
    """A contestant cannot take part; the text says why."""


class Contestant:
    """The other end of `serve`. Raises `Absent` where the program does not come up, gives up or hangs."""

    def __init__(self, module: str) -> None:
        self._words = tempfile.TemporaryFile()  # noqa: SIM115 - lives as long as the process
        paths = os.pathsep.join(filter(None, (str(HOME), os.environ.get("PYTHONPATH", ""))))
        self._process = subprocess.Popen(
            [sys.executable, "-m", module],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._words,
            start_new_session=True,
            env=os.environ | ONE_THREAD | {"PYTHONPATH": paths},
        )
        self.version = str(self._answer()["version"])

    def measure(self, size: int) -> Figures:
        """One round of this size."""
        assert self._process.stdin is not None
        with suppress(BrokenPipeError):  # the answer says why
            self._process.stdin.write(b"%d\n" % size)
            self._process.stdin.flush()
        return self._answer()

    def end(self) -> None:
        """Let it go."""
        assert self._process.stdin is not None and self._process.stdout is not None
        with suppress(BrokenPipeError):
            self._process.stdin.close()
        with suppress(subprocess.TimeoutExpired):
            self._process.wait(timeout=5.0)
        with suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)  # and whatever it started
        self._process.wait()
        self._process.stdout.close()
        self._words.close()

    def _answer(self) -> Figures:
        assert self._process.stdout is not None
        is_there, _, _ = select.select([self._process.stdout], [], [], PATIENCE_S)
        line = self._process.stdout.readline() if is_there else b""
        if line:
            found: Figures = json.loads(line)
            return found
        why = self._last_word() if is_there else f"it said nothing for {PATIENCE_S:g} s"
        self.end()
        raise Absent(why)

    def _last_word(self) -> str:
        self._process.wait()
        self._words.seek(0)
        said = [one.strip() for one in self._words.read().decode(errors="replace").splitlines() if one.strip()]
        return said[-1] if said else f"it ended with code {self._process.returncode}"
