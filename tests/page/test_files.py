"""Configurations as files: tabs, marks of what is not saved, saving, opening, and what others write meanwhile."""

import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


def menu(me, item):
    me.page.get_by_role("button", name="New, open, recent files").click()
    me.page.get_by_role("menuitem", name=item).click()


def save_as(me, name, lab):
    me.page.keyboard.press("Control+s")
    panel = me.page.get_by_role("dialog", name=re.compile("^Save "))
    panel.get_by_label("Name").fill(name)
    panel.get_by_label("Where").select_option(str(lab.path))
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(panel).to_have_count(0)


def open_by_name(me, name):
    me.page.keyboard.press("Control+o")
    panel = me.page.get_by_role("dialog", name="Open a configuration")
    panel.get_by_role("searchbox").fill(name)
    panel.get_by_role("button", name=f"Open {name}", exact=True).click()
    expect(me.page.get_by_role("application", name=f"canvas of {name}")).to_be_visible()


def test_what_is_changed_is_marked_and_what_is_only_moved_is_marked_otherwise(me, lab):  # R-C06
    me.place("wave")
    expect(me.tab("Untitled-2")).to_have_accessible_name(re.compile(r"^Untitled-\d+ changed, not saved$"))
    save_as(me, "marked", lab)
    expect(me.tab("marked")).to_have_accessible_name("marked")
    me.box("wave").click()
    me.page.keyboard.press("ArrowRight")
    expect(me.tab("marked")).to_have_accessible_name(re.compile("only moved, not saved"))
    me.page.keyboard.press("Control+z")
    expect(me.tab("marked")).to_have_accessible_name("marked")


def test_a_configuration_is_saved_closed_and_opened_as_it_was(me, lab):  # R-C06
    me.place("wave", "calm")
    me.box("calm").click()
    me.page.keyboard.press("r")
    corner = me.corner("calm")
    save_as(me, "keptC", lab)
    assert (lab.path / "conf" / "keptC.conf").read_text().count("RMODFILE") == 2
    me.page.get_by_role("button", name="Close keptC").click()
    expect(me.tab("keptC")).to_have_count(0)
    open_by_name(me, "keptC")
    me.stands("calm", *corner)
    expect(me.canvas.locator("[data-task=calm] [text-anchor=start]")).to_have_text("CALM")
    expect(me.locus("WAVE")).to_be_visible()


def test_ctrl_s_saves_again_without_asking(me, lab):  # R-C06, R-G04
    me.place("wave")
    save_as(me, "againC", lab)
    me.place("calm")
    me.page.keyboard.press("Control+s")
    expect(me.tab("againC")).to_have_accessible_name("againC")
    assert "calm" in (lab.path / "conf" / "againC.conf").read_text()


def test_a_name_that_is_taken_is_not_overwritten_without_asking(me, lab):  # R-C06, R-X01
    before = (lab.path / "conf" / "otherC.conf").read_text()
    me.place("wave")
    me.page.keyboard.press("Control+Shift+s")
    panel = me.page.get_by_role("dialog", name=re.compile("^Save "))
    panel.get_by_label("Name").fill("otherC")
    panel.get_by_label("Where").select_option(str(lab.path))
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(panel.get_by_role("alert")).to_be_visible()
    assert (lab.path / "conf" / "otherC.conf").read_text() == before
    panel.get_by_role("button", name="Overwrite it").click()
    expect(me.tab("otherC")).to_have_accessible_name("otherC")
    (lab.path / "conf" / "otherC.conf").write_text(before)


def test_closing_what_is_not_saved_asks_and_can_keep_or_discard(me):  # R-C06, R-X01
    me.place("wave")
    name = me.page.get_by_role("application").get_attribute("aria-label").removeprefix("canvas of ")
    close = me.page.get_by_role("button", name=f"Close {name}")
    close.click()
    expect(me.refusal).to_contain_text(f"{name} is not saved")
    me.refusal.get_by_role("button", name="Close", exact=True).click()
    expect(me.tab(name)).to_be_visible()
    close.click()
    me.refusal.get_by_role("button", name="Discard it").click()
    expect(me.tab(name)).to_have_count(0)


def test_new_configurations_count_on_and_keys_walk_the_tabs(me):  # R-C21, R-G04
    first = me.blank()
    menu(me, "New configuration")
    second = f"Untitled-{int(first.removeprefix('Untitled-')) + 1}"
    expect(me.page.get_by_role("application", name=f"canvas of {second}")).to_be_visible()
    me.page.keyboard.press("Alt+PageUp")
    expect(me.page.get_by_role("application", name=f"canvas of {first}")).to_be_visible()


def test_what_is_open_already_is_shown_and_not_opened_twice(me):  # R-C06
    open_by_name(me, "pairC")
    me.blank()
    open_by_name(me, "pairC")
    expect(me.tab("pairC")).to_have_count(1)


def test_a_file_that_is_not_edited_here_follows_the_disk_by_itself(me, lab):  # R-C01, R-C06
    lab.configuration("followC", "wave 20")
    open_by_name(me, "followC")
    expect(me.box("wave")).to_be_visible()
    lab.configuration("followC", "calm 20", "show 20")
    expect(me.box("show")).to_be_visible()
    expect(me.box("wave")).to_have_count(0)


def test_a_file_changed_on_disk_while_edited_here_asks_which_to_keep(me, lab):  # R-X10
    lab.configuration("twoC", "wave 20")
    open_by_name(me, "twoC")
    me.drag(me.icon("calm"), 400, 300)
    expect(me.box("calm")).to_be_visible()
    lab.configuration("twoC", "show 20")
    asks = me.page.get_by_role("alert").filter(has_text="The file of twoC was changed by somebody else.")
    asks.get_by_role("button", name="Take over the file").click()
    expect(me.box("show")).to_be_visible()
    expect(asks).to_have_count(0)
    me.page.keyboard.press("Control+z")
    expect(me.box("calm")).to_be_visible()
    lab.configuration("twoC", "sick 20")
    asks.get_by_role("button", name="Keep what is here").click()
    expect(asks).to_have_count(0)
    expect(me.box("calm")).to_be_visible()
    me.page.keyboard.press("Control+s")
    expect(me.tab("twoC")).to_have_accessible_name("twoC")
    assert "calm" in (lab.path / "conf" / "twoC.conf").read_text()


def test_a_file_with_a_fault_is_refused_with_its_line(me, lab):  # R-X01
    path = lab.path / "conf" / "brokenC.conf"
    path.write_text("VERSION     1.3\n\nRMODFILE    wave\nCOORDS      far away\n\nEOF\n")
    me.page.keyboard.press("Control+o")
    panel = me.page.get_by_role("dialog", name="Open a configuration")
    panel.get_by_label("or the path of a .conf file").fill(str(path))
    panel.get_by_role("button", name="Open", exact=True).last.click()
    expect(me.refusal).to_contain_text("brokenC.conf:4")
    path.unlink()


def test_a_file_that_is_dropped_on_the_page_is_opened(me, lab):  # R-G04
    transfer = me.page.evaluate_handle(
        "text => { const d = new DataTransfer(); d.items.add(new File([text], 'pairC.conf')); return d }",
        (lab.path / "conf" / "pairC.conf").read_text(),
    )
    me.page.get_by_role("banner").dispatch_event("drop", {"dataTransfer": transfer})
    expect(me.page.get_by_role("application", name="canvas of pairC")).to_be_visible()
