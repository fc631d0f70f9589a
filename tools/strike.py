"""Deals out blows at random: kills and freezes every kind of process, and prints what came of it.

    python tools/strike.py --seed 7 --count 30 --stage recorded --kind UNIT --only freezes

Ends with 1 where anything stayed behind, was late, or does not read (requirements E10, F01, X05, X12).
"""

import argparse
import signal
import sys
import tempfile
from collections import defaultdict
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
from kit.faults.blows import FREEZES, KINDS, Aftermath, Kind, Stage, blows, strike


def campaign(stage: Stage, kinds: Sequence[Kind], count: int, is_freeze: bool, seed: int, is_loud: bool) -> int:
    """Deal out blows and print what came of them; how many were not as they have to be."""
    signals = FREEZES if is_freeze else (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)
    bad, times = 0, defaultdict(list)
    for kind in kinds:
        for blow in blows(stage, kind, count, signals, seed):
            with tempfile.TemporaryDirectory() as folder:
                aftermath = strike(stage, blow, Path(folder))
            faults = aftermath.faults()
            bad += bool(faults)
            times[kind].append(aftermath)
            if faults or is_loud:
                print(f"{stage} {blow}: hit={aftermath.has_hit} code={aftermath.code} "
                      f"interrupt={aftermath.had_interrupt} ended={_s(aftermath.ended_s)} told={_s(aftermath.told_s)} "
                      f"{faults}", flush=True)  # fmt: skip
                if faults:
                    print("    " + "\n    ".join(line[:2000] for line in aftermath.output[-6:]), flush=True)
    for kind, group in times.items():
        _summary(stage, kind, is_freeze, group)
    return bad


def _summary(stage: Stage, kind: Kind, is_freeze: bool, group: Sequence[Aftermath]) -> None:
    ended = [aftermath.ended_s for aftermath in group if aftermath.ended_s is not None]
    told = [aftermath.told_s for aftermath in group if aftermath.told_s is not None and not aftermath.had_interrupt]
    silence = [aftermath.silence_ns / 1e6 for aftermath in group if aftermath.silence_ns is not None]
    print(
        f"{stage:10} {kind.name:10} {'freezes' if is_freeze else 'kills':8} {len(group):3} hit "
        f"{sum(aftermath.has_hit for aftermath in group):3} bad {sum(bool(a.faults()) for a in group):3}  "
        f"ended <= {max(ended, default=0):.2f} s  told <= {max(told, default=0):.2f} s  "
        f"drive <= {max(silence, default=0):.0f} ms",
        flush=True,
    )


def _s(seconds: float | None) -> str:
    return "-" if seconds is None else f"{seconds:.2f}"


def main(words: Sequence[str]) -> int:
    """The program."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--count", type=int, default=30)
    parser.add_argument("--stage", action="append", choices=list(Stage), default=[])
    parser.add_argument("--kind", action="append", choices=[kind.name for kind in Kind], default=[])
    parser.add_argument("--only", choices=("kills", "freezes"))
    parser.add_argument("--loud", action="store_true")
    given = parser.parse_args(words)
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background job and all below it ignore it
    bad = 0
    for name in given.stage or list(Stage):
        stage = Stage(name)
        kinds = [kind for kind in KINDS[stage] if not given.kind or kind.name in given.kind]
        for is_freeze in (False, True):
            if given.only is None or (given.only == "freezes") == is_freeze:
                bad += campaign(stage, kinds, given.count, is_freeze, given.seed, given.loud)
    return int(bad > 0)


if __name__ == "__main__":
    with suppress(KeyboardInterrupt):
        sys.exit(main(sys.argv[1:]))
