"""What comes with Onika is changed in a copy of one's own: marked, compared, gone back from, brought back."""

import re

import pytest
from playwright.sync_api import expect

from onika.store.shipped import shipped

pytestmark = pytest.mark.page


@pytest.fixture
def program(begin, lab):
    """A fresh one: what is its own stays its own."""
    return begin(f"--base={lab.path}", "--no-connect")


def test_shipped_code_that_is_changed_is_ones_own_and_the_way_back_loses_nothing(me):  # R-C05, R-X10
    shipped_file = shipped() / "generic" / "module" / "diff.py"
    before = shipped_file.read_bytes()
    me.libraries("generic")
    me.icon("diff").click()
    me.sheet.get_by_role("button", name="Source").click()
    text = me.page.get_by_role("textbox", name=re.compile("^Text of"))
    text.fill("# mine\n" + text.input_value())
    me.page.keyboard.press("Control+s")
    panel = me.page.get_by_role("dialog", name=re.compile("^Source of diff"))
    expect(panel).to_contain_text("yours, over generic")
    expect(me.sheet).to_contain_text("yours, over generic")
    assert shipped_file.read_bytes() == before
    panel.get_by_role("button", name="Compare").click()
    expect(me.page.get_by_role("region", name="Differences")).to_contain_text("# mine")
    me.page.get_by_role("button", name="Go back to the shipped one").click()
    expect(me.sheet).not_to_contain_text("yours, over generic")
    me.page.keyboard.press("Control+k")
    me.page.keyboard.type("Bring back")
    me.page.keyboard.press("Enter")
    me.page.get_by_role("button", name="Bring back", exact=True).click()
    expect(me.page.get_by_text("stands there now")).to_be_visible()
    assert shipped_file.read_bytes() == before
