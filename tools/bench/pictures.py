"""The upper level in a real Chromium: 1,000 icons in four flows, and a dictionary of 1,000 (requirements G07, D01).

Numbers of one machine are comparable with each other only; frames are drawn by software where there is no GPU.
"""

import random
import statistics
import tempfile
import time
from pathlib import Path

from browse.chromium import FLAGS, PAINTED, framed, path
from browse.guest import Guest
from browse.program import program, said
from playwright.sync_api import Browser, Page, sync_playwright

from onika.model.application import AppFlow, Application, Icon
from onika.model.onikon import Onikon
from onika.model.picture import Picture, framed as bordered
from onika.store.base_directory import BaseDirectory
from onika.wire import act

FLOWS = 4
ICONS = 250
"""In each flow."""
ONIKONS = 1000

SINCE_ACT = """
() => {
  window.acted = []
  const channel = new MessageChannel()
  let at = 0
  channel.port1.onmessage = () => { window.acted.push(performance.now() - at); at = 0 }
  const paint = () => requestAnimationFrame(() => channel.port2.postMessage(0))
  const isThere = () => !window.awaited || document.querySelector(window.awaited)
  addEventListener('pointerdown', () => { at = performance.now() }, true)
  new MutationObserver(() => { if (at && isThere()) paint() }).observe(
    document.querySelector('[data-step]').closest('svg'), { subtree: true, childList: true, attributes: true })
}
"""
"""From a button pressed to the picture in which the drawing has changed, and has what is awaited."""


NEXT = """
() => {
  const rows = document.querySelectorAll("[data-flow='0'][data-step]")
  const known = new Set([...rows].map(one => one.dataset.step))
  window.awaited = "[data-flow='0']" + [...known].map(one => `:not([data-step='${one}'])`).join('') + "[data-step]"
}
"""
"""Awaited is a step of flow 0 that is not among those drawn now."""


def picture(drawn: random.Random) -> Picture:
    """One of its own."""
    rows = ["".join(drawn.choice("01234567") for _ in range(32)) for _ in range(32)]
    return bordered(rows)


def large(folder: Path) -> None:
    """A base directory with 1,000 icons, and an application of four flows that uses them."""
    base = BaseDirectory(folder)
    drawn = random.Random(1)
    onikons = []
    for number in range(ONIKONS):
        kind = ("Complete job", "Joint job", "Joint object", "Cartesian object")[number % 4]
        values = {"Joint object": ((0.0,) * 6, (1.0,)), "Cartesian object": ((0.0,) * 9, (1.0,))}.get(kind, ())
        one = Onikon(f"icon{number}", kind, f"what icon {number} does", values, picture(drawn))
        onikons.append(one)
        base.save_onikon(one)
    jobs, pairs = onikons[0::4], list(zip(onikons[1::4], onikons[2::4], strict=True))
    flows = []
    for _ in range(FLOWS):
        steps: list[Icon] = []
        while len(steps) < ICONS - 1:
            steps += [Icon(drawn.choice(jobs))] if drawn.random() < 0.3 else map(Icon, drawn.choice(pairs))
        flows.append(AppFlow(tuple(steps)))
    base.save_application(Application("large", True, tuple(flows)))


def opening(browser: Browser, address: str, title: str) -> Page:
    """A page that shows the application."""
    page = browser.new_context(viewport={"width": 1440, "height": 900}).new_page()
    began = time.perf_counter()
    page.goto(address)
    page.locator("[data-step]").first.wait_for(state="attached")
    said(title, f"{time.perf_counter() - began:.2f}")
    page.wait_for_timeout(1500)
    page.evaluate(SINCE_ACT)
    return page


def acted(page: Page) -> list[float]:
    """Milliseconds from each press to the picture since last asked."""
    took: list[float] = page.evaluate("() => { const a = window.acted; window.acted = []; return a }")
    return took


