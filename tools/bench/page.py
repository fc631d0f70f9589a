"""The page in a real Chromium: dragging among 500 boxes and 2,000 links, states, start, acts, and what watching costs.

Numbers of one machine are comparable with each other only; frames are drawn by software where there is no GPU.
"""

import argparse
import os
import random
import statistics
import tempfile
import threading
import time
from pathlib import Path

from browse.chromium import FLAGS, HOLD, PAINTED, framed, path
from browse.guest import Guest
from browse.program import program, said
from playwright.sync_api import Page, sync_playwright

from onika.files.rmod import RmodText
from onika.model.configuration import Configuration, Placed
from onika.model.preferences import Preferences
from onika.model.rules.box import box_of
from onika.model.rules.loci import settled
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.wire import act

BOXES = 500
COLUMNS = 25

WAVES = '''
import math
from onika.module import Module, OutVar

class Waves(Module):
    """Writes five vectors that change in every cycle."""
{ports}
    def cycle(self):
        for number, port in enumerate((self.a, self.b, self.c, self.d, self.e)):
            for joint in range(6):
                port[joint] = math.sin(self.now + number + joint)
'''

ALL_STATES = """
([count, state]) => new Promise(done => {
  const changes = [...Array(count).keys()].map(k => [['documents', 'c1', 'tasks', `t${k}`, 'state'], state])
  const data = JSON.stringify({ t: 'Patch', rev: ++window.rev, changes })
  const channel = new MessageChannel()
  channel.port1.onmessage = () => done(performance.now() - at)
  const at = performance.now()
  window.held.dispatchEvent(new MessageEvent('message', { data }))
  requestAnimationFrame(() => channel.port2.postMessage(0))
})
"""


def large(folder: Path) -> None:
    """A base directory with 500 tasks of four pins, and a configuration of all of them."""
    base = BaseDirectory(folder)
    drawn = random.Random(1)
    tasks = []
    for number in range(BOXES):
        near = [max(0, number - drawn.randint(1, 30)) for _ in range(2)] if number else []
        inputs = tuple(dict.fromkeys(f"V{one}_{drawn.randint(0, 1)}" for one in near))
        outputs = (f"V{number}_0", f"V{number}_1")
        task = Task(f"t{number}", f"m{number}", invar=inputs, outvar=outputs, frequency=100.0)
        tasks.append(task)
        base.save_task(RmodText(task))
    placed = tuple(
        Placed(task.name, 60 + number % COLUMNS * 260, 60 + number // COLUMNS * 190)
        for number, task in enumerate(tasks)
    )
    blank = Configuration("large")
    boxes = {task.name: box_of(task, Preferences()) for task in tasks}
    base.save_configuration(settled(Configuration("large", placed), boxes, blank))


def waves(folder: Path) -> None:
    """A base directory with ten tasks that write 50 vectors of six between them."""
    base = BaseDirectory(folder)
    names = "abcde"
    for number in range(10):
        ports = "\n".join(
            f'    {one} = OutVar("double[6]", "-", "a wave", name="W{number}_{one.upper()}")' for one in names
        )
        base.code_file(f"waves{number}").parent.mkdir(parents=True, exist_ok=True)
        base.code_file(f"waves{number}").write_text(WAVES.format(ports=ports))
        outputs = tuple(f"W{number}_{one.upper()}" for one in names)
        base.save_task(RmodText(Task(f"waves{number}", f"waves{number}", outvar=outputs, frequency=100.0)))
    placed = tuple(Placed(f"waves{number}", 60 + number * 200, 60) for number in range(10))
    base.save_configuration(Configuration("waves", placed))


def dragging(page: Page, title: str) -> None:
    """A box is dragged by the mouse, one small step after the other."""
    box = page.locator("[data-task=t262] .hit")
    where = box.bounding_box()
    if where is None:
        raise RuntimeError("expected the box t262 on the canvas")
    x, y = where["x"] + where["width"] / 2, where["y"] + where["height"] / 3
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 6, y)
    framed(page)
    for step in range(120):
        page.mouse.move(x + 6 + step, y + step / 3)
    hz, took = framed(page)
    after = box.bounding_box()
    page.mouse.up()
    if after is None or after["x"] - where["x"] < 50:
        raise RuntimeError("expected the box to follow the pointer")
    said(f"drag {title}: frames/s (median)", f"{hz:.0f}")
    said("  event to paint, ms (median)", f"{took:.1f}")


def near(page: Page) -> None:
    """The view at about 80 %, with the box in it that will be dragged."""
    page.keyboard.press("Escape")
    page.keyboard.press("1")
    page.wait_for_timeout(500)
    where = page.locator("[data-task=t262] .hit").bounding_box()
    if where is None:
        raise RuntimeError("expected the box t262 on the canvas")
    page.mouse.move(where["x"] + where["width"] / 2, where["y"] + where["height"] / 2)
    page.keyboard.down("Control")
    for _ in range(60):
        page.mouse.wheel(0, -40)
        page.wait_for_timeout(20)
        if int(page.locator(".tools .mono").inner_text().partition(" ")[0]) >= 78:
            break
    page.keyboard.up("Control")
    page.wait_for_timeout(300)


