"""What the black box costs a run: the share of a core in wall time, the share of the run's own time in virtual time.

Usage: python tools/bench/black_box.py [--rounds N] [--application NAME] [--no-fifo]. Runs with and without it take
turns, so that the machine's other load falls on both alike. In wall time the process that holds it is told apart: its
share is what the black box costs beside the runtime program's own part, which is the difference of the two kinds of
runs. In virtual time seconds of processor are compared, of a run that ends well.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
from pathlib import Path
from statistics import median

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "src"))

from recording import onika_words, shares_of

HOLDER = "recording.black_box_process"


def main() -> None:
    """Print a table, and the cost as the last line."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--application", default="assemble")
    parser.add_argument("--no-fifo", action="store_true")
    given = parser.parse_args()
    holders, runtimes, virtual = [], [], []
    for _ in range(given.rounds):
        plain, boxed = (_wall(given, words) for words in (["--no-black-box"], []))
        holders.append(boxed.get(HOLDER, 0.0))
        runtimes.append(boxed["runtime"] - plain["runtime"])
        without, with_it = (_virtual(given, words) for words in (["--no-black-box"], []))
        virtual.append(100 * (with_it / without - 1))
        print(
            f"wall time: its process {holders[-1]:.2f} %, the runtime program {runtimes[-1]:+.2f} % of a core"
            f"   virtual time: {without:.2f} s of processor without, {with_it:.2f} s with it ({virtual[-1]:+.1f} %)",
            flush=True,
        )
    wall = f"{median(holders):.2f} % of a core and {median(runtimes):+.2f} % in the runtime program"
    print(f"the black box costs {wall}, {median(virtual):+.1f} % of a virtual run (medians of {given.rounds})")


def _wall(given: argparse.Namespace, words: list[str]) -> dict[str, float]:
    """Of each process of a run in wall time its share of a core in %."""
    more = ["--no-fifo"] if given.no_fifo else []
    _, shares, _ = shares_of([given.application, "--json", *more, *words])
    return shares


def _virtual(given: argparse.Namespace, words: list[str]) -> float:
    """Seconds of processor that a run in virtual time takes in all."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    ran = subprocess.run(
        [*onika_words(), "run", given.application, "--virtual", "--json", *words],
        capture_output=True,
        check=True,
        env=os.environ,
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if json.loads(ran.stdout.splitlines()[-1])["state"] != "completed":
        raise SystemExit("expected a run that completes")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


if __name__ == "__main__":
    main()
