"""How soon a holder that dies is missed, and how often one that lives is: real processes, beats as datagrams.

Usage: python tools/bench/lease.py [SECONDS] [BUSY]. Three holders hold something for so long beside so many busy loops
of lower priority; each loss is false. Then ten more are killed or stopped, and it is measured when that is told.
"""

import os
import re
import select
import signal
import subprocess
import sys
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from time import monotonic

from onika.desk.run.remote_runtime import RemoteRuntime, connect
from onika.wire import event, holding, live

HOLDER = """
import sys
from onika.desk.run.remote_runtime import connect
from onika.wire import live
with connect(sys.argv[1], sys.argv[2]) as runtime:
    runtime.ask(live.Take(sys.argv[3]))
    print("held", flush=True)
    while True:
        list(runtime.events(10.0))
"""
BUSY = "while True: pass"


class Watcher:
    """Somebody who listens all the time, and knows when which subsystem was lost."""

    def __init__(self, runtime: RemoteRuntime) -> None:
        self.runtime = runtime
        self.lost: dict[str, tuple[float, str]] = {}

    def listen(self, seconds: float) -> None:
        """For so long."""
        until = monotonic() + seconds
        while (left := until - monotonic()) > 0:
            select.select(self.runtime.readers(), [], [], min(left, 0.05))
            for one in self.runtime.events(0.0):
                if isinstance(one, event.Held) and not one.holder:
                    self.lost[one.subsystem] = (monotonic(), one.cause)


def hold(url: str, token: str, name: str, watcher: Watcher) -> subprocess.Popen[str]:
    """A holder of its own, once it holds."""
    words = [sys.executable, "-c", HOLDER, url, token, name]
    process = subprocess.Popen(words, stdout=subprocess.PIPE, text=True)
    while not select.select([process.stdout], [], [], 0)[0]:
        watcher.listen(0.05)
    return process


def false_losses(url: str, token: str, watcher: Watcher, seconds: float) -> None:
    """How many holders that live are taken for dead."""
    holders = [hold(url, token, f"live{k}", watcher) for k in range(3)]
    watcher.listen(1.0)
    answer = watcher.runtime.ask(holding.Sessions())
    leases = [one.lease_s for one in answer.sessions] if isinstance(answer, holding.Company) else []
    watcher.listen(seconds)
    print(
        f"{seconds:g} s, 3 holders, leases {leases} s, load {os.getloadavg()[0]:.1f}: {len(watcher.lost)} false losses"
    )
    for name, (_, cause) in watcher.lost.items():
        print(f"  {name}: {cause}")
    for one in holders:
        one.kill()
        one.wait()


def true_losses(url: str, token: str, watcher: Watcher) -> None:
    """How soon those that die are missed."""
    took: dict[str, list[float]] = {}
    for k in range(10):
        how = (signal.SIGKILL, signal.SIGSTOP)[k % 2]
        process = hold(url, token, f"dead{k}", watcher)
        watcher.listen(1.0)
        began = monotonic()
        process.send_signal(how)
        while f"dead{k}" not in watcher.lost:
            watcher.listen(0.002)
        took.setdefault(how.name, []).append((watcher.lost[f"dead{k}"][0] - began) * 1e3)
        process.kill()
        process.wait()
    for name, times in took.items():
        print(f"{name} to the loss: {median(times):.0f} ms, {min(times):.0f} to {max(times):.0f}")


def main(seconds: float, busy: int) -> None:
    """Measure both."""
    with TemporaryDirectory() as state:
        environment = os.environ | {"XDG_STATE_HOME": state}
        words = [sys.executable, "-m", "onika.host", "--listen", "127.0.0.1:0", "--no-fifo"]
        loops = [subprocess.Popen(["nice", "-n", "5", sys.executable, "-c", BUSY]) for _ in range(busy)]
        with subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=environment) as runtime:
            assert runtime.stdout is not None
            found = re.search(r"listening on (\S+), token in (.*)$", runtime.stdout.readline())
            assert found is not None
            try:
                with connect(found[1], token := Path(found[2]).read_text().strip()) as asking:
                    watcher = Watcher(asking)
                    asking.ask(live.Attend(("*",)))
                    false_losses(found[1], token, watcher, seconds)
                    true_losses(found[1], token, watcher)
            finally:
                runtime.terminate()
                for one in loops:
                    one.kill()


if __name__ == "__main__":
    main(float(sys.argv[1]) if len(sys.argv) > 1 else 60.0, int(sys.argv[2]) if len(sys.argv) > 2 else 2)
