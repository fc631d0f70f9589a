"""The process that holds the last seconds of runs, in wall time (requirement X05).

While nothing runs it sleeps. It is no real-time process: what a busy machine lets it miss is counted, and said in what
it writes. Where the runtime is gone without a word it writes what it holds, and ends.
"""

import argparse
import os
import select
import signal
import socket
import sys
from collections.abc import Sequence
from time import monotonic_ns, sleep

from onika.host.processes.output_pipe import open_output_pipes
from onika.host.processes.process_socket import ProcessSocket
from onika.host.processes.realtime_scheduling import still_garbage
from onika.host.recording.black_box_orders import (
    CloseBlackBox,
    DescribeBlackBox,
    KeepBlackBox,
    OpenBlackBox,
    RunOrder,
    decode_order,
    decode_run,
    encode_word,
)
from onika.host.recording.held_run import HeldRun
from onika.host.recording.last_seconds import TracedEvent, TracedVariables
from onika.record.run import RunRecord
from onika.ring.segment import Segment
from onika.words.reason import Reason

_NICE = 5
_PATIENCE_S = 10
"""How long it may take to write what it holds of a runtime that is gone."""


def hold(post: ProcessSocket) -> None:
    """Until nobody is there any more."""
    runs = _Runs(post)
    due = 0
    while not post.is_closed:
        if runs.is_empty:
            select.select([post], [], [])
        else:
            sleep(max(due - monotonic_ns(), 0) * 1e-9)  # orders wait for the look: each would wake it for itself
        while not post.is_closed and (received := post.receive()) is not None:
            runs.carry_out(decode_order(received[0]), received[1])
        now = monotonic_ns()
        runs.look(now)
        due = now + runs.every_ns
    signal.alarm(_PATIENCE_S)
    for body, descriptors in iter(post.receive, None):  # it may have been answered too late to notice an end
        runs.carry_out(decode_order(body), descriptors)
    runs.end()


class _Runs:
    """Every run that is held, with the memory in which its variables lie."""

    def __init__(self, post: ProcessSocket) -> None:
        self._post = post
        self._runs: dict[int, HeldRun] = {}
        self._memories: dict[int, dict[str, Segment]] = {}

    @property
    def is_empty(self) -> bool:
        """Whether nothing runs."""
        return not self._runs

    @property
    def every_ns(self) -> int:
        """How often to look."""
        return min((run.order.every_ns for run in self._runs.values()), default=0)

    def look(self, now: int) -> None:
        """Look at all variables."""
        for run in self._runs.values():
            run.look(now)

    def carry_out(self, run_order: RunOrder, descriptors: Sequence[int]) -> None:
        """Do what the runtime says."""
        number, order = run_order.number, run_order.order
        match order:
            case OpenBlackBox():
                self._runs[number] = HeldRun(order, _description(descriptors[0]))
                self._memories[number] = {}
            case DescribeBlackBox():
                self._runs[number].run = _description(descriptors[0])
            case TracedVariables():
                memories = self._memories[number]
                if descriptors:
                    memories[order.subsystem] = Segment.attach(descriptors[0])
                self._runs[number].last_seconds.meet(order, memories[order.subsystem].view)
            case TracedEvent():
                self._runs[number].last_seconds.note(order)
            case KeepBlackBox():
                self._runs[number].look(monotonic_ns())
                self._post.send(encode_word(self._runs[number].write(order.words, order.path)))
            case CloseBlackBox():
                self._close(order)

    def _close(self, order: CloseBlackBox) -> None:
        run = self._runs.pop(order.number)
        if order.is_kept:
            run.look(monotonic_ns())
            self._post.send(encode_word(run.write(order.words)))
        del run  # its traces look into the memory
        for memory in self._memories.pop(order.number).values():
            memory.close()

    def end(self) -> None:
        """The runtime is gone, and nobody said how its runs have ended."""
        for run in self._runs.values():
            run.look(monotonic_ns())
            run.write({"completed": "no", "cause": str(Reason.of("host.runtime_killed")), "hash": "", "outside": ""})


def _description(descriptor: int) -> RunRecord:
    """What is held, described in memory of its own."""
    memory = Segment.attach(descriptor)
    try:
        return decode_run(bytes(memory.view))
    finally:
        memory.close()


def main(words: list[str]) -> None:
    """The process."""
    parser = argparse.ArgumentParser()
    for option in ("--fd", "--parent"):
        parser.add_argument(option, type=int, required=True)
    given = parser.parse_args(words)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    open_output_pipes()
    os.nice(_NICE)
    still_garbage()
    hold(ProcessSocket(socket.socket(fileno=given.fd)))


if __name__ == "__main__":
    main(sys.argv[1:])
