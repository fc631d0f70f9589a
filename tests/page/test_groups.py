"""Supermodules on the canvas: made, moved, switched, saved, recalled and expanded as one, by mouse and by key."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page

AXE = Path(__file__).parents[2] / "browser" / "node_modules" / "axe-core" / "axe.min.js"


def tab(me, name):
    return me.canvas.get_by_role("button", name=re.compile(rf"^supermodule {name}(,|$)"))


def naming(me):
    return me.page.get_by_role("dialog", name="Name of the supermodule")


def picked(me, *tasks):
    """Wait until these are selected, and no others."""
    for task in tasks:
        expect(me.box(task)).to_have_attribute("aria-pressed", "true")
    expect(me.canvas.locator("[data-task] [aria-pressed=true]")).to_have_count(len(tasks))


def make(me, name, *tasks):
    """A supermodule of tasks, in the order in which they are clicked."""
    me.box(tasks[0]).click()
    for task in tasks[1:]:
        me.box(task).click(modifiers=["Control"])
    me.page.keyboard.press("Control+g")
    field = naming(me).get_by_role("textbox", name="Name of the supermodule")
    expect(field).to_be_focused()
    field.fill(name)
    field.press("Enter")
    expect(tab(me, name)).to_have_attribute("aria-pressed", "true")


def item(me, name):
    return me.page.get_by_role("menuitem", name=name)


def order(me, name):
    """The order of its tasks, as the tab tells it."""
    match = re.search(r"Order: (.+)", tab(me, name).locator("title").text_content() or "")
    return match and match[1]


def test_ctrl_g_makes_a_supermodule_that_is_selected_as_one_and_with_alt_one_by_one(me):  # R-C17
    me.place("wave", "calm", "show")
    make(me, "swing", "wave", "calm")
    picked(me, "wave", "calm")
    me.box("show").click()
    picked(me, "show")
    me.box("calm").click()
    picked(me, "wave", "calm")
    me.box("calm").click(modifiers=["Alt"])
    picked(me, "calm")
    tab(me, "swing").click()
    picked(me, "wave", "calm")
    expect(me.sheet.get_by_role("heading", name="swing")).to_be_visible()


def test_the_name_that_is_proposed_may_be_taken_as_it_is_and_the_order_is_chosen(me):  # R-C17
    me.place("wave", "calm", "show")
    me.box("show").click()
    me.box("wave").click(modifiers=["Control"])
    me.page.keyboard.press("Control+g")
    lines = naming(me).get_by_role("listitem")
    expect(lines).to_contain_text(["show", "wave"])
    naming(me).get_by_role("button", name="wave one place earlier").click()
    expect(lines).to_contain_text(["wave", "show"])
    naming(me).get_by_role("button", name="Make it").click()
    expect(tab(me, "super1")).to_be_visible()
    assert order(me, "super1") == "wave → show"


def test_a_name_that_cannot_be_is_refused_in_the_form_that_stays_open(me):  # R-C17, R-X01
    me.place("wave", "calm")
    me.page.keyboard.press("Control+a")
    me.page.keyboard.press("Control+g")
    naming(me).get_by_role("textbox").fill("2 fast")
    me.page.keyboard.press("Enter")
    expect(naming(me).get_by_role("alert")).to_contain_text("2 fast")
    me.page.keyboard.press("Escape")
    expect(naming(me)).to_have_count(0)
    expect(me.canvas.locator("[data-group]")).to_have_count(0)


def test_name_and_order_of_a_supermodule_can_be_changed_and_taken_back(me):  # R-C17, R-X10
    me.place("wave", "calm")
    make(me, "swing", "wave", "calm")
    tab(me, "swing").click(button="right")
    item(me, "Name and order…").click()
    naming(me).get_by_role("button", name="calm one place earlier").click()
    naming(me).get_by_role("textbox").fill("other")
    naming(me).get_by_role("button", name="Change it").click()
    expect(tab(me, "other")).to_be_visible()
    expect(tab(me, "swing")).to_have_count(0)
    assert order(me, "other") == "calm → wave"
    me.page.keyboard.press("Control+z")
    expect(tab(me, "swing")).to_be_visible()


def test_dragging_the_tab_moves_all_with_their_own_loci_and_one_undo_brings_them_back(me):  # R-C17, R-C10, R-X10
    me.place("wave", "calm", "show")
    make(me, "swing", "wave", "calm")
    names = "wave", "calm", "show"
    before, spots = {name: me.corner(name) for name in names}, {name: me.spot(name) for name in ("WAVE", "CALM")}
    at = tab(me, "swing").bounding_box()
    me.page.mouse.move(at["x"] + 20, at["y"] + 12)
    me.page.mouse.down()
    me.page.mouse.move(at["x"] + 90, at["y"] + 132, steps=5)
    me.page.mouse.up()
    me.stands("wave", before["wave"][0] + 70, before["wave"][1] + 120)
    by = tuple(now - then for now, then in zip(me.corner("wave"), before["wave"], strict=True))
    assert tuple(now - then for now, then in zip(me.corner("calm"), before["calm"], strict=True)) == by
    assert tuple(now - then for now, then in zip(me.spot("WAVE"), spots["WAVE"], strict=True)) == by
    assert (me.corner("show"), me.spot("CALM")) == (before["show"], spots["CALM"])
    me.page.keyboard.press("Control+z")
    me.stands("wave", *before["wave"])
    me.stands("calm", *before["calm"])


def test_a_supermodule_is_saved_recalled_elsewhere_and_expanded_into_its_parts(me, lab):  # R-C17
    me.place("wave", "calm")
    make(me, "pump", "wave", "calm")
    tab(me, "pump").click(button="right")
    item(me, "Save the supermodule…").click()
    panel = me.page.get_by_role("dialog", name="Save the supermodule pump")
    panel.get_by_label("Where").select_option(str(lab.path))
    panel.get_by_role("button", name="Save").click()
    expect(panel).to_have_count(0)
    expect(me.page.get_by_text(re.compile(r"^pump is saved as .*pump\.conf")).first).to_be_visible()

    me.blank()
    me.page.mouse.click(*me.at(300, 200), button="right")
    item(me, "Insert a supermodule…").click()
    files = me.page.get_by_role("dialog", name="Insert as a supermodule")
    files.get_by_role("searchbox").fill("pump")
    files.get_by_role("button", name=re.compile("^pump 2 tasks")).click()
    expect(files).to_have_count(0)
    me.stands("wave", 300, 200)
    picked(me, "wave", "calm")
    assert order(me, "pump") == "wave → calm"

    me.page.keyboard.press("Control+Shift+G")
    expect(me.canvas.locator("[data-group]")).to_have_count(0)
    me.box("calm").click()
    picked(me, "calm")


def test_what_cannot_be_inserted_says_why_and_the_list_stays(me):  # R-C17, R-X01
    me.place("tone")
    me.page.keyboard.press("Control+k")
    me.page.get_by_role("combobox").fill("Insert a supermodule")
    me.page.keyboard.press("Enter")
    files = me.page.get_by_role("dialog", name="Insert as a supermodule")
    files.get_by_role("button", name=re.compile("^pairC ")).click()
    expect(me.refusal).to_contain_text("WAVE")
    expect(files).to_be_visible()
    expect(me.canvas.locator("[data-task]")).to_have_count(1)


def test_keys_come_to_the_tab_and_select_it_as_one(me):  # R-C17, R-X11
    me.place("wave", "calm")
    make(me, "swing", "wave", "calm")
    me.box("wave").click(modifiers=["Alt"])
    me.canvas.evaluate("one => one.focus()")
    me.page.keyboard.press("Escape")
    picked(me)
    me.page.keyboard.press("Alt+ArrowUp")
    expect(tab(me, "swing")).to_be_focused()
    me.page.keyboard.press("Enter")
    picked(me, "wave", "calm")
    me.page.keyboard.press("Space")
    picked(me)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_in_a_supermodule_and_its_form(me, scheme):  # R-G04
    me.page.emulate_media(color_scheme=scheme)
    me.place("wave", "calm", "show")
    make(me, "swing", "wave", "calm")
    me.page.keyboard.press("Control+a")
    me.page.keyboard.press("Control+g")
    expect(naming(me)).to_be_visible()
    me.page.evaluate(AXE.read_text() + "; undefined")
    me.page.evaluate("Promise.all(document.getAnimations().map((one) => one.finished.catch(() => undefined)))")
    results = me.page.evaluate("axe.run(document, { resultTypes: ['violations'] })")
    assert [
        (violation["id"], [node["target"][0] for node in violation["nodes"]][:3]) for violation in results["violations"]
    ] == []


@pytest.fixture(scope="module")
def alive(begin, lab):
    """The environment with a runtime."""
    return begin(f"--base={lab.path}")


def test_shift_and_a_click_on_the_tab_switch_all_on_then_off_and_an_error_shows_in_it(alive, page, people):  # R-C17
    me = people(alive.enter(page))
    name = me.blank()
    me.libraries("bench")
    page.locator("body").press("Alt+c")
    page.get_by_role("dialog", name=f"Connect {name}").get_by_role("button", name="Connect", exact=True).click()
    expect(page.get_by_role("button", name="Release")).to_be_visible(timeout=30_000)
    me.place("wave", "calm", "sick")
    make(me, "swing", "wave", "calm")
    expect(tab(me, "swing, OFF")).to_be_visible()
    tab(me, "swing").click(modifiers=["Shift"])
    expect(tab(me, "swing, ON")).to_be_visible()
    me.box("calm").click(modifiers=["Shift"])
    expect(tab(me, "swing, 1 of 2 ON")).to_be_visible()
    tab(me, "swing").click(modifiers=["Shift"])
    me.state("calm", "ON")
    tab(me, "swing").click(modifiers=["Shift"])
    me.state("calm", "OFF")
    me.state("wave", "OFF")
    expect(tab(me, "swing, OFF")).to_be_visible()
    make(me, "ward", "wave", "sick")  # calm comes with wave, and swing becomes a part of it
    tab(me, "ward").click(modifiers=["Shift"])
    me.state("sick", "ERROR")
    expect(tab(me, "ward, ERROR")).to_be_visible()
