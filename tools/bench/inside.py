"""What three browsers that look into a run in wall time cost it: processor time of its processes, and missed cycles.

Usage: python tools/bench/inside.py [--seconds S] [--rounds N] [--no-fifo]. The browsers are pages of a real Chromium.
One shows the configuration of the running icon live on the canvas, one the variables with a plot, one the table of the
tasks. Stretches of the same run with and without them take turns. Processor time is counted, not time that passes, so
that what else the machine does hardly matters; the browsers' own is none of it.
"""

import argparse
import os
import re
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from statistics import median

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests"))

from browse.chromium import FLAGS, path
from browse.guest import Guest
from browse.program import program, said
from playwright.sync_api import Page, sync_playwright

from kit.labs.laboratory import Laboratory, job
from kit.process.process_tree import descendants, runtime_of
from onika.wire import act

TASKS, HZ = 10, 100
_TICK = os.sysconf("SC_CLK_TCK")

SOURCE = """
import math
from onika.module import Module, OutVar

class Waves(Module):
    trigger = {is_trigger}
    {name} = OutVar("double[6]", "-", "a wave")

    def cycle(self):
        for joint in range(6):
            self.{name}[joint] = math.sin(self.now + joint)
"""


def laboratory(folder: Path) -> None:
    """An application of one action that never ends, of ten tasks."""
    lab = Laboratory(folder)
    for number in range(TASKS):
        source = SOURCE.format(is_trigger=number == 0, name=f"WAVE{number}")
        lab.module(f"waves{number}", source)
        lab.plain_task(f"waves{number}", writes=f"WAVE{number}", hz=HZ)
    lab.configuration("wavesC", *(f"waves{number} {HZ}" for number in range(TASKS)))
    lab.application("waves", [job("wavesC")])


def live(page: Page) -> None:
    """The configuration of the icon that runs, on the canvas."""
    _to(page, "Applications")
    icon = page.get_by_role("region", name="Workspace").get_by_role("option", name=re.compile("; action ")).first
    icon.click(modifiers=["Shift"])
    page.locator("[data-task=waves0]").wait_for()


def variables(page: Page) -> None:
    """The table of the variables, and a plot of one."""
    _inside(page)
    page.get_by_role("tab", name=re.compile("^Variables")).click()
    page.get_by_role("grid", name="State variables").get_by_role("row").filter(has_text="WAVE0").click()
    page.get_by_role("group", name="Plots").locator("canvas").first.wait_for()


def tasks(page: Page) -> None:
    """The table of the tasks."""
    _inside(page)
    page.get_by_role("grid", name="Tasks and their figures").get_by_role("row").filter(has_text="waves0").wait_for()


def _inside(page: Page) -> None:
    _to(page, "Applications")
    page.get_by_role("region", name="Run", exact=True).get_by_role("button", name="Look inside").first.click()


def _to(page: Page, level: str) -> None:
    page.get_by_role("button", name=level, exact=True).click()


VIEWS: tuple[Callable[[Page], None], ...] = (live, variables, tasks)


def main() -> None:
    """Print the shares of a core with and without, and their difference."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--no-fifo", action="store_true")
    given = parser.parse_args()
    browser_path = path()
    if browser_path is None:
        raise SystemExit("there is no Chromium on the PATH")
    more = ("--no-fifo",) if given.no_fifo else ()
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        laboratory(Path(folder))
        browser = playwright.chromium.launch(executable_path=browser_path, args=FLAGS)
        with program("--base", folder, *more, "waves") as (address, pid, later):
            guest = Guest(address)
            pages = [browser.new_context(viewport={"width": 1440, "height": 900}).new_page() for _ in VIEWS]
            for page in pages:
                page.goto(later())
            guest.until(act.Run("a1"))
            origin = pages[0].url
            costs: dict[bool, list[dict[str, float]]] = {True: [], False: []}
            for is_watched in (True, False) * given.rounds:
                for page, view in zip(pages, VIEWS, strict=True):
                    page.goto(origin if is_watched else "about:blank")
                    if is_watched:
                        view(page)
                time.sleep(2.0)
                missed, before = _missed(guest), _used(pid)
                time.sleep(given.seconds)
                shares = {who: 100 * (used - before.get(who, 0.0)) / given.seconds for who, used in _used(pid).items()}
                costs[is_watched].append(shares)
                parts = "  ".join(f"{who} {share:.1f} %" for who, share in shares.items())
                title = "three browsers" if is_watched else "no browser"
                print(f"{title:16}{sum(shares.values()):6.1f} %  missed {_missed(guest) - missed}  {parts}", flush=True)
            more_by_pair = [
                sum(watched.values()) - sum(alone.values())
                for watched, alone in zip(costs[True], costs[False], strict=True)
            ]
            said("three browsers cost, of a core (median)", f"{median(more_by_pair):+.1f} %")
            guest.do(act.Steer("abort", "a1"))
        browser.close()


def _missed(guest: Guest) -> int:
    """Cycles that were missed so far."""
    guest.do(act.Watch(figures=True))
    figures: dict[str, dict[str, float]] = {}
    while not figures:
        figures = guest.frame().get("figures", {})
    guest.do(act.Watch())
    return int(sum(columns.get("miss", 0) for columns in figures.values()))


def _used(program_pid: int) -> dict[str, float]:
    """Seconds of processor used until now: by the environment, by the runtime's program, by all other processes."""
    runtime = runtime_of(program_pid)
    used = {"environment": _cpu(program_pid), "runtime": _cpu(runtime), "units and others": 0.0}
    for pid in descendants(program_pid):
        if pid != runtime:
            used["units and others"] += _cpu(pid)
    return used


def _cpu(pid: int) -> float:
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / _TICK


if __name__ == "__main__":
    main()
