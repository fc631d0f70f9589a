"""Libraries of others: looked at, trusted by their key, used at once, and what is new in them."""

import pytest
from playwright.sync_api import expect

from kit.labs.library_site import LibrarySite, wink

pytestmark = pytest.mark.page


@pytest.fixture
def site(tmp_path):
    site = LibrarySite(tmp_path, "far.wings")
    site.publish(description="lamps of others")
    return site


@pytest.fixture
def program(begin, lab):
    """A fresh one: what it takes stays its own."""
    return begin(f"--base={lab.path}", "--no-connect")


def test_a_library_of_others_is_looked_at_trusted_and_used(me, site):  # R-F03, R-F06, R-X16
    me.page.keyboard.press("Control+k")
    me.page.keyboard.type("Libraries of others")
    me.page.keyboard.press("Enter")
    panel = me.page.get_by_role("dialog", name="Libraries of others")
    panel.get_by_role("textbox", name="Address of a library").fill(str(site.folder))
    panel.get_by_role("button", name="Look", exact=True).click()
    expect(panel).to_contain_text("lamps of others")
    expect(panel).to_contain_text("SHA256:")
    panel.get_by_role("button", name="Trust this key and use the library").click()
    expect(panel).to_contain_text("You use this version.")
    site.write("module/wink.rmod", wink("LAMP", "Q_MEZ"))
    site.publish()
    panel.get_by_role("button", name="What is new in far.wings").click()
    expect(panel).to_contain_text("wink would also write or touch Q_MEZ.")
    panel.get_by_role("button", name="Take version 2").click()
    expect(panel).to_contain_text("You use this version.")
    me.page.keyboard.press("Escape")
    me.libraries("far.wings")
    expect(me.icon("wink")).to_be_visible()
