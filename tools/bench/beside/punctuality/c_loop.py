"""A loop in C that sleeps to the same grid with `clock_nanosleep` and TIMER_ABSTIME, scheduled as Onika's unit is."""

import subprocess
from pathlib import Path

from beside.compiler import built
from beside.contestant import Figures, serve
from beside.punctuality.lateness import PERIOD_NS, figures, is_fifo_granted
from onika.host.processes.realtime_scheduling import PRIORITY

SOURCE = Path(__file__).with_name("loop.c")


def main() -> None:
    """The contestant."""
    with built(SOURCE) as (program, version):
        priority = PRIORITY if is_fifo_granted() else 0

        def measure(milliseconds: int) -> Figures:
            words = [program, str(milliseconds), str(priority)]
            ran = subprocess.run(words, capture_output=True, text=True, check=True)
            late = [int(line) for line in ran.stdout.split()]
            return figures(late, sum(one // PERIOD_NS for one in late))

        serve(version, measure)


if __name__ == "__main__":
    main()
