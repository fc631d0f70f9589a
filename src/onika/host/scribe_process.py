"""The scribe as a process, in wall time: it looks into the tables by itself, and is never in anybody's way (law 29).

It outlives the runtime for a moment: whatever kills that, what was seen is written before this process ends.
"""

import argparse
import os
import select
import signal
import socket
import sys
from time import monotonic_ns

from msgspec import Struct, msgpack

from onika.host.outlet import open_outlets
from onika.host.post import Post
from onika.host.schedule import fine_timers, first_in_first_out, still_garbage
from onika.host.scribe import Finish, Meet, Scribe, Start, decode
from onika.record.run import Run
from onika.record.writer import Writer
from onika.ring.segment import Segment

PRIORITY = 1
"""Below everything that moves something, above everything that is not real time: else it would look too late."""
_BUFFER = 1 << 18


class Up(Struct, frozen=True, tag=True):
    """The file is begun; the run may begin."""


class Ended(Struct, frozen=True, tag=True):
    """The file is finished, or why it is not; values that were written over before they were looked at."""

    missed: int = 0
    reason: str = ""


encode_word = msgpack.Encoder().encode
decode_word = msgpack.Decoder(Up | Ended).decode
encode_run = msgpack.Encoder().encode
_decode_run = msgpack.Decoder(Run).decode


def record(post: Post, every_ns: int) -> None:
    """From the first datagram, which brings the run and the file, until the run is over or nobody is there any more."""
    select.select([post], [], [])
    received = post.receive()
    if received is None:
        return
    _, (run_fd, file_fd) = received
    memory = Segment.attach(run_fd)
    with os.fdopen(file_fd, "wb", buffering=_BUFFER) as stream:
        missed = 0
        try:
            writer = Writer(stream)
            _decode_run(bytes(memory.view)).write(writer)
            memory.close()
            scribe = Scribe(stream, writer)
            scribe.flush()
            post.send(encode_word(Up()))
            missed = _follow(post, scribe, every_ns)
        except OSError as wrong:
            post.send(encode_word(Ended(missed, str(wrong))))
            return
    post.send(encode_word(Ended(missed)))


def _follow(post: Post, scribe: Scribe, every_ns: int) -> int:
    segments: dict[str, Segment] = {}
    due, zero = monotonic_ns(), 0
    while not (scribe.is_finished or post.is_closed):
        ready, _, _ = select.select([post], [], [], max(due - monotonic_ns(), 0) * 1e-9)
        now = monotonic_ns()
        while ready and not post.is_closed and (received := post.receive()) is not None:
            body, descriptors = received
            order = decode(body)
            if isinstance(order, Meet) and descriptors:
                segments[order.subsystem] = Segment.attach(descriptors[0])
            if isinstance(order, Start):
                zero = order.at_ns
            if isinstance(order, Finish):
                scribe.look(now - zero)
            scribe.take(order, segments[order.subsystem].view if isinstance(order, Meet) else None)
        if now >= due and not scribe.is_finished:
            scribe.look(now - zero)
            due = max(due + every_ns, now)
    if not scribe.is_finished:
        scribe.flush()  # the runtime is gone: what was seen is all there is
    return scribe.missed


def main(words: list[str]) -> None:
    """The process."""
    parser = argparse.ArgumentParser()
    for option in ("--fd", "--parent", "--every"):
        parser.add_argument(option, type=int, required=True)
    parser.add_argument("--fifo", action="store_true")
    given = parser.parse_args(words)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    open_outlets()
    fine_timers()
    still_garbage()
    if given.fifo:
        first_in_first_out(PRIORITY)
    record(Post(socket.socket(fileno=given.fd)), given.every)


if __name__ == "__main__":
    main(sys.argv[1:])
