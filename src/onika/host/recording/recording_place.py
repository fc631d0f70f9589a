"""Where a recording is written: beside the clock in virtual time, by a process of its own in wall time (law 29)."""

import os
import socket
import subprocess
from collections.abc import Sequence
from contextlib import suppress
from time import monotonic_ns
from typing import Protocol

from onika.host.processes.child_process import start
from onika.host.processes.process_socket import ProcessSocket
from onika.host.recording import recording_process
from onika.host.recording.recording_sink import AddMessage, DescribeRecording, Order, RecordingSink, encode
from onika.process.guard import is_stopped
from onika.record.run import RunRecord
from onika.record.writer import Writer
from onika.ring.segment import Segment
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason

_BUFFER = 1 << 18
_MOST_WAITING = 2000
"""Datagrams that may wait for a recording process that does not come to take them; more are counted and thrown away."""
_PATIENCE_NS = 5_000_000_000
_ENDED_NS = 2_000_000_000
_LOOK_NS, _FROZEN_NS = 100_000_000, 500_000_000


class RecordingWriter(Protocol):
    """What writes one recording."""

    @property
    def reason(self) -> Reason:
        """Why nothing more is written; empty: all is well."""
        ...

    @property
    def missed(self) -> int:
        """Values that were written over before anybody looked."""
        ...

    @property
    def untold(self) -> int:
        """Events and poses for which there was no room."""
        ...

    @property
    def is_up(self) -> bool:
        """Whether the run may begin."""
        ...

    @property
    def is_done(self) -> bool:
        """Whether the file is finished, or never will be."""
        ...

    @property
    def inlet(self) -> int | None:
        """The socket at which it hears poses from whoever steps the worlds; None: they are to be given to it."""
        ...

    def take(self, order: Order, segment: Segment | None = None) -> None:
        """Write this down; never waits for anything in wall time."""
        ...

    def describe(self, run: RunRecord) -> None:
        """What is recorded consists of something else now; raises OSError where there is no memory to say it."""
        ...

    def look(self, now: int) -> None:
        """Write down what variables have changed, where that is not done by itself."""
        ...

    def serve(self) -> None:
        """Hear what became of it."""
        ...

    def readers(self) -> Sequence[ProcessSocket]:
        """What to wait for."""
        ...

    def close(self) -> None:
        """Let go of it, finished or not."""
        ...


class InProcessWriter:
    """In the same process as the clock. Raises OSError where the file cannot be begun; later that is its `reason`."""

    def __init__(self, path: str, run: RunRecord) -> None:
        self._stream = open(path, "wb", buffering=_BUFFER)  # noqa: SIM115, PTH123 - it stays open for the run
        try:
            writer = Writer(self._stream)
            run.write(writer)
            self._sink = RecordingSink(self._stream, writer)
            self._sink.flush()
        except OSError:
            with suppress(OSError):
                self._stream.close()
            raise
        self._flush_at = 0
        self.reason: Reason = NOTHING
        self.untold = 0

    is_up = True
    inlet = None

    @property
    def is_done(self) -> bool:
        """Whether the file is finished, or never will be."""
        return self._sink.is_finished or bool(self.reason)

    @property
    def missed(self) -> int:
        """Values that were written over before they were looked at: a task that writes four times in one cycle."""
        return self._sink.missed

    def take(self, order: Order, segment: Segment | None = None) -> None:
        """Write this down."""
        if not self.reason:
            try:
                self._sink.take(order, None if segment is None else segment.view)
            except OSError as wrong:
                self.reason = system_reason(wrong)

    def describe(self, run: RunRecord) -> None:
        """What is recorded consists of something else now."""
        if not self.reason:
            try:
                self._sink.describe(run)
            except OSError as wrong:
                self.reason = system_reason(wrong)

    def look(self, now: int) -> None:
        """Write down what variables have changed."""
        if not self.reason:
            try:
                self._sink.look(now)
            except OSError as wrong:
                self.reason = system_reason(wrong)

    def serve(self) -> None:
        """While the clock stands nothing else lets out what was seen."""
        if not self.is_done and monotonic_ns() >= self._flush_at:
            self._flush_at = monotonic_ns() + _BESIDES_NS
            try:
                self._sink.flush()
            except OSError as wrong:
                self.reason = system_reason(wrong)

    def readers(self) -> Sequence[ProcessSocket]:
        """Nothing."""
        return ()

    def close(self) -> None:
        """Let go of the file."""
        try:
            self._stream.close()
        except OSError as wrong:
            self.reason = self.reason or system_reason(wrong)


_BESIDES_NS = 500_000_000


