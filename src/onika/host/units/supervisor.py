"""The supervisor: starts the runtime's real-time processes, hears their heartbeats, ends the ones that fail."""

import subprocess
from dataclasses import dataclass
from pathlib import Path
from time import monotonic_ns

from onika.host.units.child_process import start
from onika.host.units.heartbeat import SIZE, Heartbeat
from onika.host.units.process_socket import ProcessSocket
from onika.ring.segment import Segment

SILENT_NS = 1_000_000_000
"""A process without a heartbeat for so long is stopped or caught in code that never returns."""

SLOW_NS = 15_000_000_000
"""The same while it has announced long work."""


@dataclass(slots=True)
class Supervised:
    """One process: its post, its heartbeat, its life."""

    name: str
    post: ProcessSocket
    heartbeat: Heartbeat
    process: "subprocess.Popen[bytes]"
    is_up: bool = False
    is_lost: bool = False

    def trouble(self, now_ns: int) -> str:
        """Why this process has to be given up; empty if it is well."""
        code = self.process.poll()
        if code is not None:
            how = f"was killed by signal {-code}" if code < 0 else f"ended with code {code}"
            task = self.heartbeat.task
            return f"{self.name} {how}" + (f" in a call of task {task}" if task else "")
        if not self.is_up:
            return ""
        silent = now_ns - self.heartbeat.last_ns
        if silent > (SLOW_NS if self.heartbeat.takes_long else SILENT_NS):
            task = "" if _is_stopped(self.process.pid) else self.heartbeat.task
            what = f"a call of task {task} has not returned" if task else "stopped"
            return f"{self.name} has not answered for {silent / 1e9:.1f} s: {what}"
        return ""

    def end(self) -> None:
        """End it now; no zombie is left."""
        self.process.kill()
        self.process.wait()
        self.post.close()


class Supervisor:
    """All processes that run in real time."""

    def __init__(self, zero_ns: int, with_fifo: bool) -> None:
        self._zero = zero_ns
        self._with_fifo = with_fifo
        self.processes: dict[str, Supervised] = {}

    def launch(self, name: str, module: str, arguments: tuple[str, ...] = ()) -> Supervised:
        """Start one; it says when it is up."""
        segment = Segment.create(f"beat-{name}", SIZE)
        ours, theirs = ProcessSocket.pair()
        words = ("--beat-fd", str(segment.fd), "--zero", str(self._zero), *arguments)
        fifo = ("--fifo",) if self._with_fifo else ()
        process = start(module, theirs, words + fifo, (segment.fd,))
        self.processes[name] = Supervised(name, ours, Heartbeat(segment), process)
        return self.processes[name]

    def troubles(self) -> list[tuple[Supervised, str]]:
        """Every process that has failed since the last call, with the reason; it is ended."""
        now, found = monotonic_ns(), []
        for process in self.processes.values():
            reason = "" if process.is_lost else process.trouble(now)
            if reason:
                process.is_lost = True
                process.end()
                found.append((process, reason))
        return found

    def end(self) -> None:
        """End them all."""
        for process in self.processes.values():
            if not process.is_lost:
                process.is_lost = True
                process.end()


def _is_stopped(pid: int) -> bool:
    """Whether the operating system holds the process (SIGSTOP, a debugger), so that no task is to blame."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(") ")[2][:1] in ("T", "t")
    except OSError:
        return False
