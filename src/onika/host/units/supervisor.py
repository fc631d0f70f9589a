"""The supervisor: starts the runtime's real-time processes, hears their heartbeats, ends the ones that fail."""

from collections.abc import Collection
from dataclasses import dataclass
from time import monotonic_ns

from onika.host.processes.child_process import ChildProcess, start
from onika.host.processes.process_socket import ProcessSocket
from onika.host.units.heartbeat import SIZE, Heartbeat
from onika.process.guard import is_stopped
from onika.ring.segment import Segment
from onika.words.reason import NOTHING, Reason

SILENT_NS = 1_000_000_000
"""A process without a heartbeat for so long is stopped or caught in code that never returns."""

HELD_NS = 400_000_000
"""The same where the system holds it: nothing that it does can be the reason."""

SLOW_NS = 15_000_000_000
"""The same while it has announced long work."""

UNLOOKED_NS = 5_000_000_000
"""A process that has not looked at its own code for so long, as it does each second, was kept from it by a module."""

MOST_UNSENT = 1 << 26
"""A process that has left more bytes of commands unread than that does not get any further ones."""


@dataclass(slots=True)
class Supervised:
    """One process: its post, its heartbeat, its life."""

    name: str
    post: ProcessSocket
    heartbeat: Heartbeat
    process: ChildProcess
    title: Reason
    """What it is called where it is named to people."""
    is_up: bool = False
    is_lost: bool = False
    _stopped_ns: int = 0
    """Since when it was seen stopped while it starts; 0: it is not."""

    def trouble(self, now_ns: int) -> Reason:
        """Why this process has to be given up; empty if it is well."""
        code = self.process.poll()
        if code is not None:
            return self._ended(code)
        if not self.is_up:
            return self._stopped_at_start(now_ns)
        if self.post.unsent > MOST_UNSENT:
            return Reason.of("host.commands_unread", name=self.title, megabytes=MOST_UNSENT >> 20)
        silent = now_ns - self.heartbeat.last_ns
        if silent > HELD_NS and is_stopped(self.process.pid):
            return Reason.of("host.process_silent", name=self.title, seconds=silent / 1e9)
        patience = SLOW_NS if self.heartbeat.takes_long else SILENT_NS
        if silent <= patience:
            return self._unlooked(now_ns)
        task = self.heartbeat.task
        if task:
            return Reason.of("host.call_silent", name=self.title, seconds=silent / 1e9, task=task)
        return Reason.of("host.process_silent", name=self.title, seconds=silent / 1e9)

    def _unlooked(self, now_ns: int) -> Reason:
        """It lives, but does not look at its own code any more: whatever it says cannot be relied on."""
        looked = self.heartbeat.looked_ns
        unlooked = now_ns - looked
        if not looked or self.heartbeat.takes_long or unlooked <= UNLOOKED_NS:
            return NOTHING
        return Reason.of("host.code_unlooked", name=self.title, seconds=unlooked / 1e9)

    def _stopped_at_start(self, now_ns: int) -> Reason:
        """To start may take long; but one that the system holds does not even try."""
        if not is_stopped(self.process.pid):
            self._stopped_ns = 0
            return NOTHING
        self._stopped_ns = self._stopped_ns or now_ns
        silent = now_ns - self._stopped_ns
        if silent < HELD_NS:
            return NOTHING
        return Reason.of("host.process_silent", name=self.title, seconds=silent / 1e9)

    def _ended(self, code: int) -> Reason:
        why = self.heartbeat.reason
        if why:
            return Reason.of("host.gave_up", name=self.title, why=why)
        task = self.heartbeat.task
        during = Reason.of("host.in_call", task=task) if task else NOTHING
        if code < 0:
            return Reason.of("host.process_killed", name=self.title, signal=-code, during=during)
        return Reason.of("host.process_ended", name=self.title, code=code, during=during)

    def end(self) -> None:
        """End it now; no zombie is left."""
        self.process.kill()
        self.process.wait()
        self.post.close()


class Supervisor:
    """All processes that run in real time."""

    def __init__(self, zero_ns: int, with_fifo: bool) -> None:
        self._zero = zero_ns
        self.with_fifo = with_fifo
        self.processes: dict[str, Supervised] = {}

    def launch(
        self, name: str, title: Reason, module: str, arguments: tuple[str, ...] = (), *, has_modules: bool = False
    ) -> Supervised:
        """Start one; it says when it is up. People are told of it as of `title`; one that has modules is a group."""
        segment = Segment.create(f"beat-{name}", SIZE)
        ours, theirs = ProcessSocket.pair()
        words = (*arguments, "--beat-fd", str(segment.fd), "--zero", str(self._zero))
        fifo = ("--fifo",) if self.with_fifo else ()
        process = start(module, theirs, words + fifo, (segment.fd,), own_group=has_modules)
        self.processes[name] = Supervised(name, ours, Heartbeat(segment), process, title)
        return self.processes[name]

    def trouble(self, besides: Collection[str] = ()) -> Reason:
        """Why the first process that has failed has to be given up, besides these; empty if all are well."""
        now = monotonic_ns()
        looked_at = [process for name, process in self.processes.items() if name not in besides]
        found = (process.trouble(now) for process in looked_at if not process.is_lost)
        return next((reason for reason in found if reason), NOTHING)

    def troubles(self) -> list[tuple[Supervised, Reason]]:
        """Every process that has failed since the last call, with the reason; it is ended."""
        now, found = monotonic_ns(), []
        for process in self.processes.values():
            reason = NOTHING if process.is_lost else process.trouble(now)
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
