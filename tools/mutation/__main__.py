"""Try the safety core: every mutant of it has to be noticed by a test, and every branch carried out (R-X24).

Usage: python -m mutation [--jobs N] [--every N] [FILE ...]. With `--every 10` a tenth of the mutants is tried. Prints
what is wrong, and ends with 1 if anything is.
"""

import argparse
import sys
from collections.abc import Callable, Sequence
from functools import partial
from importlib import import_module
from pathlib import Path

from mutation import child, safety_core
from mutation.findings import Findings
from mutation.mutant import Mutant
from mutation.trial import trial

_ROOT = Path(__file__).resolve().parents[2]
_HEAVY = ("hypothesis", "mujoco", "msgspec", "numpy", "ruckig", "starlette")
"""What is loaded once for all; it takes long, and is not ours."""
_WALL_S, _CPU_S = 3600.0, 1800


def main(words: Sequence[str]) -> int:
    """Try the files that are asked for, or all."""
    core = safety_core.files(_ROOT)
    asked = _parser().parse_args(words)
    paths = asked.files or list(core)
    for name in _HEAVY:
        import_module(name)
    trials: list[Findings] = []
    works = [_work(core[path], asked.every) for path in paths]
    for tried in child.answers(works, asked.jobs, _WALL_S, _CPU_S):
        if tried is None:
            print("a trial has ended without a word", file=sys.stderr)
            return 1
        trials.append(tried)
        print(f"{tried.path}: {tried.mutants} mutants, {len(tried.survivors)} stay, {tried.seconds:.0f} s", flush=True)
    wrong = list(safety_core.complaints(trials, safety_core.reasons(), core, is_whole=asked.every == 1))
    print(f"{sum(tried.mutants for tried in trials)} mutants of {len(trials)} files; {len(wrong)} things are wrong")
    print(*wrong, sep="\n")
    return int(bool(wrong))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="mutation", description="mutants of the safety core")
    parser.add_argument("--jobs", type=int, default=2, help="how many files are tried at once")
    parser.add_argument("--every", type=int, default=1, metavar="N", help="try every Nth mutant only")
    parser.add_argument("files", nargs="*", help="files of the core; all where none is named")
    return parser


def _work(core_file: safety_core.CoreFile, every: int) -> Callable[[], Findings]:
    def choice(mutants: Sequence[Mutant]) -> list[Mutant]:
        return list(mutants[::every])

    return partial(trial, _ROOT, core_file, choice)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
