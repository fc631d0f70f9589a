"""Starts a runtime: `python -m onika.host --link-fd N --parent PID [--virtual] [--rtpu NAME ...]`."""

import argparse
import secrets
import select
import signal
import sys
from time import monotonic_ns

from onika.host.gate import Gate
from onika.host.loader import Loader
from onika.host.outlet import open_outlets
from onika.host.patience import Patience
from onika.host.post import Post
from onika.host.program import Program
from onika.host.rtpu import preload
from onika.host.schedule import RUNNER_PRIORITY, fine_timers, first_in_first_out, still_garbage
from onika.host.virtual import VirtualDriver
from onika.host.wall import WallDriver
from onika.link.journal import Journal
from onika.link.launcher import die_with_parent, inherit
from onika.link.port import ServerPort
from onika.link.terms import CHILD

_SLICE_NS = 20_000_000


def main(words: list[str]) -> None:
    """The process."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--link-fd", type=int, required=True)
    parser.add_argument("--parent", type=int, required=True)
    parser.add_argument("--virtual", action="store_true")
    parser.add_argument("--no-fifo", action="store_true")
    parser.add_argument("--rtpu", action="append", default=[])
    given = parser.parse_args(words)
    die_with_parent(given.parent)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    open_outlets()
    rtpus = tuple(given.rtpu) or ("rt0",)
    loader = Loader()
    port = ServerPort(Journal(secrets.token_hex(16)), terms=CHILD)
    port.attach(inherit(given.link_fd), monotonic_ns())
    gate = Gate(port, monotonic_ns)
    try:
        if given.virtual:
            preload()
            patience = Patience()
            virtual = VirtualDriver(rtpus, gate.tell, watch=patience.watch)
            still_garbage()
            _virtual(Program(gate, virtual, loader, rtpus), gate)
        else:
            wall = WallDriver(rtpus, gate.tell, with_fifo=not given.no_fifo)
            fine_timers()
            if not given.no_fifo:
                first_in_first_out(RUNNER_PRIORITY)
            try:
                _wall(Program(gate, wall, loader, rtpus), gate, wall)
            finally:
                wall.close()
    finally:
        loader.close()


def _virtual(program: Program, gate: Gate) -> None:
    """As fast as it goes while something happens by itself; else wait for the environment."""
    while gate.is_open and not program.is_over:
        goes_on = program.advance(_SLICE_NS)
        select.select([gate], [gate] if gate.is_waiting else [], [], 0.0 if goes_on else 0.1)
        program.serve()
    _say_last(gate)


def _wall(program: Program, gate: Gate, driver: WallDriver) -> None:
    """Woken by the processes, by the environment, or by time."""
    while gate.is_open and not program.is_over:
        readers: list[Gate | Post] = [gate, *(one.post for one in driver.posts())]
        select.select(readers, [gate] if gate.is_waiting else [], [], driver.wait_s())
        driver.look_after()  # first the robot, then the listeners
        program.advance(0)
        program.serve()
    _say_last(gate)


def _say_last(gate: Gate) -> None:
    """Let the last words out, for a moment at most."""
    until = monotonic_ns() + 500_000_000
    while gate.is_open and gate.is_waiting and monotonic_ns() < until:
        select.select([], [gate], [], 0.05)
        gate.requests()


if __name__ == "__main__":
    main(sys.argv[1:])
