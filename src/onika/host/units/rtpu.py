"""One RTPU as a process: an executive in one thread, woken by its own grid or by a command."""

import argparse
import select
import signal
import socket
import sys
from collections.abc import Sequence
from time import monotonic_ns

from msgspec import Struct, msgpack

from onika.host.guards.code_guard import CodeGuard, own_code
from onika.host.guards.code_watch import CodeWatch
from onika.host.guards.descriptor_guard import DescriptorGuard
from onika.host.guards.memory_limit import bound
from onika.host.processes.output_pipe import open_output_pipes
from onika.host.processes.preloaded_libraries import preload
from onika.host.processes.process_socket import ProcessSocket
from onika.host.processes.realtime_scheduling import become_real_time
from onika.host.sandbox.sandbox_end import SandboxEnd
from onika.host.units.early_wake import EarlyWake
from onika.host.units.garbage import Garbage
from onika.host.units.heartbeat import Heartbeat
from onika.link.child.launcher import die_with_parent
from onika.ring.segment import Segment
from onika.runtime import command, news
from onika.runtime.execution.executive import Executive

_LONGEST_SLEEP_NS = 20_000_000

_KEPT_NS = 500_000
"""So long, at most, may the outcome of a switch wait to be told, while the first cycles after it are due."""


class Share(Struct, frozen=True, tag=True):
    """Shared memory by this name comes with this datagram."""

    name: str


class Unshare(Struct, frozen=True, tag=True):
    """The shared memory of this name is not used any more."""

    name: str


class GiveSandbox(Struct, frozen=True, tag=True):
    """The sandbox of a task that is still to come: its socket, its memory and its process come with this datagram."""

    subsystem: str
    task: str


class UnitReady(Struct, frozen=True, tag=True):
    """The process is up; what the operating system granted it."""

    granted: dict[str, bool]


encode = msgpack.Encoder().encode
decode_command = msgpack.Decoder(Share | Unshare | GiveSandbox | command.Command).decode
decode_news = msgpack.Decoder(list[UnitReady | news.News]).decode
"""News come as lists: what one command or cycle led to is one datagram."""


