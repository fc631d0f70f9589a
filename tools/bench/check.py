"""Compares what Onika's own code costs with what was kept last; ends with 1 where something costs 110 % of it or more.

Usage: python tools/bench/check.py [--keep] [--ratios [--rounds N]]. What is counted are instructions of Python and
calls into C, which are the same however busy the machine is; a count belongs to one version of Python, and of another
that nothing was kept for is only said. `--ratios` measures beside the peers as well (`make bench-check`), where these
are installed. `--keep` keeps what was measured, in tools/bench/kept.json: with the change that explains it.
"""

import argparse
import json
import platform
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests"))

from beside.contest import hold
from beside.contestant import Absent
from beside.contests import CONTESTS
from beside.counted import counts

KEPT = Path(__file__).parent / "kept.json"
ALARM = 1.10
COMPARED = ("loop", "sweep", "application")
"""The contests whose ratios are kept: those in which nothing waits."""

Figures = dict[str, float]


def ratios(rounds: int) -> Figures:
    """Ours to each peer's that is there, medians of interleaved rounds."""
    figures = {}
    for contest in (contest for contest in CONTESTS if contest.key in COMPARED):
        outcome = hold(contest, rounds)
        for peer in outcome.peers:
            if not peer.absent:
                figures[f"{contest.key} / {peer.entrant.name}"] = round(outcome.ratio(peer), 3)
    return figures


def compared(figures: Figures, kept: Figures) -> list[str]:
    """A line for each figure; those to be looked at begin with ABOVE."""
    lines = []
    for name, figure in figures.items():
        if name not in kept:
            lines.append(f"new    {name}: {figure:g}")
            continue
        share = figure / kept[name]
        lines.append(f"{'ABOVE' if share >= ALARM else 'ok':<6} {name}: {figure:g}, kept {kept[name]:g}, {share:.0%}")
    return lines


def main(words: list[str]) -> int:
    """The command."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--keep", action="store_true")
    parser.add_argument("--ratios", action="store_true")
    parser.add_argument("--rounds", type=int, default=7)
    given = parser.parse_args(words)
    version = "counts of Python " + ".".join(platform.python_version_tuple()[:2])
    measured = {version: counts()}
    if given.ratios:
        try:
            measured["ratios"] = ratios(given.rounds)
        except Absent as why:
            print(f"no ratios: {why}")
    kept: dict[str, Figures] = json.loads(KEPT.read_text(encoding="utf-8")) if KEPT.exists() else {}
    lines = [line for kind, figures in measured.items() for line in compared(figures, kept.get(kind, {}))]
    print("\n".join(lines))
    if given.keep:
        KEPT.write_text(json.dumps(kept | measured, indent=1, sort_keys=True) + "\n", encoding="utf-8")
        return 0
    return 1 if any(line.startswith("ABOVE") for line in lines) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