def panning(page: Page) -> None:
    """The whole scene is moved under the view."""
    page.mouse.move(700, 400)
    framed(page)
    for step in range(60):
        page.mouse.wheel(8 if step % 20 < 10 else -8, 5)
    hz, _ = framed(page)
    said("pan, all 500 boxes in view: frames/s (median)", f"{hz:.0f}")


def states(page: Page) -> None:
    """All tasks change their state at once: a patch as the server would send it."""
    revision = page.evaluate("() => window.rev")
    if not isinstance(revision, int):
        raise RuntimeError("expected a revision that was heard")
    times = [page.evaluate(ALL_STATES, [BOXES, ("ON", "OFF")[number % 2]]) for number in range(9)]
    said("all 500 states change, heard to painted, ms (median)", f"{statistics.median(times):.0f}")


def scene(browser_path: str) -> None:
    """Everything about the large scene."""
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        large(Path(folder))
        browser = playwright.chromium.launch(executable_path=browser_path, args=FLAGS)
        with program("--no-connect", "--base", folder, "large") as (address, _pid, _later):
            page = browser.new_context(viewport={"width": 1400, "height": 900}).new_page()
            page.add_init_script(HOLD)
            began = time.perf_counter()
            page.goto(address)
            page.locator("[data-task=t0]").wait_for(state="attached")
            said("500 boxes: address to first box, s", f"{time.perf_counter() - began:.2f}")
            page.wait_for_timeout(1500)
            page.evaluate(PAINTED)
            states(page)
            panning(page)
            dragging(page, "with all 500 boxes in view")
            page.keyboard.press("Control+z")
            near(page)
            dragging(page, "at 80 %")
        browser.close()


def starting(browser_path: str) -> None:
    """From nothing to a page that can be used."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=browser_path, args=FLAGS)
        whole, shown = [], []
        for _ in range(3):
            began = time.perf_counter()
            with program() as (address, _pid, _later):
                page = browser.new_context(viewport={"width": 1440, "height": 900}).new_page()
                started = time.perf_counter()
                page.goto(address)
                page.get_by_role("button", name="Stop").wait_for()
                shown.append(time.perf_counter() - started)
                whole.append(time.perf_counter() - began)
                page.context.close()
        browser.close()
    said("page can be used, from a started server, s (median of 3)", f"{statistics.median(shown):.2f}")
    said("page can be used, from the command, s (median of 3)", f"{statistics.median(whole):.2f}")


def acts() -> None:
    """Round trips of acts in a small and in the large configuration."""
    with tempfile.TemporaryDirectory() as folder:
        large(Path(folder))
        for title, words in (("8 tasks", ("jmoveC",)), ("500 tasks", ("--base", folder, "large"))):
            with program("--no-connect", *words) as (address, _pid, _later):
                guest = Guest(address)
                task = "pd" if title == "8 tasks" else "t250"
                took = [guest.do(act.Move("c1", {task: (n, n)})) for n in range(200)]
                said(
                    f"round trip of an act, {title}, ms (median / 95 %)",
                    f"{statistics.median(took) * 1e3:.1f} / {sorted(took)[189] * 1e3:.1f}",
                )


def watching(seconds: float) -> None:
    """What 50 vectors of six at 30 Hz cost the environment, for none and for three browsers, interleaved."""
    with tempfile.TemporaryDirectory() as folder:
        waves(Path(folder))
        with program("--base", folder, "waves") as (address, pid, later):
            first = Guest(address)
            names = tuple(f"waves{number}" for number in range(10))
            first.until(act.Turn("c1", names, True))
            variables = tuple(f"c1/W{number}_{one}" for number in range(10) for one in "ABCDE")
            guests = [first, *(Guest(later()) for _ in range(2))]
            costs: dict[bool, list[float]] = {True: [], False: []}
            heard = 0
            for is_watched in (True, False) * 2:
                for guest in guests:
                    guest.do(act.Watch(variables if is_watched else (), hz=30.0))
                before = _cpu(pid)
                counts = _heard(guests, seconds)
                heard += sum(counts) if is_watched else 0
                costs[is_watched].append((_cpu(pid) - before) / seconds)
            said("50 x 6 at 30 Hz to three browsers: share of a core", f"{statistics.median(costs[True]) * 100:.1f} %")
            said("  and with nobody watching", f"{statistics.median(costs[False]) * 100:.1f} %")
            said("  frames each heard, 1/s", f"{heard / len(guests) / seconds / 2:.0f}")


def _heard(guests: list[Guest], seconds: float) -> list[int]:
    """How many messages each gets in a while."""
    counts = []

    def listen(guest: Guest) -> None:
        until, count = time.monotonic() + seconds, 0
        while (left := until - time.monotonic()) > 0:
            try:
                guest.socket.recv(timeout=left)
                count += 1
            except TimeoutError:
                break
        counts.append(count)

    threads = [threading.Thread(target=listen, args=(guest,)) for guest in guests]
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    return counts


def _cpu(pid: int) -> float:
    """Seconds of processor that a process has used."""
    fields = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def main() -> None:
    """All of it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=8.0, help="how long each watching lasts")
    given = parser.parse_args()
    browser_path = path()
    if browser_path is None:
        print("no Chromium on the PATH: only what needs none")
    else:
        starting(browser_path)
        scene(browser_path)
    acts()
    watching(given.seconds)


if __name__ == "__main__":
    main()
