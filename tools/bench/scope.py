"""A scope of 16 variables at 500 Hz in wall time: what is lost, and whether what is lost is told.

Usage: python tools/bench/scope.py [--seconds S] [--rounds N] [--halt MS] [--no-fifo]. It asks as the page does. Each
variable counts the cycles of its task, so that what is missing between two values is known without what the runtime
tells of it. In the last part the runtime's program is halted again and again while its tasks go on: values are written
over before anybody looks at them, and as many have to be told as are missing.
"""

import argparse
import os
import signal
import sys
import tempfile
import time
from itertools import pairwise
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests"))

from browse.guest import Guest
from browse.program import program, said

from kit.labs.laboratory import Laboratory
from kit.process.process_tree import descendants, runtime_of
from onika.wire import act

TASKS, EACH, HZ = 4, 4, 500
ASKED_EVERY_S = 0.2
_SCHEDULERS = {os.SCHED_FIFO: "FIFO", os.SCHED_OTHER: "time-sharing"}

SOURCE = """
from onika.module import Module, OutVar

class Counter(Module):
{ports}
    def cycle(self):
        self.count = getattr(self, "count", 0.0) + 1.0
        {names} = self.count
"""


class Scope:
    """What a browser keeps of 16 variables."""

    def __init__(self, guest: Guest, variables: tuple[str, ...]) -> None:
        self._guest = guest
        self._variables = variables
        self._last = (0,) * len(variables)
        self.counts: dict[str, list[float]] = {variable: [] for variable in variables}
        self.told = 0

    def follow(self, seconds: float, halted: int = 0, halt_s: float = 0.0) -> None:
        """Ask again and again; meanwhile a process may be halted for a moment each time."""
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            self._ask()
            if halted:
                os.kill(halted, signal.SIGSTOP)
                time.sleep(halt_s)
                os.kill(halted, signal.SIGCONT)
            time.sleep(ASKED_EVERY_S)
        self._ask()

    def begin(self) -> None:
        """What came so far is forgotten."""
        self._ask()
        self.told = 0
        self.counts = {variable: counts[-1:] for variable, counts in self.counts.items()}

    @property
    def missing(self) -> int:
        """Values that did not come."""
        return sum(int(b - a) - 1 for counts in self.counts.values() for a, b in pairwise(counts))

    @property
    def came(self) -> int:
        """Values that came."""
        return sum(len(counts) - 1 for counts in self.counts.values())

    def _ask(self) -> None:
        views: list[dict[str, Any]] = self._guest.ask(act.SampleVariables(self._variables, self._last))
        self._last = tuple(view["last"] for view in views)
        for view in views:
            self.told += view.get("missed", 0)
            self.counts[view["variable"]] += [row[0] for row in view.get("rows", ())]


def laboratory(folder: Path) -> None:
    """Four tasks of four variables each, in one configuration."""
    lab = Laboratory(folder)
    for number in range(TASKS):
        names = [f"C{number}_{each}" for each in range(EACH)]
        ports = "".join(f'    {name} = OutVar("double", "-", "cycles")\n' for name in names)
        lab.module(f"counter{number}", SOURCE.format(ports=ports, names=" = ".join(f"self.{name}" for name in names)))
        lab.plain_task(f"counter{number}", writes=" ".join(names), hz=HZ)
    lab.configuration("counters", *(f"counter{number} {HZ}" for number in range(TASKS)))


def main() -> None:
    """All of it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--halt", type=float, default=100.0, metavar="MS")
    parser.add_argument("--no-fifo", action="store_true")
    given = parser.parse_args()
    more = ("--no-fifo",) if given.no_fifo else ()
    with tempfile.TemporaryDirectory() as folder:
        laboratory(Path(folder))
        with program("--base", folder, *more, "counters") as (address, pid, _later):
            guest = Guest(address)
            guest.until(act.Turn("c1", tuple(f"counter{number}" for number in range(TASKS)), True))
            scope = Scope(guest, tuple(f"c1/C{number}_{each}" for number in range(TASKS) for each in range(EACH)))
            scope.follow(1.0)
            policies = [os.sched_getscheduler(each) & ~os.SCHED_RESET_ON_FORK for each in descendants(pid)]
            schedulers = {_SCHEDULERS.get(policy, "another") for policy in policies}
            said("processes are scheduled by", ", ".join(sorted(schedulers)))
            for _ in range(given.rounds):
                measure(scope, given.seconds, "16 variables at 500 Hz")
            measure(
                scope, given.seconds, f"the same, halted for {given.halt:g} ms each time",
                halted=runtime_of(pid), halt_s=given.halt * 1e-3,
            )  # fmt: skip


def measure(scope: Scope, seconds: float, title: str, **halting: Any) -> None:
    """One line: how many came, how many are missing, how many were told to be."""
    scope.begin()
    scope.follow(seconds, **halting)
    said(f"{title}: came / missing / told", f"{scope.came} / {scope.missing} / {scope.told}")


if __name__ == "__main__":
    main()
