"""The simulated arm from the page: an example of one click that is switched on, asked where to, and moves."""

import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page

TASKS = ("gravcomp", "diff", "torque_sum", "pd", "led_monitor")


@pytest.fixture
def program(begin):
    """The environment as a newcomer starts it."""
    return begin()


def test_the_first_start_teaches_and_an_example_runs_by_a_click_and_an_answer(program, page, people):
    # R-C11, R-C13, R-C14, R-C21
    me = people(program.enter(page))
    expect(me.tab("Untitled-1")).to_be_visible()
    expect(page.get_by_role("heading", name="Put tasks together.")).to_be_visible()
    expect(page.get_by_role("button", name="Stop")).to_be_visible()
    page.get_by_role("button", name=re.compile(r"^jmoveC \d+ tasks")).click()
    expect(me.tab("jmoveC")).to_be_visible()
    expect(me.tab("Untitled-1")).to_have_count(0)
    me.state("puma", "OFF")
    page.keyboard.press("Escape")
    for task in ("puma", *TASKS):
        me.box(task).click(modifiers=["Shift"])
        if me.refusal.count():
            me.refusal.get_by_role("button").last.click()
        me.state(task, "ON")
    expect(me.canvas.get_by_role("button", name="locus Q_MEZ, live")).to_be_visible()

    me.strip.get_by_role("tab", name=re.compile("^Variables")).click()
    me.strip.get_by_role("searchbox", name="Find a variable").fill("Q_MEZ")
    measured = me.strip.get_by_role("row", name=re.compile("Q_MEZ double")).get_by_role("gridcell").nth(2)
    expect(measured).to_contain_text(re.compile(r"\d"))
    before = measured.inner_text()

    me.box("jtraj").click(modifiers=["Shift"])
    if me.refusal.count():
        me.refusal.get_by_role("button").last.click()
    me.state("jtraj", "ASKING")
    form = page.get_by_role("dialog", name=re.compile("jtraj asks"))
    fields = form.get_by_role("textbox")
    for k in range(7):
        fields.nth(k).fill("9" if k == 0 else "0.2" if k < 6 else "1")
    expect(form).to_contain_text(re.compile("9 is above 2.79"))
    fields.nth(0).fill("0.5")
    form.get_by_role("button", name="Send").click()
    me.state("jtraj", "ON")
    expect(measured).not_to_have_text(before)
    expect(me.canvas.get_by_role("button", name=re.compile("^jtraj, OFF"))).to_be_visible(timeout=20_000)
    expect(measured).to_contain_text(re.compile(r"0\.5|0\.49"))
    page.get_by_role("button", name="Workcell boxes").click()
    world = page.get_by_role("application", name=re.compile("^The workcell in three dimensions"))
    expect(world.locator("canvas")).to_be_visible()
    expect(world).not_to_contain_text(re.compile("cannot draw"))
    scene = world.locator("canvas")
    for _ in range(20):
        drawn = scene.screenshot()
        if len(drawn) > 4_000:
            break
    assert len(drawn) > 4_000, "the workcell is drawn"
    stopped(me)


@pytest.mark.slow
def test_the_present_position_of_the_arm_is_taken_by_one_click_and_nothing_is_left(program, page):  # R-D23, R-G03
    program.enter(page)
    page.get_by_role("button", name="Applications", exact=True).click()
    page.locator("body").press("Alt+n")
    page.get_by_role("dialog", name="New application").get_by_role("button", name="Begin", exact=True).click()
    page.locator("#onikon-jmoveC").dblclick()
    steps = page.get_by_role("region", name="Workspace").locator("[data-step]")
    expect(steps).to_have_count(4)
    page.get_by_role("button", name="Take the arm’s present position").click()
    panel = page.get_by_role("dialog", name="New target")
    expect(panel).to_contain_text("where puma stands now", timeout=30_000)
    values = panel.locator("input[id*='-value-']")  # the joints, and the duration, which nobody measures
    for k in range(6):
        expect(values.nth(k)).not_to_have_value("")
    panel.get_by_role("button", name="Cancel").click()
    expect(page.get_by_role("button", name=re.compile("^Take position"))).to_be_visible()


def test_a_place_clicked_in_the_workcell_becomes_a_pose_before_it_that_points_into_it(program, page):  # R-D25
    program.enter(page)
    page.get_by_role("button", name="Applications", exact=True).click()
    page.locator("body").press("Alt+n")
    page.get_by_role("dialog", name="New application").get_by_role("button", name="Begin", exact=True).click()
    page.locator("#onikon-cmoveC").dblclick()
    expect(page.get_by_role("region", name="Workspace").locator("[data-step]")).to_have_count(4)
    page.get_by_role("button", name="Take the arm’s present position").click()
    panel = page.get_by_role("dialog", name="New target")
    expect(panel).to_contain_text("where puma stands now", timeout=30_000)
    values = panel.locator("input[id*='-value-']")
    before = [values.nth(k).input_value() for k in range(9)]
    panel.get_by_role("button", name="Click a place…").click()
    world = page.get_by_role("application", name=re.compile("^The workcell in three dimensions"))
    expect(world).to_contain_text("Click where the tool shall go.")
    page.set_viewport_size({"width": 900, "height": 700})
    panel.get_by_role("button", name="Click a place…").click()
    panel.get_by_role("button", name="Click a place…").click()  # off and on: the panel leaves the workcell free
    clear = panel.bounding_box()
    assert clear["x"] >= 0 and clear["x"] + clear["width"] <= world.bounding_box()["x"]
    room = world.locator("canvas").bounding_box()
    world.locator("canvas").click(position={"x": room["width"] * 0.56, "y": room["height"] * 0.7})
    expect(panel).to_contain_text("the place that was clicked, as puma reaches it", timeout=30_000)
    after = [values.nth(k).input_value() for k in range(9)]
    assert after != before
    assert [float(word) for word in after[:3]] == [0, 0, -1], "it points down into the table"
    height = float(after[8])
    panel.get_by_label("Away from its surface").fill("0.1")
    expect(values.nth(8)).not_to_have_value(after[8])
    assert float(values.nth(8).input_value()) == pytest.approx(height + 0.05)


def stopped(me):
    """Stop: every drive holds, the arm stands, and says so until it is reset."""
    me.page.get_by_role("button", name="Stop").click()
    expect(me.page.get_by_role("button", name="Reset", exact=True)).to_be_visible()
    expect(me.canvas.get_by_role("button", name=re.compile("^puma, (ERROR|OFF)"))).to_be_visible()
    me.page.get_by_role("button", name="Reset", exact=True).click()
    expect(me.page.get_by_role("button", name="Reset", exact=True)).to_have_count(0)
