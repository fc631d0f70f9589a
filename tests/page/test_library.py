"""The libraries at the left: what is seen of them, what a mouse does there, what may not be placed and why."""

import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


# -- table B.1


def test_left_on_an_icon_selects_it_and_on_nothing_lets_go(me):  # R-G04, table B.1
    me.icon("wave").click()
    expect(me.icon("wave")).to_have_attribute("aria-pressed", "true")
    libraries = me.page.get_by_role("group", name="bench")
    box = libraries.bounding_box()
    me.page.mouse.click(box["x"] + 4, box["y"] + 4)
    expect(me.icon("wave")).to_have_attribute("aria-pressed", "false")


def test_an_icon_dragged_onto_the_canvas_is_placed(me):  # R-C06, R-C08, table B.1
    me.drag(me.icon("wave"), 300, 200)
    expect(me.box("wave")).to_be_visible()
    x, y = me.corner("wave")
    assert abs(x + 68 - 300) <= 10 and abs(y + 20 - 200) <= 10


def test_an_icon_let_go_beside_the_canvas_or_given_up_by_escape_places_nothing(me):  # R-G04
    icon = me.icon("wave").bounding_box()
    mouse = me.page.mouse
    mouse.move(icon["x"] + 40, icon["y"] + 20)
    mouse.down()
    mouse.move(*me.at(300, 200), steps=5)
    me.page.keyboard.press("Escape")
    mouse.up()
    mouse.move(icon["x"] + 40, icon["y"] + 20)
    mouse.down()
    mouse.move(icon["x"] + 60, icon["y"] + 200, steps=5)
    mouse.up()
    me.drag(me.icon("calm"), 300, 300)
    expect(me.box("calm")).to_be_visible()
    expect(me.box("wave")).to_have_count(0)


def test_middle_on_an_icon_shows_its_parameters(me):  # R-G04, table B.1
    me.icon("calm").click(button="middle")
    expect(me.sheet.get_by_role("heading", name="calm")).to_be_visible()


def test_shift_middle_on_an_icon_shows_its_source(me):  # R-C05, table B.1
    me.icon("calm").click(button="middle", modifiers=["Shift"])
    expect(me.page.get_by_role("dialog", name="Source of calm").get_by_role("textbox")).to_have_value(
        re.compile(r"self\.CALM = self\.WAVE \* self\.SHARE")
    )


def test_ctrl_middle_on_an_icon_shows_its_rmod(me):  # R-C05, table B.1
    me.icon("calm").click(button="middle", modifiers=["Control"])
    expect(me.page.get_by_role("dialog", name="calm.rmod").get_by_role("textbox")).to_have_value(
        re.compile("OUTVAR  CALM")
    )


# -- what there is


def test_every_library_of_the_search_path_is_a_tab_with_its_tasks(me, lab):  # R-C01, R-C19
    libraries = me.page.get_by_role("group", name="Libraries")
    for name in ("bench", "boxes", "generic", "puma"):
        expect(libraries.get_by_role("button", name=re.compile(rf"^{name} \d"))).to_be_visible()
    me.libraries("generic")
    expect(me.icon("pd")).to_be_visible()
    expect(me.icon("wave")).to_have_count(0)


def test_a_task_is_found_by_name_in_all_libraries_and_selected(me):  # R-C03
    me.page.keyboard.press("Control+f")
    me.page.keyboard.type("torque_s")
    me.page.keyboard.press("Enter")
    expect(me.icon("torque_sum")).to_be_focused()
    expect(me.sheet.get_by_role("heading", name="torque_sum")).to_be_visible()


def test_a_library_is_closed_and_opened_again_by_its_path(me, lab):  # R-C01
    libraries = me.page.get_by_role("group", name="Libraries")
    libraries.get_by_role("button", name=re.compile(r"^bench \d")).hover()
    libraries.get_by_role("button", name="Close library bench").click()
    expect(libraries.get_by_role("button", name=re.compile(r"^bench \d"))).to_have_count(0)
    libraries.get_by_role("button", name="Open a library…").click()
    panel = me.page.get_by_role("dialog", name="Open a library")
    panel.get_by_role("textbox").fill(str(lab.path))
    panel.get_by_role("textbox").press("Enter")
    me.libraries("bench")
    expect(me.icon("wave")).to_be_visible()


def test_a_file_with_a_fault_is_left_out_and_named_with_its_line(me, lab):  # R-C01
    good = (lab.path / "module" / "show.rmod").read_text().removesuffix("EOF\n")
    path = lab.task("broken", good.replace("FREQ  20", "FREQ  often"))
    region = me.page.get_by_role("region", name="1 file left out")
    try:
        expect(region).to_contain_text(re.compile(r"broken\.rmod:8: expected a number above 0 .* found 'FREQ +often'"))
        expect(me.icon("broken")).to_have_count(0)
    finally:
        path.unlink()
    expect(region).to_have_count(0)


def test_a_task_that_was_written_to_the_disk_appears_by_itself(me, lab):  # R-C01
    lab.module("fresh", (lab.path / "module" / "show.py").read_text())
    rows = (lab.path / "module" / "show.rmod").read_text().removesuffix("EOF\n")
    path = lab.task("fresh", rows.replace("show", "fresh"))
    expect(me.icon("fresh")).to_be_visible()
    path.unlink()
    expect(me.icon("fresh")).to_have_count(0)


# -- what may not be placed


def greyed(me, task, why):
    expect(me.icon(task)).to_have_accessible_name(re.compile(f"{why}.*may not be placed"))


def test_what_would_write_twice_is_greyed_with_the_reason_and_free_again_after(me):  # R-C07, R-X01
    me.place("wave")
    greyed(me, "wave", "wave is placed already")
    greyed(me, "tone", "writes WAVE, which wave already writes")
    greyed(me, "swell", "module")
    me.remove("wave")
    expect(me.icon("tone")).to_have_accessible_name("tone, 20 Hz")


def test_a_variable_that_is_a_constant_elsewhere_is_greyed_either_way_round(me):  # R-C07, section 4.2.2
    me.place("needs")
    greyed(me, "drift", "GAIN")
    me.remove("needs")
    me.place("drift")
    greyed(me, "needs", "GAIN")


def test_a_greyed_task_is_not_carried_and_its_remedies_stand_below_it(me):  # R-X01
    me.place("wave")
    me.drag(me.icon("tone"), 500, 300)
    expect(me.box("tone")).to_have_count(0)
    me.icon("tone").click()
    me.page.get_by_role("button", name="Replace wave").click()
    expect(me.box("tone")).to_be_visible()
    expect(me.box("wave")).to_have_count(0)


def test_a_greyed_task_shows_who_stands_in_its_way(me):  # R-X01
    me.place("wave")
    me.page.keyboard.press("Escape")
    me.icon("tone").click()
    me.page.get_by_role("button", name="Show wave").click()
    expect(me.sheet.get_by_role("heading", name="wave")).to_be_visible()
