"""Cameras: cycles that an arm of 500 Hz misses in wall time, with two cameras of 10 Hz beside it and without.

Usage: python tools/bench/cameras.py [--seconds S] [--rounds N]. The gantry moves; a task reads the camera at its wrist
and another one, of a flow of its own, that above it. Runs with and without cameras alternate, so that they share the
machine's moods.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

PICTURE = (
    "PICT        " + "8" * 32 + "\n" + ("PICT        8" + "7" * 30 + "8\n") * 30 + "PICT        " + "8" * 32 + "\n"
)
TASK = "MODULE      camera\nDESC        {name}\nINCONST     none\nOUTCONST    H W FOCAL\nINVAR       none\n"
TASK += "OUTVAR      IMG IMG_T\nTASKTYPE    periodic\nFREQ        10\n\nLOCAL\nDEVICE      bench:{device}\n\nEOF\n"
PLACED = "RMODFILE    {name}\nCOORDS      {x} 80\nINLEFT      yes\nFREQ        {hz}\nRTPU        unknown\n\n"


def main() -> None:
    """Print what was missed."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--rounds", type=int, default=3)
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        base = Path(folder)
        write(base, given.seconds)
        for _ in range(given.rounds):
            for name in ("plain", "filmed"):
                print(name, missed(base, name))


def missed(base: Path, name: str) -> dict[str, object]:
    """One run: the cycles that the arm missed, and what ended it."""
    command = [sys.executable, "-c", "from onika.cli import main; raise SystemExit(main())", "run"]
    words = [str(base / "appl" / f"{name}.appl"), "--local", str(base), "--json"]
    ran = subprocess.run([*command, *words], capture_output=True, text=True, check=False)
    result = json.loads(ran.stdout.splitlines()[-1])
    arm = {task: count for task, count in result["missed"].items() if task.endswith("/gantry")}
    return {"state": result["state"], "missed": arm, "seconds": round(result.get("runtime_s", 0.0), 1)}


def write(base: Path, seconds: float) -> None:
    """Tasks, jobs and applications of the measurement."""
    for part in ("module", "conf", "dict", "appl"):
        (base / part).mkdir()
    for name, device in (("eye_wrist", "wrist_bay"), ("eye_above", "above")):
        (base / "module" / f"{name}.rmod").write_text(TASK.format(name=name, device=device))
    arm = [("gantry", 500), ("jtraj", 250)]
    conf(base, "plainC", arm)
    conf(base, "filmedC", [arm[0], ("eye_wrist", 10), arm[1]])
    conf(base, "lookC", [("eye_above", 10), ("pause", 20)])
    away = target("Joint object", "0.3 0.2 0.1 0", str(seconds))
    wait = target("Pause object", str(seconds))
    application(base, "plain", [("plainC", "Joint job", "away", away)])
    flows = [("filmedC", "Joint job", "away", away), ("lookC", "Pause job", "wait", wait)]
    application(base, "filmed", flows)


def conf(base: Path, name: str, tasks: list[tuple[str, int]]) -> None:
    """A configuration of these tasks at these rates."""
    rows = [PLACED.format(name=task, x=120 + 200 * k, hz=hz) for k, (task, hz) in enumerate(tasks)]
    (base / "conf" / f"{name}.conf").write_text("VERSION     1.3\n\n" + "".join(rows) + "EOF\n")


def target(kind: str, *values: str) -> str:
    """The lines of a target."""
    inputs = "".join(f"UI          {value}\n" for value in values)
    return f"ONIKON      {kind}\nDESC        of the measurement\n{inputs}{PICTURE}"


def application(base: Path, name: str, flows: list[tuple[str, str, str, str]]) -> None:
    """Parallel flows of one job with its target each."""
    text = f"VERSION     1.3\n\nAPPLTYPE    {'parallel' if len(flows) > 1 else 'conditional'}\n"
    for job, kind, goal, lines in flows:
        head = f"ONIKON      {kind}\nDESC        of the measurement\nUI          none\n{PICTURE}"
        (base / "dict" / f"{job}.onk").write_text(f"VERSION     1.3\n\n{head}\nEOF\n")
        (base / "dict" / f"{goal}.onk").write_text(f"VERSION     1.3\n\n{lines}\nEOF\n")
        text += f"\nFLOW\n\nROUTINE     {job}\nMARKER      no\n{head}\n"
        text += f"ROUTINE     {goal}\nMARKER      no\n{lines}\nENDFLOW\n"
    (base / "appl" / f"{name}.appl").write_text(text + "\nEOF\n")


if __name__ == "__main__":
    main()
