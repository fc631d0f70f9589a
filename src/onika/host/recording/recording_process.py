"""The recording sink as a process, in wall time: it looks into the tables by itself, in nobody's way (law 29).

It outlives the runtime for a moment: whatever kills that, what was seen is written before this process ends.
"""

import argparse
import os
import select
import signal
import socket
import sys
from collections.abc import Sequence
from time import monotonic_ns

from msgspec import Struct, msgpack
from msgspec.structs import replace

from onika.host.processes.output_pipe import open_output_pipes
from onika.host.processes.process_socket import ProcessSocket
from onika.host.processes.realtime_scheduling import fine_timers, first_in_first_out, still_garbage
from onika.host.recording.recording_sink import (
    AddVariables,
    BeginRecording,
    DescribeRecording,
    FinishRecording,
    Order,
    RecordingSink,
    decode,
)
from onika.host.units.pose_stream import WorldPoses
from onika.record.run import RunRecord
from onika.record.writer import Writer
from onika.ring.segment import Segment
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason

PRIORITY = 1
"""Below everything that moves something, above everything that is not real time: else it would look too late."""
_BUFFER = 1 << 18


class RecordingBegun(Struct, frozen=True, tag=True):
    """The file is begun; the run may begin."""


class RecordingEnded(Struct, frozen=True, tag=True):
    """The file is finished, or why it is not; values that were written over before they were looked at, and poses
    that did not come for want of room."""

    missed: int = 0
    reason: Reason = NOTHING
    untold: int = 0


encode_word = msgpack.Encoder().encode
decode_word = msgpack.Decoder(RecordingBegun | RecordingEnded).decode
encode_run = msgpack.Encoder().encode
_decode_run = msgpack.Decoder(RunRecord).decode


def record(post: ProcessSocket, every_ns: int) -> None:
    """From the first datagram, which brings the run and the file, until the run is over or nobody is there any more."""
    select.select([post], [], [])
    received = post.receive()
    if received is None:
        return
    _, (run_fd, file_fd, inlet_fd) = received
    memory, inlet = Segment.attach(run_fd), ProcessSocket(socket.socket(fileno=inlet_fd))
    sink, reason = None, NOTHING
    try:
        with os.fdopen(file_fd, "wb", buffering=_BUFFER) as stream:
            writer = Writer(stream)
            _decode_run(bytes(memory.view)).write(writer)
            memory.close()
            sink = RecordingSink(stream, writer)
            sink.flush()
            post.send(encode_word(RecordingBegun()))
            _follow(post, inlet, sink, every_ns)
    except OSError as wrong:
        reason = system_reason(wrong)
    inlet.close()
    post.send(encode_word(RecordingEnded(sink.missed, reason, sink.untold) if sink else RecordingEnded(reason=reason)))


def _follow(post: ProcessSocket, inlet: ProcessSocket, sink: RecordingSink, every_ns: int) -> None:
    memories: dict[str, memoryview] = {}
    due, zero = 0, -1
    while not (sink.is_finished or post.is_closed):
        wait = max(due - monotonic_ns(), 0) * 1e-9 if zero >= 0 else None
        ready, _, _ = select.select([post], [], [], wait)
        while ready and not post.is_closed and (received := post.receive()) is not None:
            body, descriptors = received
            order = decode(body)
            if isinstance(order, BeginRecording):
                due = zero = order.at_ns  # before the run there is no time to write down
            if isinstance(order, FinishRecording):
                _look(inlet, sink, zero)
            _carry_out(order, descriptors, sink, memories)
        now = monotonic_ns()
        if now >= due and zero >= 0 and not sink.is_finished:
            _look(inlet, sink, zero)
            due = max(due + (2 * every_ns if sink.is_in_no_hurry else every_ns), now)
    if not sink.is_finished:
        sink.flush()  # the runtime is gone: what was seen is all there is


def _carry_out(order: Order, descriptors: Sequence[int], sink: RecordingSink, memories: dict[str, memoryview]) -> None:
    """Hand an order to the sink, with the memory of its subsystem where it is about variables."""
    if isinstance(order, DescribeRecording):
        described = Segment.attach(descriptors[0])
        sink.describe(_decode_run(bytes(described.view)))
        described.close()
        return
    if not isinstance(order, AddVariables):
        sink.take(order)
        return
    if descriptors:
        memories[order.subsystem] = Segment.attach(descriptors[0]).view
    sink.take(order, memories[order.subsystem])


def _look(inlet: ProcessSocket, sink: RecordingSink, zero: int) -> None:
    """At the variables, and at what has come from the device server."""
    sink.look(monotonic_ns() - zero)
    while not inlet.is_closed and (received := inlet.receive()) is not None:
        order = decode(received[0])
        if isinstance(order, WorldPoses):
            sink.take(replace(order, at_ns=order.told_ns - zero))


def main(words: list[str]) -> None:
    """The process."""
    parser = argparse.ArgumentParser()
    for option in ("--fd", "--parent", "--every"):
        parser.add_argument(option, type=int, required=True)
    parser.add_argument("--fifo", action="store_true")
    given = parser.parse_args(words)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    open_output_pipes()
    fine_timers()
    still_garbage()
    if given.fifo:
        first_in_first_out(PRIORITY)
    record(ProcessSocket(socket.socket(fileno=given.fd)), given.every)


if __name__ == "__main__":
    main(sys.argv[1:])
