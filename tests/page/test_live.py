"""A configuration that lives: states, errors, questions, figures, values, and undo in the running system too."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


@pytest.fixture(scope="module")
def program(begin, lab):
    """The environment with a runtime of two processing units in wall time."""
    return begin(f"--base={lab.path}", "--rtpu=rt0", "--rtpu=rt1")


@pytest.fixture
def me(program, page, people):
    """A person with a blank configuration that is connected; in the end nothing of it lives any more."""
    person = people(program.enter(page))
    name = person.blank()
    person.libraries("bench")
    page.locator("body").press("Alt+c")
    page.get_by_role("dialog", name=f"Connect {name}").get_by_role("button", name="Connect", exact=True).click()
    expect(page.get_by_role("button", name="Release")).to_be_visible(timeout=30_000)
    yield person
    if not page.is_closed():
        page.keyboard.press("Escape")
        person.canvas.evaluate("one => one.focus()")
        page.keyboard.press("Control+a")
        page.keyboard.press("Delete")
        expect(person.canvas.locator("[data-task]")).to_have_count(0)


def place(me, *tasks, unit="rt0"):
    for task in tasks:
        k = me.canvas.locator("[data-task]").count()
        me.drag(me.icon(task), 140 + 230 * (k % 4), 120 + 200 * (k // 4))
        me.page.get_by_role("dialog", name=f"On which processing unit shall {task} live?").get_by_role(
            "button", name=re.compile(f"^{unit}")
        ).click()
        me.state(task, "OFF")


def turn(me, *tasks, state="ON"):
    for task in tasks:
        me.box(task).click(modifiers=["Shift"])
        me.state(task, state)


def row(me, task):
    return me.strip.get_by_role("row", name=re.compile(rf"^{task} "))


def test_placing_spawns_where_the_person_says_and_the_icon_shows_it(me):  # R-C11
    place(me, "wave")
    place(me, "calm", unit="rt1")
    expect(me.canvas.locator("[data-task=wave]")).to_contain_text("OFF · rt0")
    expect(me.canvas.locator("[data-task=calm]")).to_contain_text("OFF · rt1")


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


def test_lengths_are_read_and_typed_in_the_unit_that_is_preferred(me):  # R-G08
    place(me, "aim")
    me.page.keyboard.press("Control+,")
    panel = me.page.get_by_role("dialog", name="Preferences")
    panel.get_by_label("Lengths").select_option("mm")
    turn(me, "aim", state="ASKING")
    form = me.page.get_by_role("dialog", name=re.compile("aim asks"))
    field = form.get_by_role("textbox", name=re.compile("^place, mm · −1000 … 2000"))
    field.fill("2500")
    expect(form).to_contain_text("2500 is above 2000")
    field.fill("1250")
    form.get_by_role("button", name="Send").click()
    me.state("aim", "ON")
    me.strip.get_by_role("tab", name="Variables 1").click()
    value = me.strip.get_by_role("row", name=re.compile("AIM double mm")).get_by_role("gridcell").nth(2)
    expect(value).to_have_text("1250")
    panel.get_by_label("Lengths").select_option("m")
    expect(me.strip.get_by_role("row", name=re.compile("AIM double m ")).get_by_role("gridcell").nth(2)).to_have_text(
        "1.250"
    )
    me.page.keyboard.press("Escape")


def test_a_variable_that_nobody_writes_is_written_by_hand(me):  # R-C27
    place(me, "calm")
    turn(me, "calm")
    me.locus("WAVE").focus()
    me.page.keyboard.press("Enter")
    card = me.page.get_by_role("dialog", name=re.compile("^locus WAVE"))
    field = card.get_by_role("textbox", name=re.compile("^Value of WAVE"))
    field.fill("3")
    field.press("Enter")
    me.strip.get_by_role("tab", name="Variables 2").click()
    calm = me.strip.get_by_role("row", name=re.compile("CALM double m ")).get_by_role("gridcell").nth(2)
    expect(calm).to_have_text("1.500")
    slider = card.get_by_role("slider")
    slider.focus()
    slider.press("Home")
    expect(calm).to_have_text("−0.500")
    me.page.keyboard.press("Escape")
    expect(card).to_have_count(0)


def test_a_parameter_is_tuned_while_its_task_is_on_told_where_it_is_refused_and_taken_back(me):  # R-C04, R-X10
    place(me, "wave", "calm")
    turn(me, "wave", "calm")
    me.box("calm").click()
    share = me.sheet.get_by_role("textbox", name="Parameter SHARE")
    expect(me.sheet).to_contain_text("how much of it")
    expect(share).to_have_value("0.5")
    share.fill("7")
    share.press("Enter")
    expect(me.sheet.get_by_role("alert")).to_contain_text("expected 0..1")
    share.press("Escape")
    expect(share).to_have_value("0.5")
    slider = me.sheet.get_by_role("slider", name="SHARE, slider")
    slider.focus()
    slider.press("Home")
    expect(share).to_have_value("0")
    me.strip.get_by_role("tab", name="Variables 2").click()
    calm = me.strip.get_by_role("row", name=re.compile("CALM double m ")).get_by_role("gridcell").nth(2)
    expect(calm).to_have_text(re.compile("^−?0(\\.000)?$"))
    me.state("calm", "ON")
    me.strip.get_by_role("tab", name="Log").click()
    expect(me.strip).to_contain_text("parameters of calm: SHARE was –, is 0 now")
    me.page.keyboard.press("Control+z")
    expect(share).to_have_value("0.5")
    me.state("calm", "ON")


def test_parameter_sets_are_kept_compared_and_switched_all_or_none(me):  # R-C04, R-X10
    place(me, "calm")
    me.page.keyboard.press("Control+s")
    saving = me.page.get_by_role("dialog", name=re.compile("^Save"))
    saving.get_by_role("textbox").first.fill("tuned")
    saving.get_by_role("button", name="Save", exact=True).click()
    me.box("calm").click()
    me.sheet.get_by_role("button", name="Parameter sets…").click()
    panel = me.page.get_by_role("dialog", name="Parameter sets of tuned")
    share = me.sheet.get_by_role("textbox", name="Parameter SHARE")
    for name, word in (("soft", "0.25"), ("hard", "1")):
        share.fill(word)
        share.press("Enter")
        panel.get_by_role("textbox", name="Name of a new set").fill(name)
        panel.get_by_role("button", name="Keep as they are now").click()
        expect(panel.get_by_role("columnheader", name=re.compile(f"^{name}"))).to_be_visible()
    expect(panel.get_by_role("row", name="calm SHARE 1 0.25 1")).to_be_visible()
    panel.get_by_role("button", name="Switch to soft").click()
    expect(share).to_have_value("0.25")
    expect(panel.get_by_role("row", name="calm SHARE 0.25 0.25 1")).to_be_visible()
    file = Path(re.search(r"in (\S+\.sets)\.", panel.inner_text())[1])
    file.write_text(file.read_text().replace("SHARE 1", "SHARE 3"))
    panel.get_by_role("button", name="Switch to hard").click()
    expect(me.page.get_by_role("alertdialog", name="Refused")).to_contain_text("nothing is changed")
    expect(share).to_have_value("0.25")


def test_the_status_view_shows_figures_and_the_columns_that_are_chosen(me):  # R-C14, R-C27, R-G01
    place(me, "wave")
    turn(me, "wave")
    expect(row(me, "wave")).to_have_accessible_name(re.compile(r"ON \d\d+ "))
    me.strip.get_by_role("button", name=re.compile("^Columns")).click()
    choice = me.page.get_by_role("group", name="Columns")
    choice.get_by_role("checkbox", name="max-C").check()
    me.page.keyboard.press("Escape")
    expect(me.strip.get_by_role("columnheader", name="max-C")).to_be_visible()
    me.strip.get_by_role("button", name=re.compile("^Columns")).click()
    choice.get_by_role("checkbox", name="max-C").uncheck()
    me.page.keyboard.press("Escape")
    expect(me.strip.get_by_role("columnheader", name="max-C")).to_have_count(0)


def test_the_variables_view_shows_values_writers_and_readers_and_only_those_wanted(me):  # R-C14, R-C27
    place(me, "wave", "calm")
    turn(me, "wave", "calm")
    me.strip.get_by_role("tab", name="Variables 2").click()
    wave = me.strip.get_by_role("row", name=re.compile("WAVE double m .*wave calm"))
    expect(wave).to_be_visible()
    value = wave.get_by_role("gridcell").nth(2)
    before = value.inner_text()
    expect(value).not_to_have_text(before)
    me.strip.get_by_role("searchbox", name="Find a variable").fill("CALM")
    expect(wave).to_have_count(0)


def test_a_plot_of_a_variable_moves_can_be_paused_and_saved(me):  # R-C14
    place(me, "wave")
    turn(me, "wave")
    me.strip.get_by_role("tab", name=re.compile("^Variables")).click()
    me.strip.get_by_role("row", name=re.compile("WAVE")).click()
    plot = me.page.get_by_role("region", name="Plot of WAVE")
    canvas = plot.locator("canvas").first
    expect(canvas).to_be_visible()
    before = canvas.evaluate("one => one.toDataURL()")
    me.page.wait_for_function("([one, was]) => one.toDataURL() !== was", arg=[canvas.element_handle(), before])
    plot.get_by_role("button", name="Pause").click()
    expect(plot.get_by_role("button", name="Go on")).to_be_visible()
    with me.page.expect_download() as saved:
        plot.get_by_role("button", name="Save the numbers as CSV").click()
    lines = saved.value.path().read_text().splitlines()
    assert lines[0] == "t_s,WAVE" and len(lines) > 2
    plot.get_by_role("button", name="Close the plot of WAVE").click()
    expect(plot).to_have_count(0)


def test_a_live_value_is_pinned_to_its_locus(me):  # R-C09
    place(me, "wave")
    turn(me, "wave")
    me.dot("WAVE").click()
    probe = me.page.get_by_role("group", name="live value of WAVE")
    expect(probe).to_contain_text(re.compile(r"-?0\.\d|−0\.\d"))
    before = probe.inner_text()
    expect(probe).not_to_have_text(before)
    probe.get_by_role("button").click()


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


def test_what_if_is_in_sight_beside_stop_on_a_narrow_screen(me):  # R-X24, R-G04
    place(me, "wave")
    turn(me, "wave")
    me.page.set_viewport_size({"width": 360, "height": 740})
    banner = me.page.get_by_role("banner")
    asking = banner.get_by_role("button", name="What if…?")
    stop = banner.get_by_role("button", name="Stop", exact=True)
    box, end = asking.bounding_box(), stop.bounding_box()["x"]
    assert box["x"] >= 0 and box["x"] + box["width"] <= end
    asking.click()
    expect(me.page.get_by_role("dialog", name="What if?").get_by_label("A fault")).to_be_visible()
    me.page.set_viewport_size({"width": 1200, "height": 800})


def test_a_module_is_told_and_asked_by_name_in_its_sheet(me, excused):  # R-A05
    place(me, "dial")
    me.box("dial").click()
    me.sheet.get_by_text("Get and set by name").click()
    me.sheet.get_by_role("textbox", name="name", exact=True).fill("dial")
    me.sheet.get_by_role("textbox", name="value", exact=True).fill("2.5")
    me.sheet.get_by_role("button", name="Set", exact=True).click()
    expect(me.sheet).to_contain_text("dial was set to 2.5")
    me.sheet.get_by_role("textbox", name="value", exact=True).fill("7")
    me.sheet.get_by_role("button", name="Get", exact=True).click()
    expect(me.sheet).to_contain_text("dial = 2.5")
    me.sheet.get_by_role("textbox", name="value", exact=True).fill("far")
    me.sheet.get_by_role("button", name="Set", exact=True).click()
    expect(me.page.get_by_role("alertdialog", name="Refused")).to_contain_text("dial refuses")


def test_an_icon_of_the_library_foretells_its_load_once_its_code_was_measured(me):  # R-X13
    place(me, "wave")
    turn(me, "wave")
    expect(me.icon("wave")).to_have_accessible_name(re.compile(r"takes \d+ % of a unit"), timeout=30_000)
    expect(me.icon("hurry")).not_to_have_accessible_name(re.compile("takes"))


def test_the_memory_is_checked_and_the_readings_are_saved_to_a_file(me):  # R-A12
    place(me, "wave")
    me.page.keyboard.press("Escape")
    me.canvas.click(position={"x": 500, "y": 300})
    me.sheet.get_by_role("button", name="Check the memory").click()
    expect(me.page.get_by_text("is sound").first).to_be_visible()
    with me.page.expect_download() as download:
        me.sheet.get_by_role("button", name="Save the readings").click()
    lines = download.value.path().read_text().splitlines()
    assert any(re.match(r"\d+\.\d{6} \S+ WAVE double \S+$", line) for line in lines)
