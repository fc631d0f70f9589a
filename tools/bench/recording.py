"""What recording costs a wall run: share of a core, missed cycles, values that were not seen.

Usage: python tools/bench/recording.py [--rounds N] [--application NAME] [--no-fifo]. Runs with and without a recording
take turns, so that the machine's other load falls on both alike. Shares are those of the run itself: what processes
use until they are up is told apart. The last line is the cost: all that recorded runs use more than others, the median
of the rounds.
"""

import argparse
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from statistics import median
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "src"))

from onika.record.reader import Reader

_SETTLED_S = 1.0
"""So long after the last process has come up, everything runs."""


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=2)
    parser.add_argument("--application", default="assemble")
    parser.add_argument("--no-fifo", action="store_true")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        costs = []
        for number in range(given.rounds):
            plain, recorded = (_shares(given, path) for path in (None, Path(folder) / f"{number}.mcap"))
            costs.append(recorded - plain)
            print(f"{'':8}  recording costs {costs[-1]:.1f} % of a core", flush=True)
    print(f"recording costs {median(costs):.1f} % of a core")


def _shares(given: argparse.Namespace, path: Path | None) -> float:
    """Print how a run went; what share of a core all its processes used."""
    words = [given.application, "--json"]
    words += [*(("--no-fifo",) if given.no_fifo else ()), *(("--record", str(path)) if path else ())]
    result, shares, before = shares_of(words)
    cycles, missed = (sum(one[key] for one in result["tasks"]) for key in ("cycles", "missed"))
    total = sum(shares.values())
    parts = "  ".join(f"{name} {share:.1f} %" for name, share in sorted(shares.items()))
    text = f"{'recorded' if path else 'plain':8}  {missed} of {cycles} cycles missed  {parts}  in all {total:.1f} %"
    if path:
        reader, lasted = Reader(path), result["runtime_s"]
        count, size = sum(map(reader.count, reader.channels)), path.stat().st_size
        text += (
            f"  {count / lasted:.0f} values/s, {size / lasted / 1e3:.0f} kB/s, {reader.notes['end']['missed']} unseen"
        )
        text += f", {before.get('scribe_process', 0.0):.2f} s to come up"
    print(text, flush=True)
    return total


def onika_words() -> list[str]:
    """The words that start the command line of this tree."""
    return [sys.executable, "-c", "from onika.cli import main; raise SystemExit(main())"]


def shares_of(words: list[str]) -> tuple[dict[str, Any], dict[str, float], dict[str, float]]:
    """The result of a run with `--json`, what share of a core in % each of its processes used, and the seconds each
    had used before everything ran."""
    program = subprocess.Popen([*onika_words(), "run", *words], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    seen: list[tuple[float, dict[str, float]]] = []
    while program.poll() is None:
        seen.append((time.monotonic(), _used(program.pid)))
        time.sleep(0.1)
    output, _ = program.communicate()
    shares, before = _between(seen)
    return json.loads(output.splitlines()[-1]), shares, before


def _between(seen: list[tuple[float, dict[str, float]]]) -> tuple[dict[str, float], dict[str, float]]:
    """Of each process its share of a core in % while everything runs, and the seconds it had used before."""
    most = max(len(used) for _, used in seen)
    full = [(at, used) for at, used in seen if len(used) == most]
    some = [one for one in full if one[0] >= full[0][0] + _SETTLED_S]
    (begin, before), (end, after) = some[0], some[-1]
    return {name: 100 * (after[name] - before[name]) / (end - begin) for name in after}, before


def _used(parent: int) -> dict[str, float]:
    """Seconds of processor that each process of the runtime has used, by its name."""
    found: dict[str, float] = {}
    for status in Path("/proc").glob("[0-9]*/stat"):
        try:
            words = (status.parent / "cmdline").read_text().replace("\0", " ").split()
            fields = status.read_text().rpartition(") ")[2].split()
            used = (status.parent / "schedstat").read_text()
        except OSError:
            continue
        module = next((one for one in words if one.startswith("onika.host")), "")
        if module and _descends(int(fields[1]), parent):
            name = module.removeprefix("onika.host").lstrip(".") or "runtime"
            found[name] = int(used.split()[0]) * 1e-9
    return found


def _descends(pid: int, ancestor: int) -> bool:
    while pid > 1:
        if pid == ancestor:
            return True
        try:
            pid = int(Path(f"/proc/{pid}/stat").read_text().rpartition(") ")[2].split()[1])
        except OSError:
            return False
    return False


if __name__ == "__main__":
    main()
