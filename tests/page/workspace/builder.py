"""Somebody at the page who joins pictures to applications."""

import re

from playwright.sync_api import expect

SHIFT = ["Shift"]
OPEN, CLOSE = "open the hand", "close the hand"
MOVE, LINE = "move the joints", "move the hand on a straight line"


class Builder:
    """Somebody who joins pictures."""

    def __init__(self, page):
        self.page = page
        self.workspace = page.get_by_role("region", name="Workspace")
        self.refusal = page.get_by_role("alertdialog", name="Refused")
        self.tabs = page.get_by_role("navigation")
        self.steps = self.workspace.locator("[data-step]")
        self.icons = self.workspace.locator("[data-step]:not([aria-label^=hole])")
        self.row = self.workspace.get_by_role("listbox", name=re.compile("^icons of"))
        self.picked = self.workspace.get_by_role("option", selected=True)
        self.holes = self.workspace.locator("[data-step][aria-label^=hole]")
        self.dictionary = page.get_by_role("complementary", name="Dictionary", exact=True)
        self.menu = page.get_by_role("menu")

    def icon(self, name):
        return self.page.locator(f"#onikon-{name}")

    def step(self, k):
        """What stands at a place of the flows, behind the start icon of the first, which is 0."""
        return self.steps.nth(k)

    def has(self, *names):
        """Wait until just these stand in the only flow, by the beginnings of what they are called."""
        expect(self.steps).to_have_count(len(names) + 2)
        for k, name in enumerate(names):
            expect(self.step(k + 1)).to_have_attribute("aria-label", re.compile(f"^{re.escape(name)}"))

    def blank(self, flows=1, kind=""):
        self.page.locator("body").press("Alt+n")
        panel = self.page.get_by_role("dialog", name="New application")
        if kind:
            panel.get_by_text(kind).click()
            panel.get_by_label("How many flows").fill(str(flows))
        panel.get_by_role("button", name="Begin", exact=True).click()
        expect(panel).to_have_count(0)
        expect(self.steps).to_have_count(2 * flows)

    def insert(self, *names):
        """At the cursor, which goes along."""
        for name in names:
            count, at = self.icons.count(), self.row.get_attribute("aria-activedescendant")
            self.icon(name).dblclick()
            expect(self.icons).to_have_count(count + 1)
            expect(self.row).not_to_have_attribute("aria-activedescendant", at)

    def opens(self, name):
        self.page.locator("body").press("Control+o")
        panel = self.page.get_by_role("dialog", name="Open an application")
        panel.get_by_role("searchbox").fill(name)
        panel.get_by_role("button", name=f"Open {name}", exact=True).click()
        expect(panel).to_have_count(0)

    def says(self, text):
        expect(self.workspace.locator("header")).to_contain_text(text)

    def menu_item(self, step, words):
        step.click(button="right", modifiers=SHIFT)  # with Shift also while something is selected in the dictionary
        self.menu.get_by_role("menuitem", name=re.compile(f"^{words}")).click()
