"""How fast assemblies were built, from their logs, beside the figures of the source (requirement H06).

    .venv/bin/python tools/bench/learn.py [FOLDER|FILE …]

Without a word it reads tests/data/assemblies. Logs whose names begin with `synthetic` were written by a program: they
show that logs are read rightly, and nothing of people. Give it the folder `logs` of a study to see what people did.
"""

import math
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import fmean

from onika.study import log as logs
from onika.study.measures import TaskMeasures, measure
from onika.study.session import task_of
from onika.study.source_tables import BUILDING_S, MEAN_SELECTION_S

KEPT = Path(__file__).parents[2] / "tests" / "data" / "assemblies"
ENDINGS = (".log", ".raw")


@dataclass(frozen=True, slots=True)
class Assembly:
    """A log: its name, what it comes to, and how many lines of it are wrong."""

    name: str
    measures: TaskMeasures
    wrong: int

    @property
    def is_synthetic(self) -> bool:
        """Whether a program has written it."""
        return self.name.startswith("synthetic")


def main(words: Sequence[str]) -> int:
    """Print the table; 1 where there is no log."""
    assemblies = [*read(map(Path, words or [str(KEPT)]))]
    if not assemblies:
        print("expected logs, found none")
        return 1
    for line in lines(assemblies):
        print(line)
    return 0


def read(places: Iterator[Path]) -> Iterator[Assembly]:
    """What logs come to, those in folders in the order of their names."""
    for place in places:
        paths = sorted(path for path in place.rglob("*") if path.suffix in ENDINGS) if place.is_dir() else [place]
        for path in paths:
            log, faults = logs.read(path.read_text(encoding="utf-8", errors="replace"), path.name)
            measures, _ = measure(task_of(log)[0])
            yield Assembly(path.stem, measures, sum(not fault.is_note for fault in faults))


def lines(assemblies: Sequence[Assembly]) -> Iterator[str]:
    """A row for each, then both means beside the source's."""
    yield f"{'log':28} {'selections':>10} {'mean':>7} {'spread':>7} {'building':>9} {'attempts':>8}"
    for assembly in assemblies:
        of = assembly.measures
        remark = f"  {assembly.wrong} lines are wrong: times hold up to there" if assembly.wrong else ""
        building = shown(math.nan if assembly.wrong else of.building_s, 0)
        yield (
            f"{assembly.name:28} {of.selections:10} {shown(of.mean_selection_s)} {shown(of.selection_spread_s)}"
            f" {building:>9} {of.attempts:8}{remark}"
        )
    yield ""
    for kind, members in (
        ("people", [assembly for assembly in assemblies if not assembly.is_synthetic]),
        ("synthetic", [assembly for assembly in assemblies if assembly.is_synthetic]),
    ):
        mean = shown(mean_selection_s(members))
        yield f"{kind + ', mean selection':28} {mean:>18} s   (source: {MEAN_SELECTION_S} s)"
        yield f"{kind + ', building':28} {span(members):>18} s   (source: {BUILDING_S[0]:g} to {BUILDING_S[1]:g} s)"


def mean_selection_s(assemblies: Sequence[Assembly]) -> float:
    """Mean of the means, as in the source."""
    means = [assembly.measures.mean_selection_s for assembly in assemblies]
    return fmean(means) if means else math.nan


def span(assemblies: Sequence[Assembly]) -> str:
    """The least and the greatest time of building, of logs that are whole."""
    times = [assembly.measures.building_s for assembly in assemblies if not assembly.wrong]
    times = [seconds for seconds in times if math.isfinite(seconds)]
    return f"{min(times):.0f} to {max(times):.0f}" if times else "–"


def shown(seconds: float, digits: int = 2) -> str:
    """Seconds in a column, a dash for none."""
    return f"{seconds:7.{digits}f}" if math.isfinite(seconds) else f"{'–':>7}"


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
