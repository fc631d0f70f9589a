"""A command line of ours as a process: its events read as they come, its processes found, signals sent to them.

    with Console("run", "go_home", "--json") as console:
        console.until(event="drive", state="DRIVEN")
        os.kill(console.process("onika.host.units.rtpu"), signal.SIGKILL)
        assert console.result()["state"] == "aborted"

It waits for what is said, never for time; the patience only keeps a test from hanging.
"""

import json
import os
import select
import signal
import subprocess
import sys
from collections import deque
from collections.abc import Iterator, Mapping
from pathlib import Path
from time import monotonic
from types import TracebackType
from typing import Any, Self

ONIKA = (
    sys.executable,
    "-c",
    "import signal, sys; signal.signal(signal.SIGINT, signal.default_int_handler); "
    "from onika.cli import main; sys.exit(main())",
)
"""The program `onika`, wherever it is installed; Ctrl-C reaches it where a shell has begun the tests in the background
too, which has what it begins there ignore Ctrl-C."""

Event = dict[str, Any]


def in_english(line: str) -> Event:
    """An event as the command line prints it, with the English of its reasons in their place."""
    event: Event = json.loads(line)
    for name, value in event.items():
        if isinstance(value, dict) and {"key", "text"} <= value.keys():
            event[name] = value["text"]
    return event


class CliProcess:
    """`onika WORDS` in a process group of its own, as a terminal starts it; output is read as lines."""

    def __init__(self, *words: str, environment: Mapping[str, str] | None = None, patience_s: float = 60.0) -> None:
        self._until = monotonic() + patience_s
        self._process = subprocess.Popen(
            [*ONIKA, *words],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            env=os.environ | dict(environment or {}),
            start_new_session=True,
        )
        self.pid = self._process.pid
        self.lines: list[str] = []
        self._rest = b""
        self._waiting: deque[str] = deque()
        self._pids: dict[int, str] = {}

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        """End whatever is left."""
        self._process.kill()
        self._process.wait()
        if self._process.stdout is not None:
            self._process.stdout.close()

    @property
    def events(self) -> list[Event]:
        """What was said so far."""
        return [in_english(line) for line in self.lines if line.startswith("{")]

    def until(self, **wanted: Any) -> Event:
        """Read on to the first event with these fields; raises RuntimeError where the output ends before."""
        for line in self._read():
            event = in_english(line) if line.startswith("{") else {}
            if event and all(event.get(name) == value for name, value in wanted.items()):
                self.processes()
                return event
        raise RuntimeError(f"expected {wanted}, found the end of the output:\n" + "\n".join(self.lines[-20:]))

    def until_line(self, text: str) -> str:
        """Read on to the first line that holds this text; raises RuntimeError where the output ends before."""
        for line in self._read():
            if text in line:
                return line
        raise RuntimeError(f"expected {text!r}, found the end of the output:\n" + "\n".join(self.lines[-20:]))

    def result(self) -> Event:
        """Read to the end: the last event."""
        for _ in self._read():
            pass
        self.code()
        return self.events[-1]

    def code(self) -> int:
        """Wait for the end: the exit code. Raises subprocess.TimeoutExpired when the patience is over."""
        return self._process.wait(max(self._until - monotonic(), 0.1))

    def text(self) -> str:
        """Read to the end: everything that was printed."""
        for _ in self._read():
            pass
        return "\n".join(self.lines)

    # Processes

    def processes(self) -> dict[int, str]:
        """Every process that was seen below this one, with its command line; gone ones too."""
        parents = {int(path.name): _parent(path) for path in Path("/proc").iterdir() if path.name.isdigit()}
        family = {self.pid}
        while new := {pid for pid, parent in parents.items() if parent in family} - family:
            family |= new
        for pid in family:
            self._pids[pid] = _words(pid) or self._pids.get(pid, "")
        return dict(self._pids)

    def process(self, name: str) -> int:
        """The process whose command line holds these words."""
        return next(pid for pid, words in self.processes().items() if name in words and pid != self.pid)

    def interrupt(self) -> None:
        """Ctrl-C: to everyone in the foreground."""
        os.killpg(self.pid, signal.SIGINT)

    def left_over(self, within_s: float = 20.0) -> list[str]:
        """The processes that outlive this one, though they had so long to end."""
        until, alive = monotonic() + within_s, [""]
        while alive and monotonic() < until:
            alive = [words for pid, words in self._pids.items() if words and _words(pid) == words]
            select.select([], [], [], 0.02 if alive else 0.0)
        return alive

    # Inner

    def _read(self) -> Iterator[str]:
        """Lines as they come, to the end of the output; raises TimeoutError when the patience is over."""
        stream = self._process.stdout
        assert stream is not None
        yield from self._take()
        while True:
            ready, _, _ = select.select([stream], [], [], max(self._until - monotonic(), 0.0))
            if not ready:
                raise TimeoutError("the patience is over; it said last:\n" + "\n".join(self.lines[-20:]))
            data = os.read(stream.fileno(), 1 << 16)
            *whole, self._rest = (self._rest + data).split(b"\n")
            self._waiting += [line.decode("utf-8", "replace") for line in whole]
            yield from self._take()
            if not data:
                return

    def _take(self) -> Iterator[str]:
        """One by one: whoever stops reading finds the others later."""
        while self._waiting:
            self.lines.append(self._waiting.popleft())
            yield self.lines[-1]


def _parent(path: Path) -> int:
    try:
        return int((path / "stat").read_text().rpartition(")")[2].split()[1])
    except OSError:
        return 0


def _words(pid: int) -> str:
    """The command line of a process; empty for one that is gone or a zombie."""
    try:
        return Path(f"/proc/{pid}/cmdline").read_bytes().replace(b"\0", b" ").decode()
    except OSError:
        return ""
