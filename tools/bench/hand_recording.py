"""What a recording of what lives by hand costs: 16 variables at 500 Hz, in wall time, beside not recording.

Usage: python tools/bench/hand_recording.py [--seconds S] [--rounds N] [--no-fifo]. One runtime lives on; stretches with
and without a recording take turns, so that the machine's other load falls on both alike. Told are the shares of a core
of its processes, cycles that were missed and values that the recording did not see. The last line is the cost, the
median of the rounds.
"""

import argparse
import sys
import tempfile
import time
from pathlib import Path
from statistics import median

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests"))

from kit.plans.plan_builder import PlanBuilder
from kit.process.process_tree import descendants
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.record.reader import Reader
from onika.wire import live

TASKS, EACH, HZ = 4, 4, 500
PLACE = "bench"

SOURCE = """
from onika.module import Module, OutVar

class Counter(Module):
{ports}
    def cycle(self):
        self.count = getattr(self, "count", 0.0) + 1.0
        {names} = self.count
"""


def main() -> None:
    """Print a line for each stretch."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--no-fifo", action="store_true")
    given = parser.parse_args()
    with (
        tempfile.TemporaryDirectory() as folder,
        LaunchedRuntime(("rt0",), is_virtual=False, with_fifo=not given.no_fifo) as runtime,
    ):
        _bring_to_life(runtime)
        costs = []
        for number in range(given.rounds):
            plain = _stretch("plain", runtime, given.seconds)
            path = Path(folder) / f"{number}.mcap"
            runtime.ask(live.Record(PLACE, str(path)))
            recorded = _stretch("recorded", runtime, given.seconds)
            runtime.ask(live.Record(PLACE))
            list(runtime.events(0.5))
            costs.append(recorded - plain)
            print(f"{'':8}  {_seen(path, given.seconds)}; it costs {costs[-1]:.1f} % of a core", flush=True)
    print(f"recording {TASKS * EACH} variables at {HZ} Hz by hand costs {median(costs):.1f} % of a core")


def _bring_to_life(runtime: LaunchedRuntime) -> None:
    shop = PlanBuilder()
    names = [f"c{number}" for number in range(TASKS)]
    for name in names:
        ports = [f"{name.upper()}_{index}" for index in range(EACH)]
        lines = "".join(f'    {port} = OutVar("double", "-", "how many cycles")\n' for port in ports)
        shop.task(name, SOURCE.format(ports=lines, names=" = ".join(f"self.{port}" for port in ports)), frequency=HZ)
    planned, code = tuple(map(shop.planned, names)), tuple(map(shop.code, names))
    runtime.ask(live.Change(PLACE, spawn=planned, code=code, on=tuple(map(live.Turn, names))))
    list(runtime.events(1.0))


def _stretch(kind: str, runtime: LaunchedRuntime, seconds: float) -> float:
    """Print what the processes use for so long; the share of a core of all in %."""
    before, begin = _used(runtime.pid), time.monotonic()
    while time.monotonic() < begin + seconds:
        list(runtime.events(0.2))
    after, lasted = _used(runtime.pid), time.monotonic() - begin
    share = 100 * (after - before) / lasted
    print(f"{kind:8}  {share:.1f} % of a core", flush=True)
    return share


def _used(parent: int) -> float:
    """Seconds of processor of a process and all below it."""
    total = 0.0
    for pid in (parent, *descendants(parent)):
        try:
            total += int(Path(f"/proc/{pid}/schedstat").read_text().split()[0]) * 1e-9
        except OSError:
            continue
    return total


def _seen(path: Path, seconds: float) -> str:
    reader = Reader(path)
    count = sum(map(reader.count, reader.channels))
    size, unseen = path.stat().st_size, reader.notes["end"]["missed"]
    return f"{count / seconds:.0f} values/s, {size / seconds / 1e3:.0f} kB/s, {unseen} unseen"


if __name__ == "__main__":
    main()
