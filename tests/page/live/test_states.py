"""A configuration that lives: states, errors, questions, undo in the running system, connections, stop."""

import re

import pytest
from playwright.sync_api import expect

from .live_tasks import place, row, turn

pytestmark = pytest.mark.page


def test_placing_spawns_where_the_person_says_and_the_icon_shows_it(me):  # R-C11
    place(me, "wave")
    place(me, "calm", unit="rt1")
    expect(me.canvas.locator("[data-task=wave]")).to_contain_text("OFF · rt0")
    expect(me.canvas.locator("[data-task=calm]")).to_contain_text("OFF · rt1")
    me.drag(me.icon("gain"), 600, 120)
    chooser = me.page.get_by_role("dialog", name="On which processing unit shall gain live?")
    chooser.get_by_role("button", name=re.compile("^On a new unit")).click()
    expect(me.canvas.locator("[data-task=gain]")).to_contain_text(re.compile(r"OFF · rt[2-7]"), timeout=60_000)


def test_shift_click_turns_on_and_off_and_lines_show_who_supplies(me):  # R-C11, R-C25, table B.2
    place(me, "wave", "calm")
    expect(me.canvas.get_by_role("button", name="locus WAVE, idle")).to_be_visible()
    turn(me, "wave")
    expect(me.canvas.get_by_role("button", name="locus WAVE, live")).to_be_visible()
    expect(me.canvas.get_by_role("button", name="locus CALM, idle")).to_be_visible()
    turn(me, "wave", state="OFF")
    expect(me.canvas.get_by_role("button", name="locus WAVE, idle")).to_be_visible()


def test_a_task_whose_constant_is_missing_waits_and_says_for_what(me):  # R-C11
    me.drag(me.icon("needs"), 140, 120)
    me.page.get_by_role("dialog").get_by_role("button", name=re.compile("^rt0")).click()
    expect(me.box("needs")).to_have_accessible_name("needs, WAITING, waits for GAIN")
    place(me, "gain")
    turn(me, "gain")
    me.state("needs", "OFF")
    turn(me, "needs")


def test_an_error_shows_the_modules_words_its_traceback_and_the_ways_out(me, excused):  # R-C11, R-C28
    place(me, "sick")
    turn(me, "sick", state="ERROR")
    card = me.page.get_by_role("group", name="error of sick")
    expect(card).to_contain_text("the sensor is dead")
    card.get_by_role("button", name="Show").click()
    me.sheet.get_by_text("Traceback", exact=True).click()
    expect(me.sheet.get_by_label("Traceback")).to_contain_text("sick.py")
    me.sheet.get_by_role("button", name=re.compile(r"sick\.py:\d+")).click()
    expect(me.page.get_by_role("dialog", name="Source of sick").get_by_role("textbox")).to_be_focused()
    me.page.get_by_role("dialog", name="Source of sick").get_by_role("button", name="Close").click()
    me.box("sick").click(button="right")
    me.page.get_by_role("menuitem", name="Clear, leave it off").click()
    me.state("sick", "OFF")


def test_an_error_that_comes_back_leaves_a_task_that_can_be_deleted_and_replaced(me):  # R-C28, R-C22
    place(me, "sick")
    turn(me, "sick", state="ERROR")
    me.page.get_by_role("group", name="error of sick").get_by_role("button", name="Clear, switch on").click()
    me.state("sick", "ERROR")
    me.box("sick").click()
    me.page.keyboard.press("Delete")
    expect(me.box("sick")).to_have_count(0)
    place(me, "sick")


def test_a_question_is_answered_in_a_form_that_knows_unit_and_bounds(me):  # R-C13
    place(me, "aim")
    turn(me, "aim", state="ASKING")
    form = me.page.get_by_role("dialog", name=re.compile("aim asks"))
    field = form.get_by_role("textbox", name=re.compile("^place, m"))
    field.fill("7")
    expect(form).to_contain_text("above 2")
    field.press("Enter")
    me.state("aim", "ASKING")
    field.fill("far")
    expect(form).to_contain_text("no number")
    field.fill("1.25")
    form.get_by_role("button", name="Send").click()
    me.state("aim", "ON")
    expect(form).to_have_count(0)


