"""The canvas under the mouse: every row of table B.2, and what is usual today beside it."""

import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


def picked(me, task, is_picked=True):
    expect(me.box(task)).to_have_attribute("aria-pressed", "true" if is_picked else "false")


# -- table B.2: the left button


def test_left_on_a_task_selects_it_alone_and_on_nothing_lets_go(me):  # R-G04, table B.2
    me.place("wave", "calm")
    me.box("wave").click()
    picked(me, "wave")
    picked(me, "calm", False)
    me.page.mouse.click(*me.at(500, 420))
    picked(me, "wave", False)


def test_left_drags_a_task_and_its_lines_follow_while_its_locus_stays(me):  # R-C10, R-C24, table B.2
    me.place("wave", "calm")
    locus, line = me.spot("WAVE"), me.canvas.locator("[data-net=WAVE]").get_attribute("d")
    me.drag(me.box("wave"), 200, 350)
    me.stands("wave", 132, 337)
    expect(me.canvas.locator("[data-net=WAVE]")).not_to_have_attribute("d", line)
    assert me.spot("WAVE") == locus


def test_a_drag_given_up_by_escape_leaves_the_task_where_it_was(me):  # R-G04
    me.place("wave")
    before = me.corner("wave")
    box = me.box("wave").bounding_box()
    me.page.mouse.move(box["x"] + 50, box["y"] + 15)
    me.page.mouse.down()
    me.page.mouse.move(*me.at(500, 400), steps=5)
    assert me.corner("wave") != before
    me.page.keyboard.press("Escape")
    me.page.mouse.up()
    me.stands("wave", *before)
    assert me.corner("wave") == before
    expect(me.page.get_by_role("button", name="Undo: placing wave")).to_be_enabled()


def test_left_drags_a_locus(me):  # R-C09, table B.2
    me.place("wave", "calm")
    me.drag(me.dot("WAVE"), 260, 320)
    expect(me.page.get_by_role("button", name="Undo: moving WAVE")).to_be_enabled()
    x, y = me.spot("WAVE")
    assert abs(x - 260) <= 10 and abs(y - 320) <= 10


def test_shift_left_on_a_locus_hides_its_connections_and_shows_them_again(me):  # R-C09, table B.2
    me.place("wave", "calm")
    grip = me.dot("WAVE")
    grip.click(modifiers=["Shift"])
    expect(me.canvas.get_by_role("button", name="locus WAVE, lines hidden")).to_be_visible()
    grip.click(modifiers=["Shift"])
    expect(me.canvas.get_by_role("button", name="locus WAVE, idle")).to_be_visible()


def test_shift_left_on_a_task_that_lives_nowhere_says_why_and_offers_to_connect(me):  # R-C11, R-X01, table B.2
    me.place("wave")
    me.box("wave").click(modifiers=["Shift"])
    expect(me.refusal).to_contain_text("not connected")
    expect(me.refusal.get_by_role("button", name="Connect")).to_be_visible()
    me.page.keyboard.press("Escape")
    expect(me.refusal).to_have_count(0)


# -- table B.2: the middle button


def test_middle_on_a_task_shows_its_parameters(me):  # table B.2
    me.place("wave")
    me.page.mouse.click(*me.at(500, 420))
    me.box("wave").click(button="middle")
    expect(me.sheet.get_by_role("heading", name="wave")).to_be_visible()


def test_middle_on_a_locus_tells_its_writers_and_readers(me):  # R-C09, table B.2
    me.place("wave", "calm")
    me.dot("WAVE").click(button="middle")
    card = me.page.get_by_role("dialog", name="locus WAVE")
    expect(card).to_contain_text(re.compile("written by\\s*wave\\s*read by\\s*calm"))
    card.get_by_role("button", name="calm").click()
    expect(me.sheet.get_by_role("heading", name="calm")).to_be_visible()


def test_shift_middle_on_a_task_shows_its_source(me):  # R-C05, table B.2
    me.place("wave")
    me.box("wave").click(button="middle", modifiers=["Shift"])
    expect(me.page.get_by_role("dialog", name="Source of wave").get_by_role("textbox")).to_have_value(
        re.compile("np.sin")
    )


