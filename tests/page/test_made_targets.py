"""Targets made at the lower level, of what a state variable holds now."""

import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


@pytest.fixture(scope="module")
def program(begin, lab):
    """The environment with a runtime in wall time."""
    return begin(f"--base={lab.path}")


@pytest.fixture
def me(program, page, people):
    """A person with a connected configuration in which `wave` lives."""
    person = people(program.enter(page))
    name = person.blank()
    person.libraries("bench")
    page.locator("body").press("Alt+c")
    page.get_by_role("dialog", name=f"Connect {name}").get_by_role("button", name="Connect", exact=True).click()
    expect(page.get_by_role("button", name="Release")).to_be_visible(timeout=30_000)
    person.drag(person.icon("wave"), 140, 120)
    person.state("wave", "OFF")
    yield person
    page.keyboard.press("Escape")
    person.canvas.evaluate("one => one.focus()")
    page.keyboard.press("Control+a")
    page.keyboard.press("Delete")
    expect(person.canvas.locator("[data-task]")).to_have_count(0)


def test_a_locus_becomes_a_target_of_the_kinds_that_take_it_and_alt_z_takes_it_back(me, program):  # R-C30, R-D08, R-X10
    page = me.page
    me.canvas.get_by_role("button", name=re.compile("^locus WAVE")).click(button="right")
    page.get_by_role("menuitem", name="Make a target of it…").click()
    panel = page.get_by_role("dialog", name="New target")
    expect(panel.get_by_role("radio", name="Joint target")).to_have_count(0)  # one number is no vector of joints
    expect(panel).to_contain_text(re.compile("Read from WAVE, as it is now in"))
    expect(panel.get_by_role("radio", name="Pause target")).to_have_count(0)  # metres are no seconds
    panel.get_by_role("radio", name="Level target").check()
    panel.get_by_label("Name", exact=True).fill("as_high")
    expect(panel.get_by_label(re.compile("^level"))).not_to_have_value("")
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(panel).to_have_count(0)
    path = program.home / "onika" / "dict" / "as_high.onk"
    assert "Level object" in path.read_text()
    page.locator("body").press("Alt+z")
    expect(page.get_by_text(re.compile("as_high"))).to_have_count(0)
    assert not path.exists()


def test_a_row_of_the_table_offers_it_too(me):  # R-C30
    page = me.page
    page.get_by_role("tab", name=re.compile("^Variables")).click()
    page.get_by_role("row", name=re.compile("^WAVE")).click(button="right")
    page.get_by_role("menuitem", name="Make a target of it…").click()
    panel = page.get_by_role("dialog", name="New target")
    expect(panel.get_by_label("Name", exact=True)).to_have_value("wave")
    panel.get_by_role("button", name="Cancel").click()
