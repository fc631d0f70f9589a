"""Beside the button that runs an application stands what it would come to."""

import re

import pytest
from playwright.sync_api import expect

from kit.labs.laboratory import Laboratory, job, target

from .program import FORESEES

pytestmark = pytest.mark.page

LONGEST_MS = 60_000
"""A forecast is a program of its own, and the machine may have others to start."""


def wait(seconds):
    """A pause of so many seconds, as two icons."""
    return job("pauseC", "Pause job") + target(f"for_{seconds}_s", "Pause object", seconds)


def test_a_forecast_stands_beside_run_and_follows_each_edit(begin, tmp_path_factory, page):  # R-E16
    folder = tmp_path_factory.mktemp("onika")
    Laboratory(folder / "home" / "onika").application("waits", [wait("200"), wait("100")])
    begin("waits", "--upper", "--no-connect", FORESEES, folder=folder).enter(page)
    forecast = page.get_by_role("region", name="Run", exact=True).get_by_role("status", name="Forecast")
    expect(forecast).to_contain_text(re.compile(r"It will take 300(\.\d)? s"), timeout=LONGEST_MS)
    steps = page.get_by_role("region", name="Workspace").locator("[data-step]")
    expect(steps).to_have_count(6)
    steps.nth(3).click()
    steps.nth(4).click(modifiers=["Control"])
    page.keyboard.press("Delete")
    expect(steps).to_have_count(4)
    expect(forecast).to_contain_text(re.compile(r"It will take 200(\.\d)? s"), timeout=LONGEST_MS)
