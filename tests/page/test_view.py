"""How the canvas is looked at, and how everything is taken back."""

import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


def level(me):
    return me.page.get_by_role("toolbar", name="View").get_by_text(re.compile(r"^\d+ %$"))


def width(me, task):
    return me.box(task).bounding_box()["width"]


def test_keys_zoom_in_and_out_to_full_size_and_to_all(me):  # R-G04
    me.place("wave", "calm")
    before = width(me, "wave")
    me.page.keyboard.press("+")
    expect(level(me)).to_have_text("120 %")
    assert width(me, "wave") > before
    me.page.keyboard.press("-")
    me.page.keyboard.press("-")
    expect(level(me)).to_have_text("83 %")
    me.page.keyboard.press("0")
    expect(level(me)).to_have_text("100 %")
    me.page.keyboard.press("2")
    assert me.box("calm").bounding_box()["x"] > 0
    me.page.keyboard.press("1")
    expect(me.box("wave")).to_be_in_viewport()


def test_the_wheel_moves_the_paper_and_with_ctrl_zooms_at_the_pointer(me):  # R-G04
    me.place("wave")
    before = me.box("wave").bounding_box()
    me.page.mouse.move(*me.at(300, 300))
    me.page.mouse.wheel(0, 50)
    me.page.wait_for_function(
        "y => document.querySelector('[data-task=wave]').getBoundingClientRect().y < y - 40", arg=before["y"]
    )
    me.page.keyboard.down("Control")
    me.page.mouse.wheel(0, -100)
    me.page.keyboard.up("Control")
    expect(level(me)).not_to_have_text("100 %")


@pytest.mark.parametrize("button", ["middle", "left"])
def test_the_paper_is_dragged_by_the_middle_button_or_with_space(me, button):  # R-G04
    me.place("wave")
    before, scene = me.box("wave").bounding_box(), me.corner("wave")
    if button == "left":
        me.page.keyboard.down(" ")
    me.page.mouse.move(*me.at(500, 400))
    me.page.mouse.down(button=button)
    me.page.mouse.move(*me.at(560, 430), steps=4)
    me.page.mouse.up(button=button)
    if button == "left":
        me.page.keyboard.up(" ")
    after = me.box("wave").bounding_box()
    assert abs(after["x"] - before["x"] - 60) <= 6 and abs(after["y"] - before["y"] - 30) <= 6
    assert me.corner("wave") == scene


def test_the_minimap_shows_every_task_and_a_click_goes_there(me):  # R-C06, R-G04
    me.place("wave", "calm")
    me.drag(me.box("calm"), 700, 420)
    for _ in range(4):
        me.page.keyboard.press("+")
    small = me.page.get_by_role("img", name="the whole configuration in small; click to go there")
    unfold = me.page.get_by_role("button", name="the whole configuration in small, over what lies there, or folded")
    expect(unfold).to_be_visible()  # a task lies where it would be: it gives way until somebody wants it
    expect(small).to_have_count(0)
    unfold.click()
    assert small.locator("rect").count() >= 3
    before = me.box("wave").bounding_box()
    spot = small.bounding_box()
    me.page.mouse.click(spot["x"] + spot["width"] - 12, spot["y"] + spot["height"] - 12)
    expect(me.box("calm")).to_be_in_viewport()
    assert me.box("wave").count() == 0 or me.box("wave").bounding_box()["x"] != before["x"]


def test_far_away_the_small_print_goes(me):  # R-G07
    me.place("wave")
    expect(me.canvas.get_by_text("20 Hz")).to_be_visible()
    for _ in range(7):
        me.page.keyboard.press("-")
    expect(me.canvas.get_by_text("20 Hz")).not_to_be_visible()
    expect(me.canvas.get_by_text("wave", exact=True)).to_be_visible()


def undo(me, label):
    button = me.page.get_by_role("button", name=f"Undo: {label}")
    expect(button).to_be_enabled()
    me.page.keyboard.press("Control+z")
    expect(me.page.get_by_role("button", name=f"Redo: {label}")).to_be_enabled()


def redo(me, label, key="Control+Shift+z"):
    me.page.keyboard.press(key)
    expect(me.page.get_by_role("button", name=f"Undo: {label}")).to_be_enabled()


def test_every_step_is_taken_back_and_done_again_by_its_label(me):  # R-X10
    me.place("wave", "calm")
    start = me.corner("wave")
    me.box("wave").click()
    me.page.keyboard.press("ArrowDown")
    me.stands("wave", start[0], start[1] + 5)
    undo(me, "moving wave")
    me.stands("wave", *start)
    redo(me, "moving wave")
    me.page.keyboard.press("r")
    undo(me, "flipping wave")
    redo(me, "flipping wave", "Control+y")
    me.dot("WAVE").click(modifiers=["Shift"])
    expect(me.canvas.get_by_role("button", name="locus WAVE, lines hidden")).to_be_visible()
    undo(me, "hiding the connections of WAVE")
    expect(me.canvas.get_by_role("button", name="locus WAVE, idle")).to_be_visible()
    me.box("calm").click()
    me.page.keyboard.press("Delete")
    expect(me.box("calm")).to_have_count(0)
    undo(me, "cutting calm")
    expect(me.box("calm")).to_be_visible()
    for label in ("flipping wave", "moving wave", "placing calm", "placing wave"):
        undo(me, label)
    expect(me.box("wave")).to_have_count(0)
    expect(me.page.get_by_role("button", name="Undo", exact=True)).to_be_disabled()
    for label in ("placing wave", "placing calm", "moving wave"):
        redo(me, label)
    me.stands("wave", start[0], start[1] + 5)


def test_arrows_move_what_is_selected_by_5_and_with_shift_by_25(me):  # R-G04
    me.place("wave")
    x, y = me.corner("wave")
    me.box("wave").click()
    me.page.keyboard.press("ArrowRight")
    me.page.keyboard.press("Shift+ArrowDown")
    expect(me.canvas.locator("[data-task=wave]")).to_have_attribute("transform", f"translate({x + 5} {y + 25})")


def test_a_drag_stays_on_the_grid(me):  # R-G04
    me.place("wave")
    me.drag(me.box("wave"), 333, 287)
    expect(me.page.get_by_role("button", name="Undo: moving wave")).to_be_enabled()
    x, y = me.corner("wave")
    assert x % 5 == 0 and y % 5 == 0


def test_the_command_list_finds_commands_tasks_and_files(me):  # R-G04
    me.page.keyboard.press("Control+k")
    box = me.page.get_by_role("combobox", name="All commands")
    box.fill("check the conf")
    box.press("Enter")
    expect(me.strip.get_by_role("tab", name="Problems 0")).to_have_attribute("aria-selected", "true")
    me.page.keyboard.press("Control+k")
    me.page.get_by_role("combobox", name="All commands").fill("torque_sum")
    me.page.keyboard.press("Enter")
    expect(me.sheet.get_by_role("heading", name="torque_sum")).to_be_visible()


def test_the_help_sheet_lists_keys_and_what_the_mouse_does(me):  # R-G04
    me.page.keyboard.press("?")
    sheet = me.page.get_by_role("dialog", name="Help sheet")
    for words in ("Shift + left, on a task", "Undo", "Ctrl", "Delete"):
        expect(sheet.get_by_text(words).first).to_be_visible()
    me.page.keyboard.press("Escape")
    expect(sheet).to_have_count(0)
