"""A scope: variables of a running application at every cycle, saved as they are shown."""

import csv
import re

import pytest
from playwright.sync_api import expect

from kit.labs.laboratory import Laboratory, job

pytestmark = pytest.mark.page

WAVE = '''"""A trigger that goes up and down and never ends, beside a reference that jumps."""

import random

from onika.module import Module, OutVar


class Wave(Module):
    trigger = True
    COUNT = OutVar("double", "-", "how often it was called")
    WANTED = OutVar("double", "m", "jumps")
    REACHED = OutVar("double", "m", "follows it")
    SHAKEN = OutVar("double", "m", "noise")
    LAGGING = OutVar("double", "m", "follows the noise")

    def cycle(self):
        self.COUNT = self.COUNT + 1.0
        self.LAGGING = self.LAGGING + 0.2 * (self.SHAKEN - self.LAGGING)
        self.SHAKEN = random.Random(self.COUNT).uniform(-1.0, 1.0)
        self.WANTED = 1.0 if self.COUNT % 400 > 200 else 0.0
        self.REACHED = self.REACHED + 0.05 * (self.WANTED - self.REACHED)
'''
ROWS = (
    "MODULE  wave\nDESC  waves\nINCONST  none\nOUTCONST  none\nINVAR  none\n"
    "OUTVAR  COUNT WANTED REACHED SHAKEN LAGGING\n"
    "TASKTYPE  periodic\nFREQ  200\n"
)


@pytest.fixture
def program(begin, tmp_path_factory):
    folder = tmp_path_factory.mktemp("onika")
    own = Laboratory(folder / "home" / "onika")
    own.module("wave", WAVE)
    own.task("wave", ROWS)
    own.configuration("waveC", "wave 200")
    own.application("waves", [job("waveC")])
    return begin(folder=folder)


@pytest.fixture
def scope(program, page):
    """The scope beside a run, with all variables chosen."""
    program.enter(page)
    page.get_by_role("button", name="Applications", exact=True).click()
    page.locator("body").press("Control+o")
    panel = page.get_by_role("dialog", name="Open an application")
    panel.get_by_role("searchbox").fill("waves")
    panel.get_by_role("button", name="Open waves", exact=True).click()
    run = page.get_by_role("region", name="Run", exact=True)
    run.get_by_role("button", name=re.compile("^Run")).click()
    run.get_by_role("button", name="Look inside").first.click()
    page.get_by_role("tab", name=re.compile("^Variables")).click()
    page.get_by_role("button", name="Scope", exact=True).click()
    scope = page.get_by_role("dialog", name="Scope", exact=True)
    scope.get_by_role("button", name="Variables").click()
    for name in ("COUNT", "LAGGING", "REACHED", "SHAKEN", "WANTED"):
        page.get_by_role("checkbox", name=name, exact=True).check()
    scope.get_by_text("Window", exact=True).click(force=True)
    yield scope
    if run.get_by_role("button", name="Abort", exact=True).is_visible():
        run.get_by_role("button", name="Abort", exact=True).click()


def test_every_cycle_of_a_run_is_shown_measured_and_saved(scope, page, tmp_path):  # R-C14, R-C27
    expect(scope.get_by_role("img", name=re.compile("at every cycle"))).to_be_visible(timeout=20_000)
    scope.get_by_label("Reference").select_option("WANTED")
    scope.get_by_label("Measured").select_option("REACHED")
    expect(scope.get_by_text("RMS of the difference")).to_be_visible()
    scope.get_by_role("button", name="Stop", exact=True).click()
    with page.expect_download() as download:
        scope.get_by_role("button", name=re.compile("CSV")).click()
    path = tmp_path / "scope.csv"
    download.value.save_as(path)
    rows = list(csv.DictReader(path.read_text().splitlines()))
    counts = [int(float(row["COUNT"])) for row in rows if row["COUNT"]]
    assert len(counts) > 20  # of the window that had passed when it was stopped
    assert counts == list(range(counts[0], counts[0] + len(counts)))


def test_how_a_measurement_follows_over_frequency_is_shown(scope, page):  # R-C14
    expect(scope.get_by_role("img", name=re.compile("at every cycle"))).to_be_visible(timeout=20_000)
    scope.get_by_label("Reference").select_option("SHAKEN")
    scope.get_by_label("Measured").select_option("LAGGING")
    scope.get_by_role("button", name="Frequency response", exact=True).click()
    expect(scope.get_by_role("img", name="Gain over frequency")).to_be_visible(timeout=20_000)
    expect(scope.get_by_role("img", name="Phase over frequency")).to_be_visible()
    expect(scope.get_by_text("Phase margin", exact=True)).to_be_visible()
    scope.get_by_role("button", name="Stop", exact=True).click()
    with page.expect_download() as download:
        scope.get_by_role("button", name="Save the frequency response as CSV").click()
    assert download.value.suggested_filename == "response.csv"
