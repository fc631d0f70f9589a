"""Meetings: how far apart the first cycles of flows are that go on together at a tag, in wall time.

Every flow has three light tasks of 500 Hz on one processing unit; its trigger takes some cycles, now more and now
less, then the flow waits at the tag and goes through its loop again. The skew of a meeting lies between the first cycle
of the first flow and that of the last one, as the runtime tells it. Asked for is a 99th percentile below one period
with SCHED_FIFO.
"""

import argparse
import json
import os
import statistics
import subprocess
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

from onika.files import appl
from onika.model.application import AppFlow, Application, Icon
from onika.store.site import open_site

ONIKA = str(Path(sys.executable).with_name("onika"))
PERIOD_US = 2000.0

MODULES = {
    "dawdle": '''
from onika.module import Module, OutVar, finish

class Dawdle(Module):
    """Ends after some cycles, now more and now less."""
    trigger = True
    N = OutVar("double", "-", "cycles")
    def on(self, inputs):
        self._left = self.random.randint(2, 9)
    def cycle(self):
        self.N += 1.0
        self._left -= 1
        return None if self._left > 0 else finish()
''',
    "half": '''
from onika.module import InVar, Module, OutVar

class Half(Module):
    """Half of it."""
    N = InVar("double", "-", "cycles")
    HALF = OutVar("double", "-", "half of them")
    def cycle(self):
        self.HALF = 0.5 * self.N
''',
    "mean": '''
from onika.module import InVar, Module, OutVar

class Mean(Module):
    """Its mean."""
    HALF = InVar("double", "-", "half of the cycles")
    MEAN = OutVar("double", "-", "their mean over time")
    def on(self, inputs):
        self._sum, self._count = 0.0, 0
    def cycle(self):
        self._sum, self._count = self._sum + self.HALF, self._count + 1
        self.MEAN = self._sum / self._count
''',
}
PORTS = {"dawdle": ("none", "N"), "half": ("N", "HALF"), "mean": ("HALF", "MEAN")}


def write_site(folder: Path) -> None:
    """A base directory with the tasks and a job of all three."""
    for part in ("module", "conf", "appl"):
        (folder / part).mkdir(parents=True)
    for name, source in MODULES.items():
        (folder / "module" / f"{name}.py").write_text(source)
        read, written = PORTS[name]
        lines = [f"MODULE      {name}", f"DESC        {name}", "INCONST     none", "OUTCONST    none"]
        lines += [f"INVAR       {read}", f"OUTVAR      {written}", "TASKTYPE    periodic", "FREQ        500", ""]
        (folder / "module" / f"{name}.rmod").write_text("\n".join([*lines, "EOF", ""]))
    placed = [
        f"RMODFILE    {name}\nCOORDS      {x} 80\nINLEFT      yes\nFREQ        500\nRTPU        unknown\n"
        for x, name in zip((100, 300, 500), MODULES, strict=True)
    ]
    (folder / "conf" / "lightC.conf").write_text("\n".join(["VERSION     1.3\n", *placed, "EOF\n"]))


def meetings(flows: int, times: int, folder: Path) -> Path:
    """An application of so many flows that meet so many times."""
    write_site(folder)
    site = open_site([], {}, None)
    syntax, _ = site.syntax()
    assert syntax is not None
    light, count, number = (site.onikon(name, syntax)[0] for name in ("opengripC", "repeatC", "ten"))
    assert light is not None
    assert count is not None
    assert number is not None
    light = replace(light, name="lightC", description="three light tasks")
    number = replace(number, name="often", description="often", values=((times,),))
    steps = (
        Icon(light, synch_tag="meet", while_tag="more"),
        Icon(count, while_tag="more", while_test=True),
        Icon(number),
    )
    path = folder / "appl" / "meetings.appl"
    path.write_text(appl.write(Application("meetings", True, (AppFlow(steps),) * flows)))
    return path


def skews(application: Path, folder: Path, *options: str) -> tuple[list[float], int]:
    """Microseconds between the first and the last flow at every meeting, and the cycles that were missed."""
    command = [ONIKA, "run", str(application), "--json", "--local", str(folder), *options]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    assert ran.stdout, ran.stderr
    result = json.loads(ran.stdout.splitlines()[-1])
    assert result["state"] == "completed", result.get("cause") or result["faults"]
    return result["skews_us"], sum(result["missed"].values())


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--flows", type=int, default=16)
    parser.add_argument("--times", type=int, default=300)
    given = parser.parse_args()
    print(f"{given.flows} flows, {given.times} meetings; load {os.getloadavg()[0]:.1f}; a period is {PERIOD_US:.0f} us")
    print(f"{'scheduling':<14}{'meetings':>9}{'median us':>11}{'p99 us':>9}{'max us':>9}{'missed':>8}")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        application = meetings(given.flows, given.times, folder)
        for options in ((), ("--no-fifo",)):
            found, missed = skews(application, folder, *options)
            percentile = statistics.quantiles(found, n=100, method="inclusive")[-1]
            how = "time-sharing" if options else "FIFO"
            numbers = f"{statistics.median(found):>11.0f}{percentile:>9.0f}{max(found):>9.0f}{missed:>8}"
            print(f"{how:<14}{len(found):>9}{numbers}{'' if percentile < PERIOD_US else '  a period or more'}")


if __name__ == "__main__":
    main()
