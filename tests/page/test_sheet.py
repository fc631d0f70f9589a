"""The sheet of a task: what is known of it, its aliases, its rate, its texts."""

import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


def alias(me, pin):
    return me.sheet.get_by_role("textbox", name=f"Variable behind {pin}")


def test_the_sheet_tells_description_module_rate_and_ports(me):  # R-C02, R-C23
    me.libraries("generic")
    me.icon("diff").click()
    for words in ("module diff", "library generic", "not placed"):
        expect(me.sheet).to_contain_text(words)
    expect(me.sheet.get_by_role("textbox", name="Rate for later placements")).to_have_value("500")
    expect(me.sheet.get_by_role("row", name=re.compile("^variable Y"))).to_have_count(2)
    aliases = me.sheet.get_by_role("textbox", name=re.compile("^Variable behind"))
    assert "Q_MEZ" in [aliases.nth(k).input_value() for k in range(aliases.count())]


def test_two_aliases_may_swap_names(me):  # R-C04
    me.place("calm")  # nowhere else may `wave` stand beside it: an alias holds for all that is open
    me.box("calm").click()
    alias(me, "WAVE").fill("CALM")
    alias(me, "WAVE").press("Enter")
    expect(alias(me, "WAVE")).to_have_value("CALM")
    alias(me, "CALM").fill("WAVE")
    alias(me, "CALM").press("Enter")
    reads = me.canvas.locator("[data-task=calm] [text-anchor=start]")
    writes = me.canvas.locator("[data-task=calm] [text-anchor=end]")
    expect(reads).to_have_text("CALM")
    expect(writes).to_have_text("WAVE")
    me.sheet.get_by_role("button", name="Forget").click()
    expect(reads).to_have_text("WAVE")
    expect(writes).to_have_text("CALM")


def test_an_alias_takes_effect_at_once_on_the_canvas_and_an_empty_one_means_the_coded_name(me):  # R-C04, R-C23
    me.place("wave", "calm")
    me.box("wave").click()
    alias(me, "WAVE").fill("SURGE")
    alias(me, "WAVE").press("Enter")
    expect(me.locus("SURGE")).to_be_visible()
    expect(me.icon("tone")).to_have_accessible_name("tone, 20 Hz")
    alias(me, "WAVE").fill("")
    alias(me, "WAVE").press("Enter")
    expect(me.locus("SURGE")).to_have_count(0)
    expect(me.locus("WAVE")).to_be_visible()


def test_an_alias_that_would_break_a_rule_is_refused_beside_its_field(me):  # R-C07, R-X01
    me.place("wave", "sick")
    me.box("sick").click()
    alias(me, "PULSE").fill("WAVE")
    alias(me, "PULSE").press("Enter")
    expect(me.sheet.get_by_role("alert")).to_contain_text("WAVE")
    expect(me.locus("PULSE")).to_be_visible()


def test_a_changed_alias_is_saved_to_the_rmod_on_wish(me, lab):  # R-C04
    me.icon("show").click()
    alias(me, "CALM").fill("QUIET")
    alias(me, "CALM").press("Enter")
    me.sheet.get_by_role("button", name="Save to show.rmod").click()
    expect(me.sheet.get_by_role("button", name="Save to show.rmod")).to_have_count(0)
    assert re.search(r"SVARALIAS +CALM *= *QUIET", (lab.path / "module" / "show.rmod").read_text())
    alias(me, "CALM").fill("")
    alias(me, "CALM").press("Enter")
    me.sheet.get_by_role("button", name="Save to show.rmod").click()
    expect(me.sheet.get_by_role("button", name="Save to show.rmod")).to_have_count(0)
    assert "SVARALIAS" not in (lab.path / "module" / "show.rmod").read_text()


def test_a_rate_is_changed_here_only_and_nonsense_is_refused(me, lab):  # R-C04
    me.place("wave")
    me.box("wave").click()
    rate = me.sheet.get_by_role("textbox", name="Rate in this configuration")
    rate.fill("fast")
    rate.press("Enter")
    expect(me.sheet.get_by_role("alert")).to_contain_text("fast")
    rate.fill("2 ms")
    rate.press("Enter")
    expect(rate).to_have_value("500")
    expect(me.canvas.locator("[data-task=wave]")).to_contain_text("500 Hz")
    expect(me.sheet).to_contain_text("the file says 20 Hz")
    assert re.search(r"FREQ +20\n", (lab.path / "module" / "wave.rmod").read_text())


def texts(me, task, kind):
    me.icon(task).click(button="middle", modifiers=["Control" if kind == "rmod" else "Shift"])
    return me.page.get_by_role("dialog", name=f"{task}.rmod" if kind == "rmod" else f"Source of {task}")


def test_a_fault_in_an_edited_rmod_stands_beside_its_line(me, lab):  # R-C05
    path = lab.path / "module" / "gain.rmod"
    before = path.read_text()
    panel = texts(me, "gain", "rmod")
    field = panel.get_by_role("textbox")
    expect(field).to_have_value(before)
    field.fill(before.replace("FREQ  20", "FREQ  never"))
    panel.get_by_role("button", name="Save").click()
    fault = panel.get_by_role("button", name=re.compile("^8 .*a number above 0"))
    expect(fault).to_be_visible()
    fault.click()
    expect(field).to_be_focused()
    field.fill(before)
    panel.get_by_role("button", name="Save").click()
    expect(panel.get_by_role("status")).to_have_text("saved and loaded", timeout=30_000)
    assert path.read_text() == before
    expect(me.icon("gain")).to_have_count(1)


def test_a_fault_in_an_edited_source_stands_beside_its_line(me, lab):  # R-C05
    path = lab.path / "module" / "aim.py"
    before = path.read_text()
    panel = texts(me, "aim", "code")
    field = panel.get_by_role("textbox")
    expect(field).to_have_value(before)
    field.fill(before.replace("def cycle(self):", "def cycle(self:"))
    field.press("Control+s")
    expect(panel.get_by_role("button", name=re.compile(r"^\d+ "))).to_be_visible()
    field.fill(before)
    field.press("Control+s")
    expect(panel.get_by_role("status")).to_have_text("saved and loaded", timeout=30_000)


def test_a_text_that_was_written_by_somebody_else_meanwhile_is_shown_beside_mine(me, lab):  # R-C05
    path = lab.path / "module" / "needs.rmod"
    before = path.read_text()
    panel = texts(me, "needs", "rmod")
    expect(panel.get_by_role("textbox")).to_have_value(before)
    path.write_text(before.replace("makes needs", "theirs"))
    panel.get_by_role("textbox").fill(before.replace("makes needs", "mine"))
    panel.get_by_role("button", name="Save").click()
    expect(panel).to_contain_text("The file has changed meanwhile.")
    panel.get_by_role("button", name="Take the file").click()
    expect(panel.get_by_role("textbox")).to_have_value(re.compile("theirs"))
    path.write_text(before)


def test_a_task_without_source_says_so(me, lab):  # R-C23
    rows = (lab.path / "module" / "gain.rmod").read_text().removesuffix("EOF\n")
    path = lab.task("bare", rows.replace("gain", "bare"))
    me.icon("bare").click()
    expect(me.sheet).to_contain_text("There is no source.")
    me.icon("bare").click(button="middle", modifiers=["Shift"])
    expect(me.page.get_by_role("dialog", name="Source of bare").get_by_role("alert")).to_be_visible()
    path.unlink()