def test_shift_middle_elsewhere_checks_the_configuration(me):  # R-C08, R-C26, table B.2
    me.place("calm")
    me.page.mouse.move(*me.at(600, 420))
    me.page.keyboard.down("Shift")
    me.page.mouse.click(*me.at(600, 420), button="middle")
    me.page.keyboard.up("Shift")
    expect(me.strip.get_by_role("tab", name="Problems 1")).to_have_attribute("aria-selected", "true")
    expect(me.strip).to_contain_text(re.compile("WAVE"))


def test_ctrl_middle_on_a_task_shows_its_rmod(me):  # R-C05, table B.2
    me.place("wave")
    me.box("wave").click(button="middle", modifiers=["Control"])
    expect(me.page.get_by_role("dialog", name="wave.rmod").get_by_role("textbox")).to_have_value(re.compile("MODULE"))


# -- table B.2: the right button


def test_right_places_the_task_that_is_selected_in_the_library(me):  # R-C06, table B.2
    me.icon("wave").click()
    me.page.mouse.click(*me.at(300, 200), button="right")
    me.stands("wave", 300, 200)
    me.page.mouse.click(*me.at(300, 400), button="right")
    expect(me.page.get_by_role("menu", name="Canvas")).to_be_visible()


def test_right_with_nothing_selected_opens_the_menu_of_what_is_there(me):  # R-G04, table B.2
    me.place("wave")
    me.page.keyboard.press("Escape")
    me.box("wave").click(button="right")
    menu = me.page.get_by_role("menu", name="wave")
    for label in ("Parameters", "Source", "Cut", "Copy", "Turn the flow of data", "Remove"):
        expect(menu.get_by_role("menuitem", name=label)).to_be_visible()
    menu.get_by_role("menuitem", name="Remove").click()
    expect(me.box("wave")).to_have_count(0)


def test_the_menu_of_a_locus_pins_plots_and_hides(me):  # R-C09, R-G04
    me.place("wave", "calm")
    grip = me.dot("WAVE")
    grip.click(button="right")
    me.page.get_by_role("menuitem", name="Pin the live value here").click()
    expect(me.page.get_by_role("group", name="live value of WAVE")).to_be_visible()
    grip.click(button="right", timeout=5_000)
    me.page.get_by_role("menuitem", name="Hide its lines").click()
    expect(me.canvas.get_by_role("button", name="locus WAVE, lines hidden")).to_be_visible()
    me.page.get_by_role("button", name="Take the value of WAVE off the canvas").click()
    expect(me.page.get_by_role("group", name="live value of WAVE")).to_have_count(0)


# -- table B.2: keys


@pytest.mark.parametrize("key", ["Delete", "Backspace", "Control+x"])
def test_delete_and_its_kin_cut_what_is_selected(me, key):  # R-C10, R-C22, table B.2
    me.place("wave", "calm")
    me.box("calm").press(key)
    expect(me.box("calm")).to_have_count(0)
    me.page.mouse.move(*me.at(500, 400))
    me.page.keyboard.press("v")
    expect(me.box("calm")).to_be_visible()


@pytest.mark.parametrize("key", ["c", "Control+c"])
def test_copied_tasks_are_pasted_into_another_configuration(me, key):  # R-C10, R-C22, table B.2
    me.place("wave", "calm")
    me.page.keyboard.press("Control+a")
    me.page.keyboard.press(key)
    expect(me.box("wave")).to_be_visible()
    me.blank()
    me.page.mouse.move(*me.at(300, 300))
    me.page.keyboard.press("v")
    expect(me.box("wave")).to_be_visible()
    expect(me.locus("WAVE")).to_be_visible()
    (wave_x, wave_y), (calm_x, calm_y) = me.corner("wave"), me.corner("calm")
    assert calm_x - wave_x == 230 and calm_y == wave_y


