"""What recording costs a wall run: share of a core, missed cycles, values that were not seen.

Usage: python tools/bench/recording.py [--rounds N] [--application NAME] [--no-fifo]. Runs with and without a recording
take turns, so that the machine's other load falls on both alike.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "src"))

from onika.record.reader import Reader

_TICK_S = 1.0 / os.sysconf("SC_CLK_TCK")


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=2)
    parser.add_argument("--application", default="assemble")
    parser.add_argument("--no-fifo", action="store_true")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for number in range(given.rounds):
            for path in (None, Path(folder) / f"{number}.mcap"):
                print(_line(given, path), flush=True)


def _line(given: argparse.Namespace, path: Path | None) -> str:
    words = [sys.executable, "-c", "from onika.cli import main; raise SystemExit(main())", "run", given.application]
    words += ["--json", *(("--no-fifo",) if given.no_fifo else ()), *(("--record", str(path)) if path else ())]
    program = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    used: dict[str, float] = {}
    while program.poll() is None:
        for name, seconds in _used(program.pid).items():
            used[name] = max(used.get(name, 0.0), seconds)
        time.sleep(0.2)
    said, _ = program.communicate()
    result = json.loads(said.splitlines()[-1])
    lasted = result["runtime_s"]
    cycles = sum(one["cycles"] for one in result["tasks"])
    missed = sum(one["missed"] for one in result["tasks"])
    shares = "  ".join(f"{name} {100 * seconds / lasted:.1f} %" for name, seconds in sorted(used.items()))
    text = f"{'recorded' if path else 'plain':8}  {lasted:.2f} s  {missed} of {cycles} cycles missed  {shares}"
    if path:
        reader = Reader(path)
        count, size = sum(map(reader.count, reader.channels)), path.stat().st_size
        text += (
            f"  {count / lasted:.0f} values/s, {size / lasted / 1e3:.0f} kB/s, {reader.notes['end']['missed']} unseen"
        )
    return text


def _used(parent: int) -> dict[str, float]:
    """Seconds of processor that each process of the runtime has used, by its name."""
    found: dict[str, float] = {}
    for status in Path("/proc").glob("[0-9]*/stat"):
        try:
            words = (status.parent / "cmdline").read_text().split("\0")
            fields = status.read_text().rpartition(") ")[2].split()
        except OSError:
            continue
        module = next((one for one in words if one.startswith("onika.host")), "")
        if module and _descends(int(fields[1]), parent):
            name = module.removeprefix("onika.host").lstrip(".") or "runtime"
            found[name] = (int(fields[11]) + int(fields[12])) * _TICK_S
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
