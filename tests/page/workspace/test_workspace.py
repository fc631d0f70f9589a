"""The workspace at the page: every row of table B.4, and what can be made of pictures in flows (D03 to D22)."""

import re

import pytest
from playwright.sync_api import expect

from .builder import CLOSE, MOVE, OPEN, SHIFT, Builder

pytestmark = pytest.mark.page

CONTROL = ["Control"]


@pytest.fixture(scope="module")
def program(begin):
    return begin("--no-connect")


@pytest.fixture
def empty(program, page):
    """Somebody with no application in front."""
    program.enter(page)
    page.get_by_role("button", name="Applications", exact=True).click()
    builder = Builder(page)
    expect(builder.icon("opengripC")).to_be_attached()
    return builder


@pytest.fixture
def me(empty):
    """Somebody with a blank application of one flow in front."""
    empty.blank()
    return empty


def test_left_selects_and_on_empty_space_deselects(me):  # R-G04: B.4, rows 1 and 2
    me.insert("opengripC")
    me.step(1).click()
    expect(me.step(1)).to_have_attribute("aria-selected", "true")
    ground = me.workspace.locator(".ground").bounding_box()
    me.page.mouse.click(ground["x"] + 300, ground["y"] + 260)
    expect(me.picked).to_have_count(0)


def test_shift_and_left_open_what_is_behind(me):  # R-G04: B.4, rows 3 and 4; R-D12
    me.insert("put_back", "opengripC")
    me.step(1).click(modifiers=SHIFT)
    expect(me.page).to_have_url(re.compile("#/appl/put_back$"))
    me.tabs.get_by_role("button", name=re.compile("^Untitled")).last.click()
    me.step(2).click(modifiers=SHIFT)
    expect(me.page.get_by_role("application", name="canvas of opengripC")).to_be_visible()
    me.page.get_by_role("button", name="Applications", exact=True).click()


def test_middle_shows_name_and_type_of_an_action_and_the_values_of_a_target(me):  # R-G04: B.4, rows 5 and 6; R-D08
    me.insert("jmoveC", "home")
    me.step(1).click(button="middle")
    card = me.page.get_by_role("tooltip")
    expect(card).to_contain_text("jmoveC")
    expect(card).to_contain_text("Joint job")
    me.step(2).click(button="middle")
    panel = me.page.get_by_role("dialog")
    expect(panel.get_by_label(re.compile("^duration, s"))).to_have_value("3")


def test_shift_and_middle_edit_the_picture_of_this_one_icon(me):  # R-G04: B.4, row 7; R-D07, R-D17
    me.insert("opengripC")
    me.step(1).click(button="middle", modifiers=SHIFT)
    panel = me.page.get_by_role("dialog", name=OPEN)
    expect(panel.get_by_role("application", name=re.compile("^Picture, 32 by 32"))).to_be_visible()
    expect(panel).to_contain_text("only this one changes")
    panel.get_by_role("radio", name="64").click()  # R-B09
    grid = panel.get_by_role("application", name=re.compile("^Picture, 64 by 64"))
    fitting = grid.bounding_box()["width"]
    panel.get_by_role("button", name="Larger cells").click()
    grid.press("ArrowUp")
    assert grid.bounding_box()["width"] > 1.9 * fitting
    expect(panel).to_contain_text("VERSION 2.0")
    panel.get_by_role("button", name="Undo").click()
    expect(panel.get_by_role("application", name=re.compile("^Picture, 32 by 32"))).to_be_visible()


def test_right_inserts_what_is_selected_in_the_dictionary(me):  # R-G04: B.4, row 8; R-D03
    me.insert("opengripC")
    me.icon("closegripC").click()
    me.step(1).click(button="right")
    me.has(OPEN, CLOSE)
    me.step(1).click(button="right")  # nothing is selected any more
    expect(me.menu).to_be_visible()