def test_what_may_not_be_pasted_is_refused_with_the_reason(me):  # R-C22, R-X01
    me.place("wave")
    me.box("wave").press("c")
    me.page.mouse.move(*me.at(500, 400))
    me.page.keyboard.press("v")
    expect(me.refusal).to_contain_text("wave is placed already")


def test_text_that_was_copied_elsewhere_is_pasted_as_tasks(me, chromium):  # R-C10, R-G04
    me.page.context.grant_permissions(["clipboard-read", "clipboard-write"])
    me.place("wave", "calm")
    me.page.keyboard.press("Control+a")
    me.page.keyboard.press("Control+c")
    me.page.wait_for_function("async () => (await navigator.clipboard.readText()).includes('calm')")
    me.blank()
    me.page.mouse.move(*me.at(300, 300))
    me.page.keyboard.press("Control+v")
    expect(me.box("calm")).to_be_visible()


def test_r_flips_and_a_locus_of_one_task_goes_to_the_other_side(me):  # R-C10, R-C24, table B.2
    me.place("wave")
    pin = me.canvas.locator("[data-task=wave]").get_by_text("WAVE", exact=True)
    expect(pin).to_have_attribute("text-anchor", "end")
    assert me.spot("WAVE")[0] > me.corner("wave")[0] + 136
    me.box("wave").press("r")
    expect(pin).to_have_attribute("text-anchor", "start")
    assert me.spot("WAVE")[0] < me.corner("wave")[0]


# -- today's habits


def test_double_click_on_nothing_finds_a_task_and_enter_places_it(me):  # R-G04, R-C06
    me.page.mouse.dblclick(*me.at(400, 200))
    quick = me.page.get_by_role("combobox", name="Find a task and place it")
    quick.fill("wav")
    expect(me.page.get_by_role("option").first).to_contain_text("wave")
    quick.press("Enter")
    me.stands("wave", 400, 200)


def test_quick_add_is_ordered_by_what_may_go_here_and_says_what_would_connect(me):  # R-C07, R-X01
    me.place("wave")
    me.box("wave").press("/")
    quick = me.page.get_by_role("combobox", name="Find a task and place it")
    quick.fill("calm")
    expect(me.page.get_by_role("option", name="calm")).to_contain_text("reads WAVE of wave, writes CALM")
    quick.fill("tone")
    expect(me.page.get_by_role("option", name="tone")).to_have_attribute("aria-disabled", "true")
    quick.press("Enter")
    expect(me.refusal).to_contain_text("writes WAVE, which wave already writes")
    me.refusal.get_by_role("button", name="Replace wave").click()
    expect(me.box("tone")).to_be_visible()


def test_double_click_on_a_task_shows_its_parameters(me):  # R-G04
    me.place("wave")
    me.page.mouse.click(*me.at(500, 420))
    me.box("wave").dblclick()
    expect(me.sheet.get_by_role("heading", name="wave")).to_be_visible()


def test_a_marquee_and_ctrl_clicks_select_several_which_move_as_one_step(me):  # R-C10, R-G04
    me.place("wave", "calm", "show")
    me.page.mouse.move(*me.at(40, 60))
    me.page.mouse.down()
    me.page.mouse.move(*me.at(450, 250), steps=6)
    me.page.mouse.up()
    picked(me, "wave")
    picked(me, "calm")
    picked(me, "show", False)
    me.box("show").click(modifiers=["Control"])
    picked(me, "show")
    me.box("wave").click(modifiers=["Control"])
    picked(me, "wave", False)
    before = me.corner("wave"), me.corner("calm"), me.corner("show")
    me.drag(me.box("show"), 700, 380)
    expect(me.page.get_by_role("button", name=re.compile("Undo: moving (calm|show) and"))).to_be_enabled()
    assert me.corner("wave") == before[0]
    dy = me.corner("show")[1] - before[2][1]
    assert dy > 200 and me.corner("calm")[1] - before[1][1] == dy
    me.page.keyboard.press("Control+z")
    me.stands("show", *before[2])
    assert me.corner("calm") == before[1]