def inserting(page: Page) -> None:
    """An icon selected in the dictionary is put behind the first one, again and again; everything behind moves on."""
    target = page.locator("[data-step][data-flow='0']").nth(1)
    took = []
    for _ in range(15):
        page.locator("#onikon-icon0").click()
        page.wait_for_timeout(300)
        acted(page)
        page.evaluate(NEXT)
        target.hover()
        page.wait_for_timeout(200)  # who presses has seen where the pointer is: no frame is under way for that
        page.mouse.down(button="right")
        page.wait_for_timeout(60)
        page.mouse.up(button="right")
        page.wait_for_timeout(400)
        took += acted(page)[:1]
    page.evaluate("() => { window.awaited = '' }")
    text = f"{statistics.median(took):.0f} / {max(took):.0f}"
    said("insert near the start, pressed to painted, ms (median / most)", text)


def highlighting(page: Page) -> None:
    """One icon after the other is selected."""
    acted(page)
    for number in range(1, 16):
        page.locator("[data-step][data-flow='0']").nth(number % 6 + 1).click()
        page.wait_for_timeout(150)
    said("highlight, pressed to painted, ms (median)", f"{statistics.median(acted(page)):.0f}")


def scrolling(page: Page) -> None:
    """From the first flow towards the last and back."""
    page.mouse.move(700, 500)
    framed(page)
    for step in range(120):
        page.mouse.wheel(0, 60 if step < 60 else -60)
        page.wait_for_timeout(10)
    hz, _ = framed(page)
    said("scroll: frames/s (median)", f"{hz:.0f}")


def dragging(page: Page) -> None:
    """A picture is carried from the dictionary over the rows, which part for it."""
    where = page.locator("#onikon-icon0").bounding_box()
    if where is None:
        raise RuntimeError("expected the icon in the dictionary")
    page.mouse.move(where["x"] + 30, where["y"] + 15)
    page.mouse.down()
    page.mouse.move(400, 200)
    framed(page)
    for step in range(120):
        page.mouse.move(400 + 4 * step, 200 + 3 * step)
    hz, took = framed(page)
    page.keyboard.press("Escape")
    page.mouse.up()
    said("drag over the rows: frames/s (median)", f"{hz:.0f}")
    said("  event to paint, ms (median)", f"{took:.1f}")


def dictionary(page: Page) -> None:
    """The tab of 1,000 icons is opened."""
    tabs = page.get_by_role("complementary", name="Dictionary")
    took = []
    for name in ("boxes", "large", "boxes", "large"):
        began = time.perf_counter()
        tabs.get_by_role("button", name=name).first.click()
        page.locator("#onikon-icon0" if name == "large" else "#onikon-home").wait_for()
        if name == "large":
            took.append(time.perf_counter() - began)
    said("a dictionary of 1,000 icons is shown, s", f"{statistics.median(took):.2f}")


def acts(address: str, doc: str) -> None:
    """The same by the protocol alone: what of it is the environment's."""
    guest = Guest(address)
    took = [guest.do(act.InsertIcon(doc, "icon0", "0", 0)) for _ in range(50)]
    said(
        "round trip of an insertion, ms (median / most)", f"{statistics.median(took) * 1e3:.1f} / {max(took) * 1e3:.1f}"
    )


def main() -> None:
    """All of it."""
    browser_path = path()
    if browser_path is None:
        print("no Chromium on the PATH: nothing is measured")
        return
    with tempfile.TemporaryDirectory() as parent, sync_playwright() as playwright:
        folder = Path(parent) / "large"
        large(folder)
        browser = playwright.chromium.launch(executable_path=browser_path, args=FLAGS)
        words = ("--no-connect", "--base", str(folder), str(folder / "appl" / "large.appl"))
        with program(*words) as (address, _pid, later):
            page = opening(browser, address, "1,000 icons: address to first icon, s")
            dictionary(page)
            inserting(page)
            highlighting(page)
            page.evaluate(PAINTED)  # not before: what is heard waits for a frame that is asked for
            scrolling(page)
            dragging(page)
            page.context.close()
            acts(later(), "a1")
        browser.close()


if __name__ == "__main__":
    main()