@pytest.mark.parametrize("key", ["Delete", "Backspace"])
def test_delete_cuts_and_v_pastes_it(me, key):  # R-G04: B.4, rows 9 and 11; R-D05
    me.insert("opengripC", "closegripC")
    me.step(1).click()
    me.page.keyboard.press(key)
    me.has(CLOSE)
    me.step(1).click()
    me.page.keyboard.press("v")
    me.has(CLOSE, OPEN)


def test_c_copies_and_v_pastes_between_applications(me):  # R-G04: B.4, rows 10 and 11; R-D05
    me.insert("jmoveC", "home")
    me.step(1).click()
    me.step(2).click(modifiers=CONTROL)
    me.page.keyboard.press("c")
    me.blank()
    me.row.focus()
    me.page.keyboard.press("v")
    expect(me.steps).to_have_count(4)
    me.page.keyboard.press("v")
    expect(me.steps).to_have_count(6)
    me.says("Complete.")


def test_where_the_next_does_not_fit_a_hole_opens_and_a_fitting_icon_fills_it(me):  # R-D03
    me.insert("opengripC", "closegripC")
    me.icon("jmoveC").click()
    me.step(1).click(button="right")
    me.has(OPEN, MOVE, "hole: Joint target", CLOSE)
    me.says("1 hole")
    me.icon("home").click()
    me.step(2).click(button="right")
    me.has(OPEN, MOVE, "", CLOSE)
    expect(me.holes).to_have_count(0)
    me.says("Complete.")


def test_deleting_opens_holes_and_closes_them(me):  # R-D19
    me.insert("jmoveC", "home", "closegripC")
    me.step(2).click()
    me.page.keyboard.press("Delete")
    me.has(MOVE, "hole: Joint target", CLOSE)
    me.step(1).click()
    me.page.keyboard.press("Delete")
    me.has(CLOSE)


def test_a_search_begins_clean_after_a_refusal(me):  # R-D03, R-G04
    me.insert("jmoveC")
    me.step(1).click()
    keys = me.page.keyboard
    keys.press("/")
    keys.type("open the hand")
    keys.press("Enter")
    expect(me.refusal).to_contain_text("does not fit")
    keys.type("home")  # the hand stays in the field, and what was refused gives way
    expect(me.refusal).to_have_count(0)
    expect(me.workspace.get_by_role("combobox")).to_have_value("home")


def test_what_does_not_fit_is_refused_with_a_reason_and_what_would_fit(me):  # R-D03, R-X01
    me.insert("jmoveC")
    me.icon("box3_bx").click()
    me.step(1).click(button="right")
    expect(me.refusal).to_contain_text("does not fit")
    me.refusal.get_by_role("button", name=re.compile("fit")).first.click()
    expect(me.dictionary.get_by_role("button", name="Fits here")).to_have_attribute("aria-pressed", "true")
    me.has(MOVE, "hole: Joint target")


def test_start_and_end_stay(me):  # R-D04
    me.insert("opengripC")
    me.row.focus()
    me.page.keyboard.press("Control+a")
    me.page.keyboard.press("Delete")
    me.has()
    me.page.keyboard.press("Delete")
    expect(me.steps).to_have_count(2)
    expect(me.steps.first).to_have_attribute("aria-label", re.compile("^go"))
    expect(me.steps.last).to_have_attribute("aria-label", re.compile("^stop"))


def test_several_flows_side_by_side_or_one_of_them_chosen(empty):  # R-D04, R-D20
    empty.blank(2, "Several flows, side by side")
    chip = empty.workspace.get_by_role("button", name=re.compile("flows$"))
    expect(chip).to_have_text("parallel · 2 flows")
    chip.click()
    expect(chip).to_have_text("conditional · 2 flows")
    empty.page.keyboard.press("Control+z")
    expect(chip).to_have_text("parallel · 2 flows")


