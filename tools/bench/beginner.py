"""What a beginner waits for: the forecast after an edit, acts meanwhile, the workcell put back, an arm's ghost (E16).

    .venv/bin/python tools/bench/beginner.py [ROUNDS]

The program is the shipped assembly of 25 actions. A forecast is a process of its own that takes only time that nobody
else wants: numbers are those of a machine with nothing else to do. Frames are drawn by software where there is no GPU.
"""

import json
import statistics
import sys
import time
from contextlib import suppress
from typing import Any

from browse.chromium import FLAGS, PAINTED, framed, path
from browse.guest import Guest
from browse.program import program, said
from playwright.sync_api import Page, sync_playwright

from onika.wire import act

FORECAST_S, PUT_BACK_S, FRAMES = 3.0, 1.0, 30.0
"""What the issue asks for."""
LONGEST_S = 120.0
ARM_OF = "go_home"


class Reader(Guest):
    """A guest that keeps what it is shown."""

    def __init__(self, address: str) -> None:
        super().__init__(address)
        self.tree: dict[str, Any] = {}

    def hear(self, timeout_s: float) -> dict[str, Any]:
        """The next message; raises TimeoutError where there is none for so long."""
        message: dict[str, Any] = json.loads(self.socket.recv(timeout=timeout_s))
        if message["t"] == "Snapshot":
            self.tree = message["tree"]
        for where, value in message.get("changes", ()) if message["t"] == "Patch" else ():
            self._put(where, value)
        return message

    def answer(self, cid: int) -> dict[str, Any]:
        """The answer to the act of this number."""
        while True:
            message = self.hear(LONGEST_S)
            if message.get("cid") == cid:
                return message

    def _put(self, where: list[str], value: Any) -> None:
        place = self.tree
        for key in where[:-1]:
            place = place.setdefault(key, {})
        place[where[-1]] = value

    def forecast(self, doc: str) -> dict[str, Any]:
        """What is foreseen of an application now."""
        foreseen: dict[str, Any] = self.tree["applications"][doc].get("forecast") or {}
        return foreseen

    def until_state(self, doc: str, *states: str) -> None:
        """Listen until its forecast is in one of these states."""
        until = time.monotonic() + LONGEST_S
        while self.forecast(doc).get("state", "none") not in states:
            self.hear(until - time.monotonic())


def forecasts(rounds: int) -> float:
    """Seconds from the answer to an edit until its forecast, the median; and how long acts take meanwhile."""
    took, first, idle, during = [], [], [], []
    with program("page", "assemble", "--upper", "--no-connect") as (address, _pid, _later):
        guest = Reader(address)
        while not guest.tree.get("applications"):
            guest.hear(LONGEST_S)
        doc = next(iter(guest.tree["applications"]))
        step = int(next(iter(guest.tree["applications"][doc]["steps"])))
        guest.until_state(doc, "whole", "part")
        for number in range(rounds):
            idle += [_refused(guest, doc) for _ in range(20)]
            guest.do(act.EditIcon(doc, step, f"the first, {number}"))
            began = time.perf_counter()
            guest.until_state(doc, "going")
            first.append(time.perf_counter() - began)
            during += [_refused(guest, doc) for _ in range(20)]
            guest.until_state(doc, "whole", "part")
            took.append(time.perf_counter() - began)
        lasts_s = guest.forecast(doc)["lasts_s"]
    said(f"edit to forecast of {lasts_s:.1f} s, s (median / most)", f"{statistics.median(took):.2f} / {max(took):.2f}")
    said("  it begins after, s (median)", f"{statistics.median(first):.2f}")
    said("act, nothing foreseen, ms (median / most)", f"{_ms(idle)}")
    said("act while it is foreseen, ms (median / most)", f"{_ms(during)}")
    return statistics.median(took)


def _refused(guest: Reader, doc: str) -> float:
    """How long the answer to an act takes that changes nothing: of an instant that is not foreseen."""
    began = time.perf_counter()
    with suppress(RuntimeError):
        guest.ask(act.ForeseenInstant(doc, 1000))
    return time.perf_counter() - began


def _ms(times: list[float]) -> str:
    return f"{statistics.median(times) * 1e3:.1f} / {max(times) * 1e3:.1f}"


def putting_back(rounds: int) -> float:
    """Seconds until a workcell is put back that a run has left, the longest."""
    took = []
    with program("page", ARM_OF, "--upper", "--no-forecast") as (address, _pid, _later):
        guest = Reader(address)
        while not guest.tree.get("applications"):
            guest.hear(LONGEST_S)
        doc = next(iter(guest.tree["applications"]))
        for _ in range(rounds):
            guest.until(act.Run(doc))
            until = time.monotonic() + LONGEST_S
            while (guest.tree.get("run") or {}).get("state") != "over":
                guest.hear(until - time.monotonic())
            took.append(guest.do(act.PutBack()))
            guest.do(act.Dismiss(doc))
    said("put back, s (median / most)", f"{statistics.median(took):.2f} / {max(took):.2f}")
    return max(took)


def ghost(browser_path: str) -> float:
    """Frames a second while a slider moves the ghost of an arm, the median."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=browser_path, args=FLAGS)
        with program("page", ARM_OF, "--upper", "--no-forecast") as (address, _pid, _later):
            page = browser.new_context(viewport={"width": 1440, "height": 900}).new_page()
            page.goto(address)
            page.get_by_role("button", name="Take the arm’s present position").click()
            panel = page.get_by_role("dialog", name="New target")
            panel.get_by_text("stands now").wait_for(timeout=LONGEST_S * 1e3)
            hz = _sliding(page)
            page.context.close()
        browser.close()
    said("ghost of an arm behind a slider: frames/s (median)", f"{hz:.0f}")
    return hz


def _sliding(page: Page) -> float:
    slider = page.get_by_role("dialog", name="New target").locator("input[type=range]").first
    room = slider.bounding_box()
    if room is None:
        raise RuntimeError("expected a slider, found none")
    y = room["y"] + room["height"] / 2
    page.mouse.move(room["x"] + room["width"] / 2, y)
    page.mouse.down()
    page.evaluate(PAINTED)
    page.wait_for_timeout(200)
    for number in range(120):
        page.mouse.move(room["x"] + room["width"] * (0.3 + 0.4 * (number % 60) / 60), y)
    hz, _ = framed(page)
    page.mouse.up()
    return hz


def main(words: list[str]) -> int:
    """Measure; 1 where it takes too long."""
    rounds = int(words[0]) if words else 7
    is_quick = forecasts(rounds) <= FORECAST_S
    is_back = putting_back(rounds) <= PUT_BACK_S
    browser_path = path()
    is_smooth = browser_path is None or ghost(browser_path) >= FRAMES
    print(f"limits: forecast {FORECAST_S:g} s, put back {PUT_BACK_S:g} s, ghost {FRAMES:g} frames a second")
    return 0 if is_quick and is_back and is_smooth else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
