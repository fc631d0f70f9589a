"""A Chromium that tells how long it took from an event to the picture, and how often it drew."""

import shutil
import statistics
from itertools import pairwise

from playwright.sync_api import Page

FLAGS = ("--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking")
NAMES = ("chromium", "chromium-browser", "google-chrome", "chromium-headless-shell")

PAINTED = """
() => {
  window.took = []; window.frames = []
  const channel = new MessageChannel()
  let at = 0
  channel.port1.onmessage = () => { window.took.push(performance.now() - at); at = 0 }
  addEventListener('pointermove', () => {
    if (at) return
    at = performance.now()
    requestAnimationFrame(() => channel.port2.postMessage(0))
  }, true)
  const tick = (now) => { window.frames.push(now); requestAnimationFrame(tick) }
  requestAnimationFrame(tick)
}
"""

HOLD = """
const Plain = WebSocket
window.WebSocket = class extends Plain { constructor(...words) { super(...words); window.held = this } }
addEventListener('DOMContentLoaded', () => window.held?.addEventListener('message', (e) => {
  const found = JSON.parse(e.data); if ('rev' in found) window.rev = found.rev }))
"""


def path() -> str | None:
    """Where it is; None: there is none."""
    return next(filter(None, map(shutil.which, NAMES)), None)


def framed(page: Page) -> tuple[float, float]:
    """Frames a second and event to paint in ms, medians since last asked."""
    frames, took = page.evaluate(
        "() => { const f = window.frames, t = window.took; window.frames = []; window.took = []; return [f, t] }"
    )
    gaps = [b - a for a, b in pairwise(frames)]
    return 1000 / statistics.median(gaps), statistics.median(took) if took else 0.0
