"""How far apart two runtimes begin what they agreed on, with the bound that is said beforehand; what a meeting costs.

Both are processes of this machine, so that one clock tells when the first cycles behind each tag were. Their datagrams
go through a line that keeps them for as long as the options say, in the way of a network.
"""

import argparse
import tempfile
from pathlib import Path
from random import Random
from statistics import median

from msgspec.structs import replace

from kit.plans.plan_builder import PlanBuilder, action
from kit.process.meeting_runtimes import Meeting
from onika.wire import event, steer
from onika.wire.plan import Do, Halt, Meet, Plan

CLOCK = """
from time import monotonic_ns

from onika.module import Input, Module, finish

class Clock(Module):
    trigger = True
    count = Input("int", "-", "how many cycles", low=1, high=1000)

    def init(self):
        self._firsts = []

    def on(self, inputs):
        self._left, self._is_first = inputs.count, True

    def cycle(self):
        if self._is_first:
            self._firsts.append(monotonic_ns())
            self._is_first = False
        self._left -= 1
        return finish() if self._left <= 0 else None

    def kill(self):
        with open("PATH", "w") as written:
            written.write(" ".join(map(str, self._firsts)))
"""


def plan(site: int, actions: int, path: Path) -> Plan:
    """One flow of so many actions of a twentieth of a second; each begins at the tag."""
    shop = PlanBuilder()
    shop.task("clock", CLOCK.replace("PATH", str(path)), frequency=100.0)
    whole = shop.plan([action("clock", arguments="5")] * actions)
    program = [instruction for number in range(actions) for instruction in (Meet("x"), Do(number))]
    return replace(whole, flows=(replace(whole.flows[0], subsystem=f"flow{site}", program=(*program, Halt())),))


def measure(folder: Path, actions: int, one_way_ms: float, jitter_ms: float, loss: float, *options: str) -> str:
    """A line of figures."""
    random = Random(1)

    def way() -> float | None:
        if random.random() < loss:
            return None
        return one_way_ms / 1e3 + random.expovariate(1.0) * jitter_ms / 1e3

    meeting = Meeting(folder, *options, way=way)
    try:
        paths = [folder / f"begins{site}" for site in range(2)]
        meeting.link(*(plan(site, actions, path) for site, path in enumerate(paths)))
        meeting.begin()
        held = 0
        while len(meeting.of(event.Result)) < 2:
            meeting.listen(5.0)
            for site, runtime in enumerate(meeting.runtimes):
                held += not hasattr(runtime.ask(steer.Recover(f"flow{site}")), "reason")
        times = [[int(word) for word in path.read_text().split()] for path in paths]
    finally:
        meeting.close()
    pairs = list(zip(*times, strict=False)) if not held else []
    skews = [abs(one - other) / 1e6 for one, other in pairs] or [float("nan")]
    each = [(late - early) / 1e6 - 50 for early, late in zip(times[0], times[0][1:], strict=False)]
    return (
        f"{one_way_ms} + {jitter_ms} ms, {loss:.0%} lost: {len(pairs)} begins, apart {median(skews):.2f} ms, "
        f"at most {max(skews):.2f}; clocks judged to {meeting.terms.clock_ns / 1e6:.2f} ms, "
        f"alone at most {meeting.alone_s * 1e3:.0f} ms, a meeting takes {median(each):.0f} ms; held {held} times"
    )


def main() -> None:
    """Measure, and print a line for a network of this room and for one across the world."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--actions", type=int, default=40)
    parser.add_argument("--no-fifo", action="store_true")
    given = parser.parse_args()
    options = ["--no-fifo"] if given.no_fifo else []
    for one_way_ms, jitter_ms, loss in ((0.5, 0.1, 0.0), (100.0, 10.0, 0.02)):
        with tempfile.TemporaryDirectory() as folder:
            print(measure(Path(folder), given.actions, one_way_ms, jitter_ms, loss, *options))


if __name__ == "__main__":
    main()