def test_a_long_flow_goes_on_in_the_next_line_and_shows_no_words(me):  # R-D20, R-D04
    me.insert("jmoveC", "home")
    me.row.focus()
    me.page.keyboard.press("Control+a")
    me.page.keyboard.press("c")
    for count in range(2, 9):
        me.page.keyboard.press("v")
        expect(me.steps).to_have_count(2 * count + 2)
    expect(me.workspace.locator("path.wrap").first).to_be_attached()
    assert me.workspace.locator("svg text").all_inner_texts() == []
    for k in range(1, 16, 2):  # an action is never split
        job, target = me.step(k).bounding_box(), me.step(k + 1).bounding_box()
        assert job["y"] == target["y"]


def test_undo_and_redo_of_everything(me):  # R-X10
    me.insert("jmoveC", "home")
    me.page.keyboard.press("Control+z")
    me.has(MOVE, "hole: Joint target")
    me.page.keyboard.press("Control+z")
    me.has()
    me.page.keyboard.press("Control+Shift+z")
    me.page.keyboard.press("Control+y")
    expect(me.holes).to_have_count(0)
    expect(me.steps).to_have_count(4)


def test_icons_are_dragged_and_with_control_copied(me):  # R-G04, R-D05
    me.insert("opengripC", "closegripC", "put_back")
    here, there = me.step(3).bounding_box(), me.step(1).bounding_box()
    mouse = me.page.mouse

    def drag():
        mouse.move(here["x"] + 40, here["y"] + 30)
        mouse.down()
        mouse.move(there["x"] + 4, there["y"] + 30, steps=6)
        mouse.up()

    drag()
    expect(me.step(2)).to_have_attribute("aria-label", re.compile(f"^{OPEN}"))
    expect(me.steps).to_have_count(5)
    me.page.keyboard.down("Control")
    drag()
    me.page.keyboard.up("Control")
    expect(me.steps).to_have_count(6)


def test_a_breakpoint_counts_for_the_action_whichever_icon_is_marked(me):  # R-D06
    me.insert("jmoveC", "home")
    me.step(2).click()
    me.page.keyboard.press("m")
    expect(me.step(1)).to_have_attribute("aria-label", re.compile("breakpoint"))
    expect(me.workspace.locator("path.break")).to_have_count(1)
    me.step(1).click()
    me.page.keyboard.press("m")
    expect(me.workspace.locator("path.break")).to_have_count(0)


def test_a_breakpoint_may_have_a_condition_and_nonsense_is_refused(me):  # R-D06, R-X01
    me.insert("opengripC")
    me.menu_item(me.step(1), "Breakpoint with a condition")
    field = me.page.get_by_role("textbox", name=re.compile("^Pause after this action if"))
    field.fill("LAMP is 1e999")
    field.press("Enter")
    expect(me.refusal).to_contain_text("as in 'LAMP == 1'")
    field.fill("LAMP == 1")
    field.press("Enter")
    expect(me.step(1)).to_have_attribute("aria-label", re.compile("breakpoint if LAMP == 1"))


def test_a_synchronisation_tag_is_a_word_without_blanks(empty):  # R-D06
    empty.blank(2, "Several flows, side by side")
    empty.insert("opengripC")
    empty.step(1).click()
    empty.page.keyboard.press("s")
    field = empty.page.get_by_role("textbox", name="Wait for the flows with this tag")
    field.fill("two words")
    field.press("Enter")
    expect(empty.refusal).to_contain_text("without blanks")
    field.fill("meet")
    field.press("Enter")
    expect(empty.step(1)).to_have_attribute("aria-label", re.compile("together at meet"))


def test_a_loop_has_two_ends_and_exactly_one_is_the_test(me):  # R-D06, R-D13
    me.insert("opengripC", "closegripC", "put_back")
    me.step(2).click()
    me.page.keyboard.press("w")
    form = me.page.get_by_role("form", name=f"Loop of “{CLOSE}”")
    me.step(1).click()
    form.get_by_label("Repeat while").fill("LAMP == 0")
    form.get_by_role("button", name="OK").click()
    expect(me.step(2)).to_have_attribute("aria-label", re.compile("decides loop A"))
    expect(me.step(1)).to_have_attribute("aria-label", re.compile("loop A goes on here"))
    expect(me.workspace.locator("path.loop")).to_have_count(1)
    expect(me.workspace).to_contain_text("A ? LAMP == 0")
    me.menu_item(me.step(1), "Take the loop away")
    expect(me.workspace.locator("path.loop")).to_have_count(0)