def test_several_tasks_are_aligned_and_spread_by_the_menu(me):  # R-G04
    me.place("wave", "calm", "show")
    me.drag(me.box("calm"), 380, 300)
    me.page.keyboard.press("Control+a")
    me.box("calm").click(button="right")
    me.page.get_by_role("menuitem", name="Align upper sides").click()
    me.stands("calm", me.corner("calm")[0], me.corner("wave")[1])
    me.box("calm").click(button="right")
    me.page.get_by_role("menuitem", name="Equal distances across").click()
    expect(me.page.get_by_role("button", name=re.compile("Undo: aligning"))).to_be_enabled()
    xs = sorted(me.corner(task)[0] for task in ("wave", "calm", "show"))
    assert abs((xs[1] - xs[0]) - (xs[2] - xs[1])) <= 5


def test_two_fingers_zoom_and_one_moves_the_paper(me):  # R-G04
    me.place("wave")
    session = me.page.context.new_cdp_session(me.page)
    (x, y), level = me.at(400, 300), me.page.get_by_role("toolbar", name="View").get_by_text("100 %")

    def touch(kind, *points):
        touches = [{"x": x + dx, "y": y + dy, "id": k} for k, (dx, dy) in enumerate(points)]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": touches})

    touch("touchStart", (-40, 0), (40, 0))
    for spread in (60, 80, 100):
        touch("touchMove", (-spread, 0), (spread, 0))
    touch("touchEnd")
    expect(level).to_have_count(0)
    before = me.box("wave").bounding_box()
    touch("touchStart", (0, 0))
    for far in (20, 60, 100):
        touch("touchMove", (far, 0))
    touch("touchEnd")
    assert me.box("wave").bounding_box()["x"] > before["x"] + 60


# -- connections


def test_tasks_connect_by_themselves_and_the_locus_goes_with_its_last_task(me):  # R-C09, R-C24
    me.place("wave")
    expect(me.locus("WAVE")).to_be_visible()
    alone = me.spot("WAVE")
    assert 136 < alone[0] - me.corner("wave")[0] < 180
    me.place("calm")
    expect(me.locus("CALM")).to_be_visible()
    assert abs(me.spot("WAVE")[0] - (me.corner("wave")[0] + 136 + me.corner("calm")[0]) / 2) < 30
    me.remove("calm")
    expect(me.locus("CALM")).to_have_count(0)
    assert me.spot("WAVE") == alone
    me.remove("wave")
    expect(me.locus("WAVE")).to_have_count(0)


def test_lines_of_constants_are_hidden_at_first_and_their_loci_stand_in_a_row(me):  # R-C09
    me.place("gain", "needs")
    row = me.page.get_by_role("group", name="constants")
    expect(row.get_by_role("button", name="locus GAIN, lines hidden")).to_be_visible()
    row.get_by_role("button", name="locus GAIN, lines hidden").click()
    expect(me.locus("GAIN")).to_be_visible()
    expect(me.canvas.get_by_role("button", name="locus GAIN, idle")).to_be_visible()


def test_no_line_goes_through_a_box(me):  # R-C09
    me.place("wave", "aim", "calm")
    through = me.page.evaluate("""() => {
      const boxes = [...document.querySelectorAll('[data-task] rect.box')].map((one) => one.getBoundingClientRect())
      const within = (v, from, to) => v > from + 4 && v < to - 4
      const hits = (p) => boxes.some((b) => within(p.x, b.left, b.right) && within(p.y, b.top, b.bottom))
      const lines = [...document.querySelectorAll('path[data-net="WAVE"]')]
      let points = 0, wrong = 0
      for (const line of lines) for (let s = 0; s <= line.getTotalLength(); s += 3, points++)
        if (hits(line.getPointAtLength(s).matrixTransform(line.getScreenCTM()))) wrong++
      return [points, wrong]
    }""")
    assert through[0] > 50 and through[1] == 0


def test_the_pointer_on_a_locus_tells_its_users_and_lights_its_lines(me):  # R-C09
    me.place("wave", "calm")
    me.page.mouse.click(*me.at(500, 420))
    me.dot("WAVE").hover()
    expect(me.page.get_by_role("tooltip", name="locus WAVE")).to_contain_text("no value: not connected")