def test_a_question_put_aside_is_opened_again_from_the_icon(me):  # R-C13
    place(me, "aim")
    turn(me, "aim", state="ASKING")
    form = me.page.get_by_role("dialog", name=re.compile("aim asks"))
    expect(form).to_contain_text("where to go")
    field = form.get_by_role("textbox", name=re.compile("^place, m"))
    field.fill("0.75")
    form.get_by_role("button", name="Not now").click()
    expect(form).to_have_count(0)
    me.page.get_by_role("group", name="question of aim").get_by_role("button", name="Answer…").click()
    expect(field).to_have_value("0.75")


def test_deleting_kills_and_undo_brings_back_to_life(me):  # R-C11, R-C22, R-X10
    place(me, "wave", "calm")
    turn(me, "calm")
    me.box("calm").click()
    me.page.keyboard.press("Delete")
    expect(me.box("calm")).to_have_count(0)
    expect(row(me, "calm")).to_have_count(0)
    me.page.keyboard.press("Control+z")
    expect(me.refusal).to_contain_text("turns calm ON again")
    me.refusal.get_by_role("button", name="Go on").click()
    me.state("calm", "ON")
    expect(row(me, "calm")).to_have_accessible_name(re.compile(r"ON \d+ "))
    me.page.keyboard.press("Control+z")
    me.state("calm", "OFF")
    me.page.keyboard.press("Control+Shift+z")
    me.refusal.get_by_role("button", name="Go on").click()
    me.state("calm", "ON")


def test_an_alias_given_while_it_lives_moves_the_running_task_to_the_other_variable(me):  # R-C04, R-C10
    place(me, "wave", "calm")
    turn(me, "wave", "calm")
    me.box("wave").click()
    alias = me.sheet.get_by_role("textbox", name="Variable behind WAVE")
    alias.fill("SURGE")
    alias.press("Enter")
    expect(me.canvas.get_by_role("button", name="locus SURGE, live")).to_be_visible()
    expect(me.canvas.get_by_role("button", name="locus WAVE, idle")).to_be_visible()
    alias.fill("")
    alias.press("Enter")
    expect(me.canvas.get_by_role("button", name="locus WAVE, live")).to_be_visible()


def test_a_rate_changed_while_it_cycles_is_measured(me):  # R-C04
    place(me, "wave")
    turn(me, "wave")
    me.box("wave").click()
    rate = me.sheet.get_by_role("textbox", name="Rate in this configuration")
    rate.fill("50")
    rate.press("Enter")
    expect(row(me, "wave")).to_have_accessible_name(re.compile(r"ON .* 50Hz (49|50)\.\d"))


def test_a_task_whose_unit_does_not_fit_is_marked_with_the_reason(me):  # R-C07, R-X01
    place(me, "calm")
    me.icon("hurry").click()
    expect(me.page.get_by_role("complementary", name="Task library")).to_contain_text(re.compile("would not run", re.I))


def test_opening_in_place_tells_what_it_will_do_then_keeps_what_both_have(me):  # R-C15
    place(me, "wave", "calm")
    turn(me, "calm", "wave")
    me.page.keyboard.press("Control+o")
    panel = me.page.get_by_role("dialog", name="Open a configuration")
    panel.get_by_role("searchbox").fill("otherC")
    panel.get_by_role("button", name="Open otherC in place").click()
    refusal = me.refusal
    expect(refusal).to_contain_text(re.compile("calm"))
    expect(refusal).to_contain_text(re.compile("wave"))
    expect(me.box("tone")).to_have_count(0)
    refusal.get_by_role("button").last.click()
    me.state("tone", "")
    expect(me.box("wave")).to_have_count(0)
    me.state("calm", "ON")


def test_stop_holds_everything_and_reset_allows_motion_again(me):  # R-G04, R-X10
    place(me, "wave")
    turn(me, "wave")
    me.page.get_by_role("button", name="Stop").click()
    expect(me.page.get_by_role("button", name="Reset", exact=True)).to_be_visible()
    expect(me.page.get_by_role("alert").first).to_be_visible()
    me.page.get_by_role("button", name="Reset", exact=True).click()
    expect(me.page.get_by_role("button", name="Reset", exact=True)).to_have_count(0)
    me.page.keyboard.press("Control+.")
    expect(me.page.get_by_role("button", name="Reset", exact=True)).to_be_visible()
    me.page.get_by_role("button", name="Reset", exact=True).click()
    expect(me.page.get_by_role("button", name="Reset", exact=True)).to_have_count(0)