def test_what_is_selected_is_repeated_so_many_times_in_one_step(me):  # R-D06, R-D13, R-G04
    me.insert("opengripC", "closegripC")
    me.step(1).click()
    me.page.keyboard.press("Shift+ArrowRight")
    me.page.keyboard.press("w")
    form = me.page.get_by_role("form", name=f"Loop of “{CLOSE}”")
    expect(form.get_by_label("How often")).to_be_focused()
    me.page.keyboard.type("5")
    me.page.keyboard.press("Enter")
    me.has(OPEN, CLOSE, "repeat the loop", "5 times")
    expect(me.step(1)).to_have_attribute("aria-label", re.compile("loop A goes on here"))
    me.page.keyboard.press("Control+z")
    me.has(OPEN, CLOSE)


def test_why_a_number_of_times_is_refused_stands_beneath_the_form_which_stays(me):  # R-D13, R-X01
    me.insert("opengripC", "closegripC")
    me.menu_item(me.step(1), "Repeat")
    form = me.page.get_by_role("form", name="Repeat what is selected")
    field = form.get_by_role("textbox", name="How often")
    field.fill("1")
    field.press("Enter")
    expect(me.refusal).to_contain_text("steps can be done 2 to 1000000 times in a loop, not 1")
    beneath, above = me.refusal.bounding_box(), form.bounding_box()
    assert beneath["y"] >= above["y"] + above["height"], "it hides no button of the form"
    field.fill("2")
    expect(me.refusal).to_have_count(0)
    field.press("Enter")
    expect(form).to_have_count(0)
    me.has(OPEN, "repeat the loop", "2 times", CLOSE)


def test_a_branch_stands_in_line_with_its_flows_and_conditions(me):  # R-D13, R-D10
    me.insert("opengripC")
    me.step(1).click()
    me.page.keyboard.press("b")
    form = me.page.get_by_role("form", name=re.compile("^Insert a branch"))
    form.get_by_label(re.compile("^Flow 0 if")).fill("LAMP == 1")
    form.get_by_role("button", name="OK").click()
    branch = me.workspace.get_by_role("option", name=re.compile("^branch into 2 flows"))
    expect(branch).to_be_visible()
    expect(me.workspace).to_contain_text("if LAMP == 1")
    me.insert("closegripC")
    expect(me.workspace.get_by_role("option", name=re.compile(f"^{CLOSE}"))).to_have_count(1)
    me.page.keyboard.press("Control+z")
    me.page.keyboard.press("Control+z")
    me.has(OPEN)


def test_a_no_op_fits_like_what_is_complete(me):  # R-D11
    me.insert("noop")
    me.has("do nothing")
    me.says("Complete.")


def test_two_who_edit_one_flow_see_the_same_in_the_end(program, new_page):  # R-X10
    two = []
    for page in (new_page(), new_page()):
        program.enter(page)
        page.get_by_role("button", name="Applications", exact=True).click()
        two.append(Builder(page))
    first, other = two
    first.blank()
    name = first.workspace.get_by_role("heading", level=1).inner_text()
    other.tabs.get_by_role("button", name=re.compile(f"^{name}( |$)")).click()
    for _ in range(3):
        first.icon("opengripC").dblclick()
        other.icon("closegripC").dblclick()
    for builder in two:
        expect(builder.steps).to_have_count(8)
    labels = [[step.get_attribute("aria-label") for step in builder.steps.all()] for builder in two]
    assert labels[0] == labels[1]


def test_edges_have_letters_if_one_wants(me):  # R-X11
    me.insert("jmoveC")
    me.menu_item(me.workspace.locator(".ground"), "Show letters on the edges")
    expect(me.workspace.locator("text.letter").first).to_be_attached()
