"""Opening libraries of 10, 100, 1,000 and 10,000 tasks: time in all, cost of a task, and its ratio to the smallest.

One file of a hundred is broken, each in its own way; as many are reported.
"""

import argparse
import tempfile
from pathlib import Path
from statistics import median
from time import perf_counter

from onika.store.base_directory import BaseDirectory
from onika.store.library import open_library

_TASK = """\
# task {number} of many
MODULE      jtraj
DESC        a joint path
SVARALIAS   OUT = Q_REF{number}
INCONST     NDOF
OUTCONST    none
INVAR       Q_MEZ
OUTVAR      OUT Q^_REF
TASKTYPE    periodic

FREQ        {rate}

ONIKA
OBJECT      Joint job

LOCAL
QMIN        -2.8 -3.9 -0.8 -1.9 -1.7 -4.6
QMAX        2.8 0.7 3.9 2.9 1.7 4.6

EOF
"""
_DAMAGES = (
    ("FREQ  ", "FREK  "),
    ("periodic", "sometimes"),
    ("EOF", ""),
    ("Q_MEZ", "q_mez"),
    ("OUT =", "="),
    ("LOCAL", "LOCAL x"),
    ("MODULE", "MODULE ../"),
    ("none", ""),
    ("Joint job", "Joint object"),
    ("DESC", "\x00"),
)


def fill(folder: Path, count: int) -> int:
    """Make a library of `count` tasks; gives how many of them are broken."""
    (folder / "module").mkdir(parents=True)
    broken = 0
    for number in range(count):
        text = _TASK.format(number=number, rate=1 + number % 999)
        if number % 100 == 50:
            text = text.replace(*_DAMAGES[broken % len(_DAMAGES)], 1)
            broken += 1
        (folder / "module" / f"task{number:05}.rmod").write_text(text, encoding="utf-8")
    return broken


def seconds(base: BaseDirectory, rounds: int) -> float:
    """The median time of opening it."""
    times = []
    for _ in range(rounds):
        began = perf_counter()
        open_library(base)
        times.append(perf_counter() - began)
    return median(times)


def main(arguments: list[str] | None = None) -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--most", type=int, default=10_000, help="the largest library")
    parser.add_argument("--rounds", type=int, default=3, help="how often each is opened")
    given = parser.parse_args(arguments)
    print(f"{'tasks':>7}{'left out':>10}{'ms':>10}{'us/task':>10}{'ratio':>8}")
    first = 0.0
    for count in (10, 100, 1_000, 10_000):
        if count > given.most:
            break
        with tempfile.TemporaryDirectory() as folder:
            base = BaseDirectory(Path(folder))
            broken = fill(base.path, count)
            taken = seconds(base, given.rounds * max(1, 1_000 // count))
            library = open_library(base)
        assert (len(library.tasks), len(library.left_out)) == (count - broken, broken)
        each = taken / count * 1e6
        first = first or each
        print(f"{count:>7}{broken:>10}{taken * 1e3:>10.1f}{each:>10.1f}{each / first:>8.2f}")


if __name__ == "__main__":
    main()
