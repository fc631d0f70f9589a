"""Writes the synthetic logs of tests/data/assemblies: the shipped assembly, put in by nobody.

Usage: python tests/kit/study/assemblies.py FOLDER. Times are drawn about those of table 2 of the source.
"""

import random
import sys
from pathlib import Path

from kit.study.log_text import ICONS, LogText, with_records

ICONS_OF_ASSEMBLY = 41
SUBJECTS = {"steady": (1, 6.1, 0), "quick": (2, 3.0, 0), "hesitant": (3, 9.5, 0), "mended": (4, 6.5, 1)}
"""Seed, mean selection time in seconds, and attempts that fail."""


def log(seed: int, selection_s: float, failures: int) -> str:
    """A log of an assembly."""
    chance = random.Random(seed)
    text = LogText(1_790_000_000.0 + 86_400.0 * seed).start().new(chance.uniform(3, 8))
    for number in range(ICONS_OF_ASSEMBLY):
        icon = ICONS[number % len(ICONS)]
        text.select(0.5 + chance.expovariate(1 / (selection_s - 0.5)), icon).insert(chance.uniform(1.5, 4), icon)
    for _ in range(failures):
        text.run(chance.uniform(5, 20), chance.uniform(3, 15), "grip closes on nothing")
        text.select(chance.uniform(2, 9)).insert(2.0)
    return with_records(text.run(chance.uniform(10, 60), 23.32).quit().text, f"5e5510{seed:02}")


if __name__ == "__main__":
    for name, (seed, selection_s, failures) in SUBJECTS.items():
        path = Path(sys.argv[1]) / f"synthetic_{name}.log"
        path.write_text(log(seed, selection_s, failures), encoding="utf-8")
