"""What is made in the page itself: targets of variables, new modules, configurations kept alive, an order by hand."""

import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


@pytest.fixture(scope="module")
def program(begin, lab):
    """The environment with a runtime in wall time."""
    return begin(f"--base={lab.path}")


@pytest.fixture
def me(program, page, people):
    """A person with a connected configuration in which `wave` lives."""
    person = people(program.enter(page))
    name = person.blank()
    person.libraries("bench")
    page.locator("body").press("Alt+c")
    page.get_by_role("dialog", name=f"Connect {name}").get_by_role("button", name="Connect", exact=True).click()
    expect(page.get_by_role("button", name="Release")).to_be_visible(timeout=30_000)
    person.drag(person.icon("wave"), 140, 120)
    person.state("wave", "OFF")
    yield person
    page.keyboard.press("Escape")
    person.canvas.evaluate("one => one.focus()")
    page.keyboard.press("Control+a")
    page.keyboard.press("Delete")
    expect(person.canvas.locator("[data-task]")).to_have_count(0)


def test_a_locus_becomes_a_target_of_the_kinds_that_take_it_and_undo_takes_it_back(me, program):  # R-C30, R-D08, R-X10
    page = me.page
    me.canvas.get_by_role("button", name=re.compile("^locus WAVE")).click(button="right")
    page.get_by_role("menuitem", name="Make a target of it…").click()
    panel = page.get_by_role("dialog", name="New target")
    expect(panel.get_by_role("radio", name="Joint target", exact=True)).to_have_count(
        0
    )  # one number is no vector of joints
    expect(panel).to_contain_text(re.compile("Read from WAVE, as it is now in"))
    expect(panel.get_by_role("radio", name="Pause target")).to_have_count(0)  # metres are no seconds
    panel.get_by_text("Level target", exact=True).click()
    panel.get_by_label("Name", exact=True).fill("as_high")
    expect(panel.get_by_label(re.compile("^level"))).not_to_have_value("")
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(panel).to_have_count(0)
    expect(page.get_by_text(re.compile("as_high is a Level target now")).first).to_be_visible()
    path = program.home / "onika" / "dict" / "as_high.onk"
    assert "Level object" in path.read_text()
    page.locator("body").press("Control+z")
    page.get_by_role("button", name="Applications", exact=True).click()
    expect(page.locator("#onikon-as_high")).to_have_count(0)
    assert not path.exists()
    page.get_by_role("button", name="Tasks", exact=True).click()


def test_a_row_of_the_table_offers_it_too(me):  # R-C30
    page = me.page
    page.get_by_role("tab", name=re.compile("^Variables")).click()
    me.strip.locator("tr", has_text="WAVE").click(button="right")
    page.get_by_role("menuitem", name="Make a target of it…").click()
    panel = page.get_by_role("dialog", name="New target")
    expect(panel.get_by_label("Name", exact=True)).to_have_value("wave")
    panel.get_by_role("button", name="Cancel").click()


def test_a_new_module_is_written_loaded_when_saved_and_its_fault_stands_beside_its_line(me, program):  # R-C31, R-C05
    page = me.page
    page.locator("body").press("Alt+m")
    panel = page.get_by_role("dialog", name="New module")
    panel.get_by_label("Name").fill("wave")
    panel.get_by_role("button", name="Make it").click()
    expect(panel.get_by_role("alert")).to_contain_text("there is a wave")
    panel.get_by_label("Name").fill("low_pass")
    panel.get_by_role("button", name="Make it").click()
    source = page.get_by_role("dialog", name="Source of low_pass")
    field = source.get_by_role("textbox")
    expect(field).to_have_value(re.compile("class LowPass"))
    expect(me.icon("low_pass")).to_be_visible()
    text = field.input_value()
    field.fill(text.replace("class LowPass(Module):", "MISSING = nowhere\n\n\nclass LowPass(Module):"))
    field.press("Control+s")
    fault = source.get_by_role("button", name=re.compile("nowhere"))
    expect(fault).to_be_visible(timeout=30_000)
    number = text.split("class LowPass")[0].count("\n") + 1
    expect(fault).to_contain_text(str(number))
    field.fill(text)
    field.press("Control+s")
    expect(source.get_by_role("status")).to_have_text("saved and loaded", timeout=30_000)
    source.get_by_role("button", name="Test", exact=True).click()
    test = page.get_by_role("textbox", name=re.compile("test_low_pass.py"))
    expect(test).to_have_value(re.compile("def test_low_pass"))
    page.keyboard.press("Escape")
    page.keyboard.press("Escape")
    assert (program.home / "onika" / "tests" / "test_low_pass.py").is_file()


