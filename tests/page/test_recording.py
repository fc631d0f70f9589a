"""Runs recorded at the page, gone on from in the simulator, and kept as tests, with jobs that only wait."""

import re

import pytest
from playwright.sync_api import expect

from kit.labs.laboratory import Laboratory, job, target

pytestmark = pytest.mark.page


def wait(seconds):
    """A pause of so many seconds, as two icons."""
    return job("pauseC", "Pause job") + target("for_a_while", "Pause object", seconds)


@pytest.fixture
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("onika")


@pytest.fixture
def program(begin, folder):
    """With a runtime of its own, and small applications in its home."""
    own = Laboratory(folder / "home" / "onika")
    own.application("quick", [wait("0.3"), wait("0.3")])
    own.application("long", [wait("0.3"), wait("3600")])
    return begin("quick", folder=folder)


class Recorder:
    """Somebody who wants to know afterwards."""

    def __init__(self, page):
        self.page = page
        self.run = page.get_by_role("region", name="Run", exact=True)
        self.record = self.run.get_by_role("button", name="Record", exact=True)
        self.refusal = page.get_by_role("alertdialog", name="Refused")
        self.panel = page.get_by_role("dialog", name=re.compile("^Keep "))

    def has_switched_it(self, on):
        if (self.record.get_attribute("aria-pressed") == "true") is not on:
            self.record.click()
        expect(self.record).to_have_attribute("aria-pressed", str(on).lower())

    def opens(self, name):
        self.page.locator("body").press("Control+o")
        panel = self.page.get_by_role("dialog", name="Open an application")
        panel.get_by_role("searchbox").fill(name)
        panel.get_by_role("button", name=f"Open {name}", exact=True).click()
        expect(panel).to_have_count(0)

    def starts(self):
        self.run.get_by_role("button", name=re.compile("^Run ")).click()

    def keeps(self, expects=""):
        self.panel.get_by_placeholder("LAMP == 1").fill(expects)
        self.panel.get_by_role("button", name=re.compile("^Keep( again)?$")).click()


@pytest.fixture
def me(program, page):
    program.enter(page)
    page.get_by_role("button", name="Applications", exact=True).click()
    return Recorder(page)


def test_a_run_is_recorded_where_that_is_switched_on_and_is_looked_at_afterwards(me, folder):  # R-X05
    me.opens("quick")
    expect(me.record).to_have_attribute("aria-pressed", "false")
    me.page.keyboard.press("Alt+r")
    expect(me.record).to_have_attribute("aria-pressed", "true")
    me.starts()
    expect(me.run.get_by_text("Recording", exact=True)).to_be_visible()
    expect(me.run.get_by_text(re.compile(r"^Recorded: quick-\d{8}-\d{6}\.mcap \(.* [kM]?B\)$"))).to_be_visible()
    (file,) = (folder / "state" / "onika" / "recordings").iterdir()
    assert file.stat().st_size > 1000
    me.run.get_by_role("button", name="Look at the recording").click()
    expect(me.page.get_by_text("Recording of quick")).to_be_visible()
    me.page.get_by_role("button", name="Close the recording").click()
    me.page.reload()
    expect(me.record).to_have_attribute("aria-pressed", "true")


def test_a_recorded_run_goes_on_in_the_simulator_and_can_be_steered_there(me):  # R-X05, R-E10
    me.opens("long")
    me.has_switched_it(True)
    me.starts()
    expect(me.run.get_by_text("2 of 2")).to_be_visible()
    me.run.get_by_role("button", name="Abort", exact=True).click()
    me.run.get_by_role("button", name="Look at the recording").click()
    me.page.get_by_role("button", name="Continue from here").click()
    expect(me.page.get_by_text("Recording of long")).to_have_count(0)
    expect(me.page.get_by_text("Simulator", exact=True)).to_be_visible()
    expect(me.run.get_by_text("2 of 2")).to_be_visible()
    me.run.get_by_role("button", name="Skip to…").click()
    me.run.get_by_role("button", name=re.compile("^1")).click()
    expect(me.run.get_by_text("1 of 2")).to_be_visible()
    me.run.get_by_role("button", name="Abort", exact=True).click()
    expect(me.run.get_by_text("Ended early")).to_be_visible()
    me.page.keyboard.press("Escape")
    me.run.get_by_role("button", name="Leave the simulator").click()
    expect(me.page.get_by_text("a new runtime is there").first).to_be_visible()
    expect(me.page.get_by_text("Simulator", exact=True)).to_have_count(0)


def test_where_nothing_can_be_recorded_that_is_said_before_and_it_runs_without(me, folder):  # R-X01, R-X05
    (folder / "state" / "onika" / "recordings").write_text("in the way")
    me.opens("quick")
    me.has_switched_it(True)
    me.starts()
    expect(me.refusal).to_contain_text("the run cannot be recorded: nothing can be written in")
    me.refusal.get_by_role("button", name="Run without recording").click()
    expect(me.run.get_by_text("Done: all 2 actions")).to_be_visible()
    expect(me.run.get_by_text(re.compile("^Recorded"))).to_have_count(0)


@pytest.mark.slow
def test_a_run_is_kept_as_a_test_with_what_must_hold_at_its_end(me, folder):  # R-X07
    me.opens("quick")
    me.page.keyboard.press("Alt+Shift+K")
    me.keeps("LAMP = 1")
    expect(me.panel).to_contain_text("as in 'LAMP == 1', found 'LAMP = 1'")
    expect(me.panel.get_by_placeholder("LAMP == 1")).to_have_attribute("aria-invalid", "true")
    me.keeps()
    expect(me.panel).to_contain_text(re.compile(r"Beginning|Run \d of 5"))
    expect(me.panel).to_contain_text("Kept: 2 actions", timeout=60_000)
    file = folder / "home" / "onika" / "tests" / "quick.test"
    assert "pauseC" in file.read_text()
    file.write_text("")
    me.keeps()
    me.panel.get_by_role("button", name="Replace it").click()
    expect(me.panel).to_contain_text(re.compile(r"Run \d of 5"), timeout=20_000)
