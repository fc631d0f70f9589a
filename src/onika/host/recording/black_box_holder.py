"""Who holds the last seconds of runs: the clock's own process in virtual time, one of its own in wall time.

That process outlives the runtime: whatever kills that, what was kept is written.
"""

import subprocess
from collections.abc import Sequence
from typing import Protocol

from onika.host.processes.child_process import start
from onika.host.processes.process_socket import ProcessSocket
from onika.host.recording.black_box_orders import (
    BlackBoxWritten,
    CloseBlackBox,
    DescribeBlackBox,
    KeepBlackBox,
    OpenBlackBox,
    RunOrder,
    decode_word,
    encode,
    encode_run,
)
from onika.host.recording.held_run import HeldRun
from onika.host.recording.last_seconds import TracedEvent, TracedVariables
from onika.record.run import RunRecord
from onika.ring.segment import Segment

_MOST_WAITING = 2000
_ENDED_S = 2.0
"""How long a runtime that ends waits until its black boxes are written."""


class BlackBoxHolder(Protocol):
    """Holds the last seconds of any number of runs."""

    @property
    def is_lost(self) -> bool:
        """Whether it is gone, and keeps nothing any more."""
        ...

    def open(self, order: OpenBlackBox, run: RunRecord) -> None:
        """A run begins."""
        ...

    def describe(self, number: int, run: RunRecord) -> None:
        """It consists of something else now; raises OSError."""
        ...

    def take(self, order: TracedVariables | TracedEvent, number: int, segment: Segment | None = None) -> None:
        """Keep this; never waits for anything."""
        ...

    def look(self, now: int) -> None:
        """Look at the variables, where that is not done by itself."""
        ...

    def keep(self, order: KeepBlackBox) -> None:
        """Write the last seconds of a run that goes on."""
        ...

    def close(self, order: CloseBlackBox) -> None:
        """A run is over; its last seconds are written where they are wanted."""
        ...

    def written(self) -> list[BlackBoxWritten]:
        """What has been written since the last call."""
        ...

    def readers(self) -> Sequence[ProcessSocket]:
        """What to wait for."""
        ...

    def end(self) -> None:
        """The runtime ends; what is to be written is written before."""
        ...


class InProcessHolder:
    """In the same process as the clock."""

    def __init__(self) -> None:
        self._runs: dict[int, HeldRun] = {}
        self._written: list[BlackBoxWritten] = []

    is_lost = False

    def open(self, order: OpenBlackBox, run: RunRecord) -> None:
        """A run begins."""
        self._runs[order.number] = HeldRun(order, run)

    def describe(self, number: int, run: RunRecord) -> None:
        """It consists of something else now."""
        self._runs[number].run = run

    def take(self, order: TracedVariables | TracedEvent, number: int, segment: Segment | None = None) -> None:
        """Keep this."""
        last_seconds = self._runs[number].last_seconds
        if isinstance(order, TracedEvent):
            last_seconds.note(order)
        elif segment is not None:
            last_seconds.meet(order, segment.view)

    def look(self, now: int) -> None:
        """Look at the variables."""
        for run in self._runs.values():
            run.look(now)

    def keep(self, order: KeepBlackBox) -> None:
        """Write the last seconds of a run that goes on."""
        self._written.append(self._runs[order.number].write(order.words, order.path))

    def close(self, order: CloseBlackBox) -> None:
        """A run is over."""
        run = self._runs.pop(order.number)
        if order.is_kept:
            self._written.append(run.write(order.words))

    def written(self) -> list[BlackBoxWritten]:
        """What has been written since the last call."""
        written, self._written = self._written, []
        return written

    def readers(self) -> Sequence[ProcessSocket]:
        """Nothing."""
        return ()

    def end(self) -> None:
        """Nothing is left to be done."""
        self._runs.clear()


class HolderProcess:
    """Has a process of its own hold them; it looks into the tables by itself, in nobody's way."""

    def __init__(self) -> None:
        self._post, theirs = ProcessSocket.pair()
        self._process = start("onika.host.recording.black_box_process", theirs)
        self._met: dict[int, set[str]] = {}
        self._memories: dict[int, list[Segment]] = {}

    @property
    def is_lost(self) -> bool:
        """Whether it is gone."""
        return self._post.is_closed

    def open(self, order: OpenBlackBox, run: RunRecord) -> None:
        """A run begins."""
        self._describe(order.number, order, run)
        self._met[order.number] = set()

    def describe(self, number: int, run: RunRecord) -> None:
        """It consists of something else now."""
        self._describe(number, DescribeBlackBox(number), run)

    def take(self, order: TracedVariables | TracedEvent, number: int, segment: Segment | None = None) -> None:
        """Send it over, unless too much waits already."""
        descriptors: tuple[int, ...] = ()
        if isinstance(order, TracedVariables):
            met = self._met[number]
            if segment is not None and order.subsystem not in met:
                descriptors = (segment.fd,)
                met.add(order.subsystem)
        elif self._post.waiting >= _MOST_WAITING:
            return
        self._post.send(encode(RunOrder(number, order)), descriptors)

    def look(self, now: int) -> None:
        """It looks by itself."""

    def keep(self, order: KeepBlackBox) -> None:
        """Write the last seconds of a run that goes on."""
        self._post.send(encode(RunOrder(order.number, order)))

    def close(self, order: CloseBlackBox) -> None:
        """A run is over."""
        del self._met[order.number]
        self._post.send(encode(RunOrder(order.number, order)))
        _close(self._memories.pop(order.number))

    def written(self) -> list[BlackBoxWritten]:
        """What has been written since the last call."""
        written = []
        self._post.flush()
        while not self._post.is_closed and (received := self._post.receive()) is not None:
            written.append(decode_word(received[0]))
        return written

    def readers(self) -> Sequence[ProcessSocket]:
        """Its post, as long as it lives."""
        return () if self._post.is_closed else (self._post,)

    def _describe(self, number: int, order: OpenBlackBox | DescribeBlackBox, run: RunRecord) -> None:
        """Send the description over as memory, which stays until the other end has it."""
        body = encode_run(run)
        memory = Segment.create("black-box", len(body))
        memory.view[:] = body
        self._post.send(encode(RunOrder(number, order)), (memory.fd,))
        memories = self._memories.setdefault(number, [])
        if not self._post.is_waiting:
            _close(memories)
            memory.close()
        else:
            memories.append(memory)

    def end(self) -> None:
        """Without the post it writes what it has to and ends."""
        self._post.flush()
        self._post.close()
        try:
            self._process.wait(_ENDED_S)
        except subprocess.TimeoutExpired:
            return  # it ends by itself, as after the death of a runtime


def _close(memories: list[Segment]) -> None:
    """Give memory back."""
    while memories:
        memories.pop().close()
