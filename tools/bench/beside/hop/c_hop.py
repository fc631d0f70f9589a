"""A hop in C by the same calls of the system: what of Onika's hop is the kernel's."""

import subprocess
from pathlib import Path

from beside.compiler import built
from beside.contestant import Figures, serve
from beside.hop.vector import WARM_UP, figures

SOURCE = Path(__file__).with_name("hop.c")


def main() -> None:
    """The contestant."""
    with built(SOURCE) as (program, version):

        def measure(count: int) -> Figures:
            ran = subprocess.run([program, str(WARM_UP), str(count)], capture_output=True, text=True, check=True)
            return figures([int(line) / 1e3 for line in ran.stdout.split()])

        serve(version, measure)


if __name__ == "__main__":
    main()
