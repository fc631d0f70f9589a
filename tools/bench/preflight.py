"""How long it takes to look at a long program before it runs, as it is and for another robot (X02).

    .venv/bin/python tools/bench/preflight.py [ACTIONS]

The program moves joints and the hand in turn; the last target of each kind is out of reach, so that all are looked at.
Measured are reading and judging here, and checking in a runtime of its own process, as `onika run` does both.
"""

import sys
import tempfile
from pathlib import Path
from time import perf_counter

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests"))

from kit.labs.laboratory import Laboratory, job, joints, target
from onika.desk.plan.preparation import prepare_run
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.model.redirect import Redirect
from onika.store.site import open_site
from onika.wire import request

MOST_S = 2.0
ABOVE = (0.181442, -0.625356, 2.700589, 0.0, 1.06636, 1.752238)


def program(path: Path, actions: int) -> Path:
    """An application of so many actions, two of them with targets that nobody reaches."""
    steps = []
    for k in range(actions // 2):
        is_last = k == actions // 2 - 1
        away = 1.9 if is_last else 0.6 + 0.1 * (k % 10) / 10
        steps += [job("jmoveC", "Joint job"), joints(f"j{k}", *((9.0,) if is_last else ABOVE[:1]), *ABOVE[1:])]
        pose = f"0 0 -1 0 1 0 {away} 0.2 -0.2"
        steps += [job("cmoveC", "Cartesian job"), target(f"c{k}", "Cartesian object", pose, "1.0")]
    return Laboratory(path).application("long", steps)


def measure(path: Path, *redirects: Redirect) -> float:
    """Seconds for one look, the quickest of three, and what was found, on a line."""
    site = open_site([], {}, None)
    times = []
    with LaunchedRuntime(("rt0",), is_virtual=True) as runtime:
        for _ in range(3):
            began = perf_counter()
            one = prepare_run(str(path), site, redirects)
            assert one.plan is not None
            judged = perf_counter()
            answer = runtime.ask(request.Prepare(one.plan, one.targets))
            times.append((perf_counter() - began, judged - began))
    assert isinstance(answer, request.Prepared)
    whole, here = min(times)
    said = ", ".join(map(str, redirects)) or "as it is"
    found = f"{len(answer.faults)} faults, {len(answer.resolved)} targets re-resolved"
    print(f"{said}: {here:.2f} s judged + {whole - here:.2f} s checked = {whole:.2f} s; {found}")
    return whole


def main(words: list[str]) -> int:
    """Measure; 1 where it takes too long."""
    actions = int(words[0]) if words else 1000
    with tempfile.TemporaryDirectory() as folder:
        path = program(Path(folder), actions)
        worst = max(
            measure(path), measure(path, Redirect("puma", "puma_kin")), measure(path, Redirect("puma", "scara"))
        )
    print(f"{actions} actions: {worst:.2f} s at most (limit for 1,000: {MOST_S:g} s)")
    return 0 if worst < MOST_S * max(actions / 1000, 1.0) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