def test_code_that_another_editor_breaks_stands_in_problems_and_leads_to_its_line(me, lab):  # R-C05, R-C31
    code = lab.path / "module" / "wave.py"
    before = code.read_text()
    code.write_text(before.replace("def cycle(self):", "def cycle(self)"))
    line = before.split("def cycle")[0].count("\n") + 1
    me.strip.get_by_role("tab", name=re.compile("^Problems [1-9]")).click()
    told = re.compile(f"the code of wave has an error: .*wave.py, line {line}: expected")
    problem = me.strip.get_by_role("button", name=told)
    problem.click()
    source = me.page.get_by_role("dialog", name="Source of wave")
    field = source.get_by_role("textbox")
    selected = "field => field.value.slice(field.selectionStart, field.selectionEnd)"
    expect(field).to_be_focused()
    assert field.evaluate(selected).strip() == "def cycle(self)"
    field.fill(before)
    field.press("Control+s")
    expect(problem).to_have_count(0)
    me.page.keyboard.press("Escape")
    me.strip.get_by_role("tab", name="Tasks 1").click()


def test_tasks_are_arranged_by_dragging_and_stay_so(me, lab):  # R-D24
    page = me.page
    me.libraries("bench")
    first, last = (me.page.locator(".library [id^=library-]").nth(k).get_attribute("id") for k in (0, 2))
    box = page.locator(f"#{first}").bounding_box()
    page.locator(f"#{last}").hover()
    page.mouse.down()
    page.mouse.move(box["x"] + 40, box["y"] + 20)
    page.mouse.move(box["x"] + 6, box["y"] + 12)
    page.mouse.up()
    expect(page.locator(".library [id^=library-]").first).to_have_id(last)
    path = lab.path / "module" / "OnikaArrangement.dta"
    assert path.read_text().split()[3] == last.removeprefix("library-")
    page.reload()
    expect(page.locator(".library [id^=library-]").first).to_have_id(last)
    page.locator("body").press("Control+z")
    expect(page.locator(".library [id^=library-]").first).to_have_id(first)
    expect(page.locator(f"#{first}")).to_be_visible()
    assert not path.exists()


def test_one_click_switches_between_configurations_that_live(program, page, people):  # R-C32
    person = people(program.enter(page))
    page.locator("body").press("Control+o")
    panel = page.get_by_role("dialog", name="Open a configuration")
    panel.get_by_role("searchbox").fill("pairC")
    panel.get_by_role("button", name="Open pairC", exact=True).click()
    expect(page.get_by_role("application", name="canvas of pairC")).to_be_visible()
    page.locator("body").press("Alt+c")
    page.get_by_role("dialog", name="Connect pairC").get_by_role("button", name="Connect", exact=True).click()
    person.state("calm", "OFF")
    person.box("wave").focus()  # beneath calm
    page.keyboard.press("Shift+Enter")
    person.state("wave", "ON")
    page.locator("body").press("Control+o")
    panel.get_by_role("searchbox").fill("otherC")
    panel.get_by_role("button", name="Keep alive: otherC").click()
    kept = page.get_by_role("group", name="Kept alive")
    expect(kept.get_by_role("button", name="pairC", exact=True)).to_have_attribute("aria-pressed", "true")
    kept.get_by_role("button", name="otherC", exact=True).click()
    person.state("tone", "ON")
    person.state("calm", "ON")
    expect(person.canvas.locator("[data-task=wave]")).to_have_count(0)
    kept.get_by_role("button", name="pairC", exact=True).click()
    person.state("wave", "ON")
    kept.get_by_role("button", name="Keep otherC alive no more").click()
    expect(kept).to_have_count(0)
    person.canvas.evaluate("one => one.focus()")
    page.keyboard.press("Control+a")
    page.keyboard.press("Delete")
    expect(person.canvas.locator("[data-task]")).to_have_count(0)