class WriterProcess:
    """Has the recording written by a process of its own. Raises OSError where the file cannot be made."""

    def __init__(self, path: str, run: RunRecord, every_ns: int, with_fifo: bool) -> None:
        body = recording_process.encode_run(run)
        memory = Segment.create("recorded-run", len(body))
        memory.view[:] = body
        descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_CLOEXEC, 0o666)
        self._post, theirs = ProcessSocket.pair()
        self._inlet, far = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        words = ("--every", str(every_ns), *(("--fifo",) if with_fifo else ()))
        self._process = start("onika.host.recording.recording_process", theirs, words)
        self._post.send(b"run", (memory.fd, descriptor, far.fileno()))
        far.close()
        os.close(descriptor)
        memory.close()
        self._since = monotonic_ns()
        self._look_at = self._stopped_ns = 0
        self._is_done = False
        self._memories: list[Segment] = []
        self.is_up = False
        self.reason: Reason = NOTHING
        self.missed = 0
        self.untold = 0

    @property
    def inlet(self) -> int | None:
        """The socket at which the process hears poses; they do not go by way of the runner, whom each would wake."""
        return self._inlet.fileno()

    @property
    def is_done(self) -> bool:
        """Whether the file is finished, or never will be."""
        return self._is_done or bool(self.reason)

    def take(self, order: Order, segment: Segment | None = None) -> None:
        """Send it over, unless too much waits already: then what can be missed is counted and left out."""
        if self.reason:
            return
        if isinstance(order, AddMessage) and self._post.waiting >= _MOST_WAITING:
            self.untold += 1
            return
        body = encode(order)
        self._post.send(body, () if segment is None else (segment.fd,))

    def describe(self, run: RunRecord) -> None:
        """Send the description over as memory, which stays until the other end has it."""
        if self.reason:
            return
        body = recording_process.encode_run(run)
        memory = Segment.create("recorded-run", len(body))
        memory.view[:] = body
        self._post.send(encode(DescribeRecording()), (memory.fd,))
        self._memories.append(memory)
        self._give_back()

    def _give_back(self) -> None:
        """Memory that the other end has needs nobody here any more."""
        while self._memories and (self._post.is_closed or not self._post.is_waiting):
            self._memories.pop().close()

    def look(self, now: int) -> None:
        """It looks by itself."""

    def serve(self) -> None:
        """Hear whether it is up, and what became of it."""
        self._post.flush()
        self._give_back()
        while not self._post.is_closed and (received := self._post.receive()) is not None:
            word = recording_process.decode_word(received[0])
            if isinstance(word, recording_process.RecordingBegun):
                self.is_up = True
            else:
                self._is_done, self.missed, self.reason = True, word.missed, word.reason
                self.untold += word.untold
        if not self.is_done:
            self._judge()

    def _judge(self) -> None:
        now = monotonic_ns()
        code = self._process.poll()
        if code is not None:
            self.reason = Reason.of("host.writer_ended", code=code)
        elif self._is_frozen(now):
            self.reason = Reason.of("host.writer_frozen")
            self._end()
        elif not self.is_up and now - self._since > _PATIENCE_NS:
            self.reason = Reason.of("host.writer_not_up", seconds=_PATIENCE_NS / 1e9)

    def _is_frozen(self, now: int) -> bool:
        """Whether the system holds the process for longer than a look; looked at now and then only."""
        if now < self._look_at:
            return False
        self._look_at = now + _LOOK_NS
        if not is_stopped(self._process.pid):
            self._stopped_ns = 0
            return False
        self._stopped_ns = self._stopped_ns or now
        return now - self._stopped_ns >= _FROZEN_NS

    def readers(self) -> Sequence[ProcessSocket]:
        """Its post, as long as it lives."""
        return () if self._post.is_closed else (self._post,)

    def close(self) -> None:
        """Let go of it: without the post it writes what it has seen and ends."""
        self._post.close()
        self._inlet.close()
        self._give_back()
        try:
            self._process.wait(_ENDED_NS / 1e9)
        except subprocess.TimeoutExpired:
            self._end()

    def _end(self) -> None:
        """What it has written out is in the file, and reads."""
        self._process.kill()
        self._process.wait()


def not_whole(why: Reason) -> Reason:
    """What the user has to know as soon as nothing more is written."""
    return Reason.of("host.recording_not_whole", why=why)


def complaints(writer: RecordingWriter) -> list[Reason]:
    """What the user has to know of a recording that is not what was asked for."""
    found = []
    if writer.reason or not writer.is_done:
        found.append(not_whole(writer.reason or Reason.of("host.writer_does_not_end")))
    if writer.missed:
        found.append(Reason.of("host.values_missed", count=writer.missed))
    if writer.untold:
        found.append(Reason.of("host.events_untold", count=writer.untold))
    return found
