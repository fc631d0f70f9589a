"""The environment as a process, with what it writes, for browsers that are let in one by one."""

import contextlib
import os
import queue
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from collections.abc import Iterable
from pathlib import Path

from playwright.sync_api import Page, expect

FORESEES = "--foresees"
"""An option of these tests: what is open is foreseen in the background, which takes time that others need."""


def _without_forecast(options: tuple[str, ...]) -> tuple[str, ...]:
    wanted = tuple(option for option in options if option != FORESEES)
    return wanted if FORESEES in options else ("--no-forecast", *wanted)


class Program:
    """The environment as a process, with a home, a state and a base directory of its own."""

    def __init__(
        self, folder: Path, files: tuple[str, ...], options: tuple[str, ...], command: tuple[str, ...] = ("page",)
    ) -> None:
        self.home, self.state = folder / "home", folder / "state"
        self.home.mkdir(parents=True, exist_ok=True)
        bases = [Path(option.removeprefix("--base=")) for option in options if option.startswith("--base=")]
        self._at_first = _copies([self.home, *bases], Path(tempfile.mkdtemp(dir=folder)))
        more = _without_forecast(options) if command == ("page",) else options
        self._words = (*command, *files, "--port", "0", "--no-browser", *more)
        inherited = {name: value for name, value in os.environ.items() if not name.startswith("ONIKA_")}
        self._environment = {**inherited, "HOME": str(self.home), "XDG_STATE_HOME": str(self.state)}
        self.said: list[str] = []
        self.is_doubtful = False
        """Whether a test has failed meanwhile."""
        self._start()

    def _start(self) -> None:
        self._is_ended = False
        self._keys: queue.Queue[str] = queue.Queue()
        self.process = subprocess.Popen(
            [sys.executable, "-c", "from onika.cli import main; main()", *self._words],
            env=self._environment, cwd=self.home.parent, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            start_new_session=True,
        )  # fmt: skip
        self._reading = threading.Thread(target=self._read)
        self._reading.start()

    def _begin_anew(self) -> None:
        """As at first: a test that is tried again must not meet what its first try has left behind."""
        self.kill()
        for folder in (self.state, *self._at_first):
            shutil.rmtree(folder, ignore_errors=True)
        for folder, copy in self._at_first.items():
            shutil.copytree(copy, folder, symlinks=True)
        self.is_doubtful = False
        self._start()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self.said.append(line)
            for address in re.findall(r"http://\S+key=\S+", line):
                self._keys.put(address)

    def address(self) -> str:
        """The address that lets the next browser in."""
        if self.is_doubtful:
            self._begin_anew()
        try:
            return self._keys.get(timeout=60)
        except queue.Empty:
            raise AssertionError(f"no address was printed: {''.join(self.said)}") from None

    def enter(self, page: Page) -> Page:
        """Let a browser in, and wait until it is shown what is open."""
        page.goto(self.address())
        expect(page.get_by_role("navigation").get_by_role("listitem")).not_to_have_count(0)
        return page

    def end(self) -> None:
        """Ctrl-C; it must end by itself."""
        self.process.send_signal(signal.SIGINT)
        try:
            self.process.wait(30)
        finally:
            self.kill()

    def kill(self) -> None:
        """An end that it learns nothing of."""
        if not self._is_ended:
            self._is_ended = True
            with contextlib.suppress(ProcessLookupError):
                os.killpg(self.process.pid, signal.SIGKILL)
            self.process.wait(30)
            self._reading.join(30)
            assert self.process.stdout is not None
            self.process.stdout.close()


def _copies(folders: Iterable[Path], place: Path) -> dict[Path, Path]:
    """Where each folder is kept as it is now."""
    copies = {folder: place / str(number) for number, folder in enumerate(folders)}
    for folder, copy in copies.items():
        shutil.copytree(folder, copy, symlinks=True)
    return copies