class Rtpu:
    """The loop around an executive."""

    def __init__(self, name: str, post: ProcessSocket, heartbeat: Heartbeat, zero_ns: int) -> None:
        self._post = post
        self._heartbeat = heartbeat
        self._zero = zero_ns
        self._views: dict[str, memoryview] = {}
        self._segments: dict[str, Segment] = {}
        watch = DescriptorGuard(post.fileno(), heartbeat.watch, heartbeat.leave).watch
        self._executive = Executive(name, self._views, watch, heartbeat.begin_words)
        self._garbage = Garbage()
        self._early_wake: EarlyWake | None = None
        """None where the machine grants no real time."""
        self.code_watch = CodeWatch(CodeGuard(own_code()), heartbeat.leave, heartbeat.look)
        """Whoever runs this in a process of its own begins it."""
        self._over = False
        self._untold: list[news.News] = []
        self._untold_since = 0

    def run(self) -> None:
        """Until told to quit, or until the runtime is gone: then devices are put in hold."""
        while not (self._over or self._post.is_closed):
            self._heartbeat.beat()
            run_next = self._executive.run_next(self._now())
            if run_next is None:
                self._tell()
                if not self._rest():
                    continue  # nothing was said meanwhile: to look would only make the next cycle later
            else:
                self._note(run_next)
                self._take_events(0.0)
            self._take_commands()
        self._executive.handle(command.Stop(), self._now())

    def share_processor(self) -> None:
        """The machine grants no real time."""
        self._executive.share_processor()

    def keep_the_grid(self) -> None:
        """The machine grants real time: cycles begin at their instants, not when the system gets round to it."""
        self._early_wake = EarlyWake()

    def _now(self) -> int:
        return monotonic_ns() - self._zero

    def _rest(self) -> bool:
        """Nothing is due: what was put aside for a gap, then sleep; whether there may be commands."""
        self._heartbeat.is_slow(True)
        self._tell(self._executive.work(self._now()))
        self._heartbeat.is_slow(False)
        self.code_watch.look_if_due()
        due = self._executive.next_release()
        self._garbage.collect(None if due is None else due - self._now())
        return self._sleep(_LONGEST_SLEEP_NS) if due is None else self._sleep_until(due)

    def _sleep_until(self, due: int) -> bool:
        """Sleep until a cycle is due, or for so long as one may; whether there may be commands."""
        left = due - self._now()
        if self._early_wake is None or not 0 < left < _LONGEST_SLEEP_NS:
            return self._sleep(min(left, _LONGEST_SLEEP_NS))
        wanted = due - self._early_wake.lead_ns(left)
        if self._sleep(wanted - self._now()):
            return True
        woken = self._now()
        if woken < wanted:
            return False  # the event of a synchronous task was taken in: there is time to sleep on
        self._early_wake.note(woken - wanted)
        while woken < due:
            woken = self._now()
        return False

    def _sleep(self, wait_ns: int) -> bool:
        """Sleep so long, unless something comes; whether there may be commands."""
        if wait_ns <= 0:
            return True
        writable = [self._post] if self._post.is_waiting else []
        return self._take_events(wait_ns * 1e-9, [self._post], writable)

    def _take_events(
        self, wait_s: float, readers: Sequence[ProcessSocket] = (), writable: Sequence[ProcessSocket] = ()
    ) -> bool:
        """Wait for commands and for the events of synchronous tasks, and run the tasks whose event has come.

        Says whether something came by post, or waits to be sent and can be.
        """
        events = self._executive.events()
        if not (events or readers):
            return True
        waiting: list[ProcessSocket | int] = [*readers, *events]
        ready, free, _ = select.select(waiting, writable, [], wait_s)
        for one in ready:
            if isinstance(one, int):
                self._tell(self._executive.event(events[one], self._now()))
        return bool(free) or self._post in ready

    def _note(self, newses: Sequence[news.News]) -> None:
        """Tell what a cycle led to; what nobody has to answer only when the cycles that are due now have begun.

        To send it takes about as long as a cycle, and would part a finish from the job that follows, or the first
        cycles of flows that have met.
        """
        if newses and not self._untold:
            self._untold_since = self._now()
        self._untold += newses
        if not all(map(_may_wait, newses)) or (self._untold and self._now() - self._untold_since > _KEPT_NS):
            self._tell()

    def _tell(self, newses: Sequence[news.News] = ()) -> None:
        """Tell this, after whatever is still to be told."""
        self._untold += newses
        if self._untold:
            self._post.send(encode(self._untold))
            self._untold.clear()

    def _take_commands(self) -> None:
        if self._post.is_waiting:
            self._post.flush()
        while (received := self._post.receive()) is not None:
            body, descriptors = received
            order = decode_command(body)
            if isinstance(order, Share | Unshare):
                self._share(order, descriptors)
                continue
            if isinstance(order, GiveSandbox):
                sandbox = SandboxEnd.of_descriptors(*descriptors)
                self._executive.give_sandbox((order.subsystem, order.task), sandbox)
                continue
            slow = isinstance(order, command.Spawn | command.Swap | command.Reinit)
            if slow:
                self._heartbeat.is_slow(True)
            self._tell(self._executive.handle(order, self._now()))
            if isinstance(order, command.Kill | command.Swap):
                self._garbage.note()
            if slow:
                self._heartbeat.is_slow(False)
            self._over = self._over or isinstance(order, command.Quit)
            self._heartbeat.beat()

    def _share(self, order: Share | Unshare, descriptors: list[int]) -> None:
        """See other memory under a name, or none; the old one is given back."""
        self._views.pop(order.name, None)
        if order.name in self._segments:
            self._segments.pop(order.name).close()
        if isinstance(order, Share):
            segment = self._segments[order.name] = Segment.attach(descriptors[0])
            self._views[order.name] = segment.view


def _may_wait(message: news.News) -> bool:
    """Whether it is the outcome of what was wanted, so that nobody waits for it to decide what follows."""
    match message:
        case news.Cycled() | news.Stepped() | news.Appointed():
            return True
        case news.Changed():
            return not message.signal
        case news.Finished():
            return message.switched > 0
    return False


def main(words: list[str]) -> None:
    """The process."""
    parser = argparse.ArgumentParser()
    for option in ("--fd", "--beat-fd", "--zero", "--parent"):
        parser.add_argument(option, type=int, required=True)
    parser.add_argument("--name", required=True)
    parser.add_argument("--fifo", action="store_true")
    given = parser.parse_args(words)
    die_with_parent(given.parent)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    open_output_pipes()
    preload()
    post = ProcessSocket(socket.socket(fileno=given.fd))
    heartbeat = Heartbeat(Segment.attach(given.beat_fd))
    bound()
    rtpu = Rtpu(given.name, post, heartbeat, given.zero)
    granted = become_real_time(given.fifo)
    if granted["SCHED_FIFO"]:
        rtpu.keep_the_grid()
    else:
        rtpu.share_processor()
    rtpu.code_watch.begin()
    heartbeat.beat()  # before it is said to be up: from then on silence counts
    post.send(encode([UnitReady(granted)]))
    with rtpu.code_watch.blaming():
        rtpu.run()


if __name__ == "__main__":
    main(sys.argv[1:])
