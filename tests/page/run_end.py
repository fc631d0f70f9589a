"""The good end of a run of arms in wall time, at a machine that may be late meanwhile."""

import re

from playwright.sync_api import Page, expect

_TIMES = 10
_PATIENCE_MS = 60_000


def runs_to_its_end(page: Page) -> None:
    """Wait until it says Done; a flow that halts because the machine kept its arm silent is told to try again."""
    run = page.get_by_role("region", name="Run", exact=True)
    done = run.get_by_text(re.compile("Done: "))
    again = run.get_by_role("button", name=re.compile("^Try again: "))
    for _ in range(_TIMES):
        expect(done.or_(again).first).to_be_visible(timeout=_PATIENCE_MS)
        if done.is_visible():
            return
        standing = again.count()
        again.first.click()
        expect(again).not_to_have_count(standing)
    raise AssertionError(f"after {_TIMES} tries it stands still")
