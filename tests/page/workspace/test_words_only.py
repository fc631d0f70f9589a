"""Icons as words alone, as a study may fix it: rectangles without pictures, colours and shapes (requirement H04)."""

import re

import pytest
from playwright.sync_api import expect

from .builder import OPEN, SHIFT, Builder

pytestmark = pytest.mark.page


@pytest.fixture(scope="module")
def program(begin):
    return begin("--no-connect", "--presentation=words")


@pytest.fixture
def me(program, page):
    program.enter(page)
    page.get_by_role("button", name="Applications", exact=True).click()
    builder = Builder(page)
    builder.blank()
    return builder


def test_an_icon_is_a_rectangle_with_words_in_dictionary_and_workspace(me):  # R-H04
    me.insert("opengripC", "opengripC")
    expect(me.step(1)).to_have_text(OPEN)
    expect(me.row.locator("image")).to_have_count(0)
    expect(me.dictionary.locator("svg .band, image")).to_have_count(0)
    bands = me.page.locator("path.band")
    fills = bands.evaluate_all("paths => [...new Set(paths.map((path) => path.style.fill))]")
    assert fills == ["var(--edge-none)"], "no edge has a colour of its own"
    lines = bands.evaluate_all("paths => paths.map((path) => path.getAttribute('d').match(/[LlHhVv]/g)?.length ?? 0)")
    assert len(set(lines)) == 1, "no edge has a shape of its own"


def test_nobody_can_choose_another_way(me):  # R-H04
    expect(me.dictionary.get_by_role("button", name="Fits here")).to_be_visible()
    expect(me.dictionary.get_by_role("group", name="What icons show")).to_have_count(0)
    expect(me.dictionary.get_by_role("button", name="Pictures", exact=True)).to_have_count(0)


def test_keys_build_and_what_is_read_aloud_is_the_same(me):  # R-H04, R-X11
    me.page.keyboard.press("/")
    field = me.page.get_by_role("searchbox").last
    field.fill("open the hand")
    field.press("Enter")
    expect(me.step(1)).to_have_attribute("aria-label", re.compile("^open the hand"))
    expect(me.row).to_have_attribute("aria-activedescendant", re.compile("step-"))


def test_nothing_leads_to_pictures(me):  # R-H04
    me.insert("opengripC")
    me.step(1).click(button="right", modifiers=SHIFT)
    expect(me.menu.get_by_role("menuitem", name=re.compile("^Words"))).to_be_visible()
    expect(me.menu.get_by_role("menuitem", name=re.compile("^Picture"))).to_have_count(0)
    me.page.keyboard.press("Escape")
    me.icon("opengripC").click(button="right")
    expect(me.menu.get_by_role("menuitem", name=re.compile("^Picture"))).to_have_count(0)
    me.page.keyboard.press("Escape")
    panel = me.page.get_by_role("dialog", name=OPEN)
    for what in (me.step(1), me.icon("opengripC")):
        what.click(button="middle", modifiers=SHIFT)
        expect(panel.get_by_label("Words", exact=True)).to_be_visible()
        expect(panel.get_by_role("tab", name="Picture")).to_have_count(0)
        panel.get_by_role("button", name="Cancel").click()


def test_an_application_becomes_an_icon_without_a_picture_being_drawn(me):  # R-H04
    me.insert("opengripC")
    me.page.keyboard.press("Control+s")
    panel = me.page.get_by_role("dialog", name=re.compile("^Save"))
    panel.get_by_role("textbox").first.fill("opens")
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(panel).to_have_count(0)
    me.page.get_by_role("button", name="As icon…").click()
    panel = me.page.get_by_role("dialog", name="Save opens as an icon")
    panel.get_by_role("textbox", name="Description").fill("open it wide")
    expect(panel.get_by_role("button", name="Mirror")).to_have_count(0)
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(me.icon("opens")).to_have_text("open it wide")


def test_the_help_speaks_of_words_and_names_no_colour(me):  # R-H04, R-H07
    me.page.keyboard.press("F1")
    sheet = me.page.get_by_role("dialog", name="Help sheet")
    expect(sheet).to_contain_text("What does not fit is refused")
    expect(sheet).not_to_contain_text("yellow")
    expect(sheet).not_to_contain_text("picture")
    sheet.get_by_role("button", name="Keys and mouse").click()
    expect(sheet).not_to_contain_text("picture editor")
