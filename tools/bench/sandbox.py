"""What a cycle costs whose module is in a sandbox, as code of libraries of others is, beside one that is not.

Usage: python tools/bench/sandbox.py [--cycles N] [--rounds N]. Both have six inputs and six outputs of `double[6]`, and
are cycled by an executive in turns. The process of the sandbox is a real one. Microseconds of a cycle, medians.
"""

import argparse
import sys
from pathlib import Path
from statistics import median
from time import perf_counter_ns

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests"))

from kit.runtime.executive_rig import HOME, ExecutiveRig
from kit.runtime.local_sandbox import sandboxed
from onika.host.sandbox.sandbox_end import SandboxEnd
from onika.host.sandbox.sandboxes import Sandboxes

PORTS = 6
SOURCE = "\n".join(
    (
        "from onika.module import InVar, Module, OutVar",
        "",
        "class Scale(Module):",
        *(f'    X{k} = InVar("double[6]", "rad", "what is scaled")' for k in range(PORTS)),
        *(f'    Y{k} = OutVar("double[6]", "rad", "scaled")' for k in range(PORTS)),
        "",
        "    def cycle(self):",
        *(f"        self.Y{k} = 2.0 * self.X{k}" for k in range(PORTS)),
    )
)
_PERIOD = 10_000_000


def rig_of(sandboxes: Sandboxes | None) -> ExecutiveRig:
    """A task that is ON, in a sandbox or not."""
    rig = ExecutiveRig()
    spawn = rig.spawn_of("scale", SOURCE)
    if sandboxes is not None:
        spawn = sandboxed(spawn)
        begun = sandboxes.begin(spawn)
        rig.executive.give_sandbox((HOME, "scale"), SandboxEnd(begun.post, begun.memory, begun.process))
    return rig.do(spawn).switch(on=["scale"])


def cycles_us(rig: ExecutiveRig, cycles: int) -> float:
    """Microseconds that a cycle takes, on the average of so many."""
    before = rig.task("scale").counters.cycles
    began = perf_counter_ns()
    rig.run(rig.now + cycles * _PERIOD)
    took = perf_counter_ns() - began
    return took / 1e3 / (rig.task("scale").counters.cycles - before)


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--cycles", type=int, default=5000)
    parser.add_argument("--rounds", type=int, default=7)
    given = parser.parse_args()
    sandboxes = Sandboxes()
    rigs = rig_of(None), rig_of(sandboxes)
    for rig in rigs:
        cycles_us(rig, 200)
    rounds = [[cycles_us(rig, given.cycles) for rig in rigs] for _ in range(given.rounds)]
    sandboxes.close()
    free, confined = (median(column) for column in zip(*rounds, strict=True))
    print(f"without a sandbox {free:6.1f} µs, in one {confined:6.1f} µs a cycle, {confined / free:.1f} times")


if __name__ == "__main__":
    main()
