"""What a configuration that lives measures and is told: values, parameters, figures, units, plots."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import expect

from .live_tasks import place, row, turn

pytestmark = pytest.mark.page


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


def test_a_scope_goes_on_without_a_variable_that_goes_and_with_it_when_it_is_back(me):  # R-C14, R-C27
    place(me, "wave", "calm")
    turn(me, "wave", "calm")
    me.box("calm").click()
    me.strip.get_by_role("tab", name="Variables 2").click()
    me.page.get_by_role("button", name="Scope", exact=True).click()
    scope = me.page.get_by_role("dialog", name="Scope", exact=True)
    scope.get_by_role("button", name="Variables").click()
    for name in ("CALM", "WAVE"):
        me.page.get_by_role("checkbox", name=name, exact=True).check()
    error = re.compile(r"Steady error\s*[−\d]")
    expect(scope).to_contain_text(error)
    scope.get_by_text("Window", exact=True).click(force=True)
    me.box("calm").evaluate("box => box.focus()")
    me.page.keyboard.press("Delete")
    gone = scope.get_by_text(re.compile("no task of a subsystem reads or writes .*/CALM any more"))
    expect(gone).to_be_visible()
    expect(scope.get_by_role("img", name=re.compile("2 s"))).to_be_visible()
    me.page.keyboard.press("Control+z")
    me.refusal.get_by_role("button", name="Go on").click()
    me.state("calm", "ON")
    expect(gone).to_have_count(0)
    expect(scope).to_contain_text(error)
    scope.get_by_role("button", name="Close").click()


def test_what_lives_by_hand_is_recorded_and_looked_at_afterwards(me, program):  # R-X05
    record = me.page.get_by_role("button", name="Record", exact=True)
    record.click()
    expect(me.refusal).to_contain_text("nothing lives")
    me.page.keyboard.press("Escape")
    place(me, "wave")
    turn(me, "wave")
    me.canvas.evaluate("canvas => canvas.focus()")
    me.page.keyboard.press("Alt+r")
    end = me.page.get_by_role("button", name="End the recording")
    expect(end).to_have_attribute("aria-pressed", "true")
    expect(me.page.get_by_role("navigation").get_by_text("It is being recorded")).to_be_attached()
    me.strip.get_by_role("tab", name="Variables 1").click()
    value = me.strip.get_by_role("row", name=re.compile("WAVE double m ")).get_by_role("gridcell").nth(2)
    expect(value).not_to_have_text("0.000")
    end.click()
    expect(record).to_have_attribute("aria-pressed", "false")
    (file,) = (program.state / "onika" / "recordings").glob("*.mcap")
    assert file.stat().st_size > 500
    me.page.keyboard.press("Control+k")
    me.page.keyboard.type("Open a recording")
    me.page.keyboard.press("Enter")
    panel = me.page.get_by_role("dialog", name="Open a recording")
    panel.get_by_role("button", name=re.compile("^Open the recording")).first.click()
    expect(me.page.get_by_text(re.compile("^Recording of "))).to_be_visible()
    expect(record).to_have_count(0)
    me.page.get_by_role("button", name="Close the recording").click()
    expect(record).to_be_visible()