def test_disconnecting_leaves_no_states_and_connecting_merges_with_what_still_runs(me):  # R-C12, R-C18, R-C25
    place(me, "wave")
    turn(me, "wave")
    name = me.canvas.get_attribute("aria-label").removeprefix("canvas of ")
    me.page.get_by_role("button", name=name).nth(-1).click()
    panel = me.page.get_by_role("dialog", name=f"Connect {name}")
    panel.get_by_role("button", name="Disconnect").click()
    expect(me.box("wave")).to_have_accessible_name("wave")
    me.drag(me.icon("calm"), 400, 300)
    expect(me.box("calm")).to_have_accessible_name("calm")
    me.page.keyboard.press("Alt+c")
    panel.get_by_role("button", name="Connect", exact=True).click()
    me.state("wave", "ON")
    me.state("calm", "OFF")


def test_a_runtime_that_is_not_there_is_refused_and_the_session_goes_on(me):  # R-C18
    name = me.blank()
    me.page.keyboard.press("Alt+c")
    panel = me.page.get_by_role("dialog", name=f"Connect {name}")
    panel.get_by_label("another").check()
    panel.get_by_label("Address").fill("ws://127.0.0.1:9")
    panel.get_by_label("Token").fill("none")
    panel.get_by_role("button", name="Connect", exact=True).click()
    expect(panel.get_by_role("alert")).to_be_visible()
    panel.get_by_role("button", name="Close").click()
    me.drag(me.icon("wave"), 300, 200)
    expect(me.box("wave")).to_be_visible()


def test_what_a_fault_would_lead_to_is_said_and_nothing_is_touched(me):  # R-X24
    place(me, "wave", "calm")
    turn(me, "wave", "calm")
    me.page.get_by_role("banner").get_by_role("button", name="What if…?").click()
    panel = me.page.get_by_role("dialog", name="What if?")
    panel.get_by_label("A fault").select_option("A task fails")
    whom = panel.get_by_label("Whom it concerns")
    whom.select_option(whom.get_by_text(re.compile("wave$")).get_attribute("value"))
    expect(panel.get_by_role("heading", name=re.compile("^What if .+wave fails"))).to_be_visible()
    expect(panel.get_by_role("img", name=re.compile("^What comes when: fault 0 ms"))).to_be_visible()
    expect(panel.get_by_text("ERROR", exact=True)).to_be_visible()
    expect(panel.get_by_text(re.compile("^Clear .+wave, then turn it on again"))).to_be_visible()
    panel.get_by_role("button", name="Close").first.click()
    me.state("wave", "ON")
    me.state("calm", "ON")


def test_the_last_seconds_before_a_failure_are_opened_from_the_sheet(me):  # R-X05, R-C28
    place(me, "sick")
    turn(me, "sick", state="ERROR")
    me.box("sick").click()
    me.sheet.get_by_role("button", name="Look at the last seconds").click()
    close = me.page.get_by_role("button", name="Close the recording")
    expect(close).to_be_visible()
    close.click()
    expect(close).to_have_count(0)
    me.state("sick", "ERROR")


def test_a_narrow_page_shows_one_part_at_a_time_and_always_stop(me):  # R-G04, R-X11, R-X24
    me.page.set_viewport_size({"width": 360, "height": 740})
    banner = me.page.get_by_role("banner")
    parts = me.page.get_by_role("group", name="Parts of the page")
    library = me.page.get_by_role("complementary", name="Task library")
    lower = {"Library": library, "Sheet": me.sheet, "Tables": me.strip, "Canvas": me.canvas}
    upper = {
        "Dictionary": me.page.get_by_role("complementary", name="Dictionary", exact=True),
        "Run": me.page.get_by_role("complementary", name="Run", exact=True),
        "Workspace": me.page.get_by_role("region", name="Workspace"),
    }
    for level, columns in (("Applications", upper), ("Tasks", lower)):
        banner.get_by_role("button", name=level, exact=True).click()
        for name, shown in columns.items():
            parts.get_by_role("button", name=name, exact=True).click()
            for part in columns.values():
                expect(part).to_be_visible(visible=part is shown)
            for button in ("Stop", "What if…?"):
                expect(banner.get_by_role("button", name=button, exact=True)).to_be_in_viewport(ratio=1)
    banner.get_by_role("button", name="What if…?").click()
    expect(me.page.get_by_role("dialog", name="What if?").get_by_label("A fault")).to_be_in_viewport(ratio=1)
    banner.get_by_role("button", name="Stop", exact=True).click(trial=True)  # the panel does not lie over it
    me.page.set_viewport_size({"width": 1200, "height": 800})
    expect(library).to_be_visible()
