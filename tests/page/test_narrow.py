"""The page on a narrow screen: every primary act of both levels is in reach, and nothing lies over Stop."""

import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page

NARROW = {"width": 360, "height": 740}

LAID_OVER_STOP = """stop => {
    const { left, top, width, height } = stop.getBoundingClientRect()
    const shares = [0.1, 0.3, 0.5, 0.7, 0.9]
    const at = (x, y) => document.elementFromPoint(left + x * width, top + y * height)
    const over = shares.flatMap(x => shares.map(y => at(x, y)))
    const others = over.filter(element => !stop.contains(element))
    return others.map(element => element?.outerHTML.slice(0, 200) ?? 'the edge')
}"""
"""What a finger would meet at Stop that is not Stop, or that Stop is not on the screen there."""


class Visitor:
    """Somebody with a small screen, who looks at Stop after every act."""

    def __init__(self, page, me):
        self.page, self.me = page, me
        self.banner = page.get_by_role("banner")
        self.run = page.get_by_role("region", name="Run", exact=True)
        page.set_viewport_size(NARROW)

    def level(self, name):
        self.banner.get_by_role("button", name=name, exact=True).click()

    def part(self, name):
        self.page.get_by_role("group", name="Parts of the page").get_by_role("button", name=name, exact=True).click()
        self.sees_stop()

    def press(self, button, does=True):
        """It is on the screen as a whole, nothing lies over it, and it is pressed; or could be."""
        button.scroll_into_view_if_needed()
        expect(button).to_be_in_viewport(ratio=1)
        button.click(trial=not does)
        self.sees_stop()

    def sees_stop(self):
        stop = self.banner.get_by_role("button", name="Stop", exact=True)
        expect(stop).to_be_in_viewport(ratio=1)
        assert stop.evaluate(LAID_OVER_STOP) == []

    def drags(self, icon, to):
        """To a place of the page."""
        box, mouse = icon.bounding_box(), self.page.mouse
        mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        mouse.down()
        mouse.move(*to, steps=6)
        self.sees_stop()
        mouse.up()

    def reaches(self, *names, within):
        for name in names:
            self.press(within.get_by_role("button", name=name, exact=True).first, does=False)


@pytest.fixture(scope="module")
def program(begin, lab):
    return begin("assemble", f"--base={lab.path}", "--rtpu=rt0")


@pytest.fixture
def visitor(program, page, people):
    return Visitor(page, people(program.enter(page)))


def test_tasks_are_placed_connected_and_switched_on(visitor):  # R-G04, R-X11
    me, page = visitor.me, visitor.page
    visitor.level("Tasks")
    name = me.blank()
    visitor.reaches("Check", "Save as job…", within=page)
    visitor.press(visitor.banner.get_by_role("button", name="Connect…"))
    panel = page.get_by_role("dialog", name=f"Connect {name}")
    visitor.press(panel.get_by_role("button", name="Connect", exact=True))
    release = visitor.banner.get_by_role("button", name="Release")
    expect(release).to_be_visible(timeout=30_000)
    visitor.press(release, does=False)

    visitor.part("Library")
    me.libraries("bench")
    visitor.drags(me.icon("wave"), to=(120, 300))  # the canvas comes to the front when something is dragged
    visitor.press(me.box("wave"))
    visitor.press(visitor.banner.get_by_role("button", name=re.compile("^Undo")), does=False)
    visitor.reaches("Larger", "Smaller", within=page)
    visitor.part("Sheet")
    visitor.press(me.sheet.get_by_role("textbox", name="Rate in this configuration"))
    visitor.part("Canvas")
    me.box("wave").click(modifiers=["Shift"])
    me.state("wave", "ON")
    visitor.part("Tables")
    for tab in ("Variables", "Problems", "Log", "Tasks"):
        visitor.press(me.strip.get_by_role("tab", name=re.compile(f"^{tab}")))
    expect(me.strip.get_by_role("row", name=re.compile("wave.*ON"))).to_be_in_viewport()


def test_pictures_are_joined_and_a_run_is_begun_paused_and_ended(visitor):  # R-G04, R-X11, R-E07
    page, run = visitor.page, visitor.run
    visitor.level("Applications")
    steps = page.get_by_role("region", name="Workspace").locator("[data-step]")
    expect(steps).not_to_have_count(0)
    before = steps.count()
    visitor.press(steps.first, does=False)
    visitor.part("Dictionary")
    visitor.reaches("New target…", within=page)
    page.locator("#onikon-opengripC").dblclick()
    visitor.part("Workspace")
    expect(steps).to_have_count(before + 1)
    undo = visitor.banner.get_by_role("button", name=re.compile("^Undo"))
    visitor.press(undo)
    expect(steps).to_have_count(before)

    visitor.part("Run")
    visitor.press(run.get_by_role("button", name=re.compile("^Check")), does=False)
    visitor.press(run.get_by_role("button", name=re.compile("^Run")))
    expect(run.get_by_role("button", name="Look inside")).to_be_visible(timeout=30_000)  # it has begun
    visitor.press(run.get_by_role("button", name="Pause", exact=True))
    expect(run).to_contain_text(re.compile("pauses after this|is paused"))  # it waits there, however slow the page is
    visitor.reaches("Step", "Abort", "Look inside", within=run)
    visitor.part("Workspace")
    expect(page.get_by_role("region", name="Workspace")).to_be_in_viewport()
    visitor.part("Run")
    visitor.press(run.get_by_role("button", name="Look inside"))
    expect(visitor.me.strip).to_be_in_viewport()  # the tables come to the front
    visitor.part("Run")
    visitor.press(run.get_by_role("button", name="Abort", exact=True))
    expect(run.get_by_role("button", name=re.compile("^Run"))).to_be_visible(timeout=30_000)


@pytest.mark.parametrize("width", [240, 280, 320])
def test_no_width_loses_stop(visitor, width):  # R-G04
    visitor.page.set_viewport_size({"width": width, "height": 480})
    for level in ("Tasks", "Applications"):
        visitor.level(level)
        visitor.sees_stop()


def test_the_columns_at_the_sides_fold_away_and_come_back_where_they_are_needed(visitor):  # R-G04, R-G01
    page = visitor.page
    page.set_viewport_size({"width": 900, "height": 700})
    visitor.level("Applications")
    workspace = page.get_by_role("region", name="Workspace")
    field = page.get_by_role("complementary", name="Dictionary").get_by_role("searchbox")
    before = workspace.bounding_box()["width"]
    for name in ("Dictionary", "Run"):
        page.get_by_role("button", name=f"Fold away: {name}", exact=True).click()
        expect(page.get_by_role("button", name=f"Show: {name}", exact=True)).to_be_visible()
    expect(field).to_be_hidden()
    page.wait_for_function("least => document.querySelector('.workspace').clientWidth > least", arg=before + 400)
    page.keyboard.press("Control+f")
    expect(field).to_be_focused()
    page.get_by_role("button", name="Show: Run", exact=True).press("Enter")
    expect(visitor.run).to_be_visible()
