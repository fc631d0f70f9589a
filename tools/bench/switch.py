"""Switching: from a trigger's finish to the first cycle of the next job's tasks, in wall time.

The assembly is run, and after it a program of grips that only switches; both with SCHED_FIFO and without. Times are the
runtime's own: from the instant of the cycle that finished to the instant of the next job's first cycle.
"""

import argparse
import json
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

from onika.files import appl
from onika.model.application import AppFlow, Application, Icon
from onika.store.site import open_site

ONIKA = str(Path(sys.executable).with_name("onika"))


def grips(count: int, folder: Path) -> Path:
    """A program that opens and closes the hand."""
    site = open_site([], {}, None)
    syntax, _ = site.syntax()
    assert syntax is not None
    icons = []
    for name in ("opengripC", "closegripC"):
        onikon, _ = site.onikon(name, syntax)
        assert onikon is not None
        icons.append(Icon(onikon))
    path = folder / "appl" / "grips.appl"
    path.parent.mkdir(parents=True)
    path.write_text(appl.write(Application("grips", False, (AppFlow(tuple(icons * (count // 2))),))))
    return path


def switches(application: str, *options: str) -> tuple[list[float], int]:
    """Microseconds of every switch of a run, and the cycles it missed."""
    ran = subprocess.run([ONIKA, "run", application, "--json", *options], capture_output=True, text=True, check=False)
    result = json.loads(ran.stdout.splitlines()[-1])
    assert result["state"] == "completed", result["cause"]
    return result["switches_us"], sum(result["missed"].values())


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--grips", type=int, default=60)
    given = parser.parse_args()
    print(f"{'program':<10}{'scheduling':<14}{'switches':>9}{'median us':>11}{'p90 us':>9}{'max us':>9}{'missed':>8}")
    with tempfile.TemporaryDirectory() as folder:
        for application in ("assemble", str(grips(given.grips, Path(folder)))):
            for options in ((), ("--no-fifo",)):
                found, missed = switches(application, *options)
                tenths = statistics.quantiles(found, n=10)
                name, how = Path(application).stem, "time-sharing" if options else "FIFO"
                numbers = f"{statistics.median(found):>11.0f}{tenths[-1]:>9.0f}{max(found):>9.0f}{missed:>8}"
                print(f"{name:<10}{how:<14}{len(found):>9}{numbers}")


if __name__ == "__main__":
    main()
