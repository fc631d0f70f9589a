"""What comes with Onika is changed in a copy of one's own, and brought back; what others have made is taken."""

import re

import pytest
from playwright.sync_api import expect

from kit.labs.kept_library import KeptLibrary
from kit.labs.library_site import LibrarySite, wink
from onika.store.shipped import shipped

pytestmark = pytest.mark.page


@pytest.fixture
def site(tmp_path):
    site = LibrarySite(tmp_path, "far.wings")
    site.publish(description="lamps of others")
    return site


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
    expect(panel).to_contain_text("computes only")
    panel.get_by_role("button", name="Rights of far.wings").click()
    panel.get_by_role("button", name="Give it all rights").click()
    expect(panel).to_contain_text("all rights")
    panel.get_by_role("button", name="Let it compute only").click()
    expect(panel).to_contain_text("computes only")
    site.write("module/wink.rmod", wink("LAMP", "Q_MEZ"))
    site.publish()
    panel.get_by_role("button", name="What is new in far.wings").click()
    expect(panel).to_contain_text("wink would also write or touch Q_MEZ.")
    panel.get_by_role("button", name="Take version 2").click()
    expect(panel).to_contain_text("You use this version.")
    me.page.keyboard.press("Escape")
    me.libraries("far.wings")
    expect(me.icon("wink")).to_be_visible()


def test_a_changed_copy_is_sent_back_and_a_contradiction_shows_both(me, program, site):  # R-F03
    path, home = "module/wink.rmod", program.home / "onika"
    with KeptLibrary(site.base.parent, site) as kept:
        me.page.keyboard.press("Control+k")
        me.page.keyboard.type("Libraries of others")
        me.page.keyboard.press("Enter")
        panel = me.page.get_by_role("dialog", name="Libraries of others")
        panel.get_by_role("textbox", name="Address of a library").fill(kept.server.address)
        panel.get_by_role("button", name="Look", exact=True).click()
        panel.get_by_role("button", name="Trust this key and use the library").click()
        expect(panel).to_contain_text("You use this version.")
        (home / "module").mkdir(exist_ok=True)
        (home / path).write_text(wink(says="winks for me"))
        kept.change((path, wink(), wink(says="winks for others")))
        panel.get_by_role("button", name="What is new in far.wings").click()
        expect(panel).to_contain_text("1 changed here")
        kept.server.password = "ann:secret"
        panel.get_by_role("button", name="Send back changes of far.wings").click()
        panel.get_by_role("textbox", name="What you have changed").fill("for all of us")
        panel.get_by_role("button", name="Send 1 file").click()
        panel.get_by_label("Name", exact=True).fill("ann")
        panel.get_by_label("Password or token").fill("secret")
        panel.get_by_role("button", name="Send 1 file").click()
        expect(panel.get_by_role("alert")).to_contain_text("others have changed module/wink.rmod in the same lines")
        expect(panel.get_by_role("region", name="Differences")).to_contain_text("winks for others")
        assert "winks for others" in kept.text(path)
        panel.get_by_role("button", name="Mine takes its place").click()
        expect(panel.get_by_role("status")).to_contain_text("far.wings has it, in version 3.")
        assert kept.text(path) == wink(says="winks for me")
        expect(panel).not_to_contain_text("changed here")
