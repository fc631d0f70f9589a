"""A configuration becomes a job: what it would be, its picture, its file."""

import base64
import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page

WHITE, BLACK, RED = "7", "8", "0"
RED_PNG = (
    "iVBORw0KGgoAAAANSUhEUgAAAB4AAAAeCAIAAAC0Ujn1AAAAJ0lEQVR42mO4pqFBI8QwavSo0aNGjxo9avSo0aNGjx"
    "o9avSo0eQjANjwCdX1amOwAAAAAElFTkSuQmCC"
)
"""30 by 30 pixels of red."""


def job(me, *tasks):
    """The panel of a job of these tasks, from the shelf of generic ones."""
    me.libraries("generic")
    me.place(*tasks)
    me.page.get_by_role("button", name="Save as job…").click()
    return me.page.get_by_role("dialog", name=re.compile("as a job$"))


def saved(me, lab, name):
    me.page.keyboard.press("Control+Shift+s")
    panel = me.page.get_by_role("dialog", name=re.compile("^Save Untitled"))
    panel.get_by_label("Name").fill(name)
    panel.get_by_label("Where").select_option(str(lab.path))
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(panel).to_have_count(0)


def cell(panel, column, row):
    """The middle of a cell of the picture on the page."""
    box = panel.get_by_role("application").locator("canvas").bounding_box()
    return box["x"] + (column + 0.5) * box["width"] / 32, box["y"] + (row + 0.5) * box["height"] / 32


def picture(lab, name):
    lines = re.findall(r"PICT +([0-8]{32})", (lab.path / "dict" / f"{name}.onk").read_text())
    assert len(lines) == 32
    return lines


def test_a_job_is_drawn_with_the_mouse_and_written(me, lab):  # R-C16, R-C29, R-D07
    me.libraries("generic")
    me.place("jtraj")
    saved(me, lab, "drawnC")
    me.page.get_by_role("button", name="Save as job…").click()
    panel = me.page.get_by_role("dialog", name="Save drawnC as a job")
    expect(panel).to_contain_text("Joint job")
    for hanging in ("Q_MEZ", "NDOF"):
        expect(panel).to_contain_text(hanging)
    mouse = me.page.mouse
    panel.get_by_role("radio", name="red").click()
    panel.get_by_role("button", name="Rectangle", exact=True).click()
    mouse.move(*cell(panel, 4, 4))
    mouse.down()
    mouse.move(*cell(panel, 12, 10), steps=3)
    mouse.up()
    panel.get_by_role("button", name="Fill", exact=True).click()
    panel.get_by_role("radio", name="green").click()
    mouse.click(*cell(panel, 8, 7))
    panel.get_by_role("button", name="Circle", exact=True).click()
    mouse.move(*cell(panel, 20, 20))
    mouse.down()
    mouse.move(*cell(panel, 26, 26), steps=3)
    mouse.up()
    panel.get_by_role("button", name="Undo").click()
    panel.get_by_role("button", name="Redo").click()
    panel.get_by_role("button", name="Undo").click()
    panel.get_by_label("Description").fill("turns the arm by hand")
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(panel).to_have_count(0)
    lines = picture(lab, "drawnC")
    assert lines[4][4:13] == "0" * 9 and lines[7][4] == RED and lines[7][8] == "1"
    assert "1" not in lines[20][18:30] and lines[0] == BLACK * 32
    text = (lab.path / "dict" / "drawnC.onk").read_text()
    assert "Joint job" in text and "turns the arm by hand" in text


def test_a_job_is_drawn_with_the_keys_alone(me, lab):  # R-D07, R-G04
    me.libraries("generic")
    me.place("repeat")
    saved(me, lab, "keysC")
    me.page.get_by_role("button", name="Save as job…").click()
    panel = me.page.get_by_role("dialog", name="Save keysC as a job")
    grid = panel.get_by_role("application")
    grid.focus()
    grid.press("0")
    grid.press("l")
    grid.press(" ")
    for _ in range(6):
        grid.press("ArrowRight")
    grid.press(" ")
    grid.press("Control+z")
    grid.press("Control+Shift+z")
    panel.get_by_role("button", name="Save", exact=True).press("Enter")
    expect(panel).to_have_count(0)
    assert RED * 7 in picture(lab, "keysC")[16]


def test_a_picture_is_mirrored_cleared_and_imported(me, lab, tmp_path):  # R-D07
    me.libraries("generic")
    me.place("repeat")
    saved(me, lab, "mirrorC")
    me.page.get_by_role("button", name="Save as job…").click()
    panel = me.page.get_by_role("dialog", name="Save mirrorC as a job")
    me.page.mouse.click(*cell(panel, 3, 9))
    panel.get_by_role("button", name="Mirror").click()
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(panel).to_have_count(0)
    assert picture(lab, "mirrorC")[9][28] == BLACK and picture(lab, "mirrorC")[9][3] == WHITE
    me.page.get_by_role("button", name="Save as job…").click()
    red = tmp_path / "red.png"
    red.write_bytes(base64.b64decode(RED_PNG))
    shown = panel.get_by_role("application").locator("canvas").element_handle()
    before = shown.evaluate("one => one.toDataURL()")
    panel.locator("input[type=file]").set_input_files(red)
    me.page.wait_for_function("([one, was]) => one.toDataURL() !== was", arg=[shown, before])
    panel.get_by_role("button", name="Save", exact=True).click()
    button = panel.get_by_role("alert").get_by_role("button").first
    expect(button.or_(me.page.locator("body:not(:has([role=dialog]))"))).to_be_visible()
    if button.count():
        button.click()
    expect(panel).to_have_count(0)
    assert picture(lab, "mirrorC")[15][15] == RED


def test_cancel_gives_the_whole_job_up_and_the_panel_blocks_nothing(me, lab):  # R-D21, R-C16
    me.libraries("generic")
    me.place("repeat")
    saved(me, lab, "cancelC")
    me.page.get_by_role("button", name="Save as job…").click()
    panel = me.page.get_by_role("dialog", name="Save cancelC as a job")
    me.page.mouse.click(*cell(panel, 3, 9))
    me.icon("pd").click()
    expect(me.sheet.get_by_role("heading", name="pd")).to_be_visible()
    panel.get_by_role("button", name="Cancel").click()
    expect(panel).to_have_count(0)
    assert not (lab.path / "dict" / "cancelC.onk").exists()


def test_what_is_not_saved_must_be_saved_before_it_is_a_job(me):  # R-C16, R-X01
    panel = job(me, "repeat")
    if panel.get_by_role("button", name="Save", exact=True).count():
        panel.get_by_role("button", name="Save", exact=True).click()
    expect(panel.get_by_role("alert")).to_contain_text(re.compile("sav|file|name", re.I))


def test_several_triggers_are_named_and_the_first_gives_the_type(me, lab):  # R-C29
    me.libraries("generic")
    me.place("repeat", "jtraj")
    saved(me, lab, "severalC")
    me.page.get_by_role("button", name="Save as job…").click()
    panel = me.page.get_by_role("dialog", name="Save severalC as a job")
    expect(panel).to_contain_text("Number job")
    expect(panel).to_contain_text(re.compile("jtraj"))
