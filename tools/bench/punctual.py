"""Punctuality: how late cycles begin in wall time, and how many are missed, beside a bare sleep loop.

An RTPU process runs tasks at 1000, 500 and 250 Hz, with SCHED_FIFO and without; the bare loop sleeps to the same grid
of 500 Hz in a process of its own, scheduled alike. Configurations alternate in rounds, so that they share the
machine's moods.
"""

import argparse
import json
import os
import select
import statistics
import subprocess
import sys
from collections.abc import Iterable
from time import monotonic_ns

from onika.host.processes.child_process import serve_forks
from onika.host.units import rtpu
from onika.host.units.supervisor import Supervisor
from onika.ring.segment import Segment
from onika.runtime import command, news
from onika.runtime.table import SIZE

RATES = (1000.0, 500.0, 250.0)

MODULE = '''
from onika.module import Module

class Late(Module):
    """Keeps how late each of its cycles began."""
    def on(self, inputs):
        self.late = []
    def cycle(self):
        period = round(self.dt * 1e9)
        self.late.append(round(self.now * 1e9) % period)
    def get(self, name):
        return self.late[1:]
'''

BARE = """
import json, sys, time
from onika.host.processes.realtime_scheduling import become_real_time
become_real_time(sys.argv[1] == "fifo")
period, late = 2_000_000, []
until = time.monotonic_ns() + round(float(sys.argv[2]) * 1e9)
due = (time.monotonic_ns() // period + 1) * period
while due < until:
    while (left := due - time.monotonic_ns()) > 0:
        time.sleep(left * 1e-9)
    now = time.monotonic_ns()
    late.append(now - due)
    due = (now // period + 1) * period
print(json.dumps(late))
"""


def bare(with_fifo: bool, seconds: float) -> list[int]:
    """Lateness of a loop that does nothing but sleep."""
    words = [sys.executable, "-c", BARE, "fifo" if with_fifo else "other", str(seconds)]
    return list(json.loads(subprocess.run(words, capture_output=True, text=True, check=True).stdout))


def tasks(with_fifo: bool, seconds: float) -> tuple[dict[float, list[int]], dict[float, int]]:
    """Lateness and missed cycles of each task, by its rate."""
    supervisor = Supervisor(monotonic_ns(), with_fifo)
    unit = supervisor.launch("rt0", "rt0", "onika.host.units.rtpu", ("--name", "rt0"))
    table = Segment.create("table", SIZE)
    try:
        hear(unit, rtpu.UnitReady)
        unit.post.send(rtpu.encode(rtpu.Share("table:bench")), (table.fd,))
        for rank, rate in enumerate(RATES):
            name = f"late{rate:.0f}"
            order = command.Spawn("bench", name, "late", "late.py", MODULE, "periodic", rate, (), (), rank, 0, None)
            unit.post.send(rtpu.encode(order))
            hear(unit, news.Initialised)
        launches = tuple(command.Launch(f"late{rate:.0f}") for rate in RATES)
        unit.post.send(rtpu.encode(command.Switch("bench", (), (), launches)))
        until = monotonic_ns() + round(seconds * 1e9)
        while monotonic_ns() < until:
            select.select([unit.post], [], [], 0.2)
            while unit.post.receive() is not None:
                pass
        unit.post.send(rtpu.encode(command.Report()))
        statuses = hear(unit, news.Statuses)
        unit.post.send(rtpu.encode(command.Switch("bench", tuple(one.task for one in statuses.tasks), (), ())))
        late = {}
        for rate in RATES:
            unit.post.send(rtpu.encode(command.Get("bench", f"late{rate:.0f}", "late")))
            late[rate] = hear(unit, news.Got).value
        return late, {one.reference_hz: one.miss for one in statuses.tasks}
    finally:
        supervisor.end()


def hear(unit: object, kind: type) -> object:
    """The next news of a kind."""
    while True:
        select.select([unit.post], [], [], 5.0)
        received = unit.post.receive()
        if received is None:
            assert not unit.post.is_closed, "the unit is gone"
            continue
        for heard in rtpu.decode_news(received[0]):
            if isinstance(heard, kind):
                return heard


def row(what: str, how: str, late: Iterable[int], missed: int | None) -> None:
    """Print one line of the table."""
    found = sorted(late)
    figures = (statistics.median(found), found[int(len(found) * 0.99)], found[-1])
    numbers = "".join(f"{one / 1e3:>10.0f}" for one in figures)
    print(f"{what:<18}{how:<14}{len(found):>8}{numbers}{'' if missed is None else missed:>8}")


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=3.0)
    parser.add_argument("--rounds", type=int, default=3)
    given = parser.parse_args()
    serve_forks()  # units begin as those of a runtime do
    late: dict[tuple[str, str], list[int]] = {}
    missed: dict[tuple[str, str], int] = {}
    for _ in range(given.rounds):
        for with_fifo in (True, False):
            how = "FIFO" if with_fifo else "time-sharing"
            found, misses = tasks(with_fifo, given.seconds)
            for rate in RATES:
                key = (f"task {rate:.0f} Hz", how)
                late.setdefault(key, []).extend(found[rate])
                missed[key] = missed.get(key, 0) + misses[rate]
            late.setdefault(("bare loop 500 Hz", how), []).extend(bare(with_fifo, given.seconds))
    load = os.getloadavg()[0]
    print(f"lateness in us; {given.rounds} rounds of {given.seconds:g} s; load {load:.1f}")
    print(f"{'what':<18}{'scheduling':<14}{'cycles':>8}{'median':>10}{'p99':>10}{'max':>10}{'missed':>8}")
    for key in sorted(late, key=lambda one: (one[1], one[0])):
        row(*key, late[key], missed.get(key))


if __name__ == "__main__":
    main()
