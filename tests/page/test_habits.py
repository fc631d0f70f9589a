"""What a person may have otherwise: preferences, buttons, languages, grounds, sounds."""

import base64
import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


def preferences(me):
    me.page.keyboard.press("Control+,")
    panel = me.page.get_by_role("dialog", name=re.compile("Preferences|Preferencias"))
    expect(panel).to_be_visible()
    return panel


def test_preferences_of_icons_take_effect_at_once_and_nonsense_is_refused(me):  # R-G01, R-B12
    me.place("wave")
    panel = preferences(me)
    panel.get_by_label("Show periods instead of frequencies").check()
    expect(me.canvas.locator("[data-task=wave]")).to_contain_text("50 ms")
    panel.get_by_label("Show periods instead of frequencies").uncheck()
    expect(me.canvas.locator("[data-task=wave]")).to_contain_text("20 Hz")
    height = me.canvas.locator("[data-task=wave] rect").first.bounding_box()["height"]
    field = panel.get_by_label("Least height of an icon")
    before = field.input_value()
    field.fill("150")
    field.press("Enter")
    me.page.wait_for_function(
        "h => document.querySelector('[data-task=wave] rect').getBoundingClientRect().height > h + 20", arg=height
    )
    field.fill("tall")
    field.press("Enter")
    expect(panel.get_by_role("alert")).to_be_visible()
    field.fill(before)
    field.press("Enter")
    expect(panel.get_by_role("alert")).to_have_count(0)


def test_which_connections_are_drawn_is_a_preference(me):  # R-G01
    me.place("wave", "calm")
    expect(me.canvas.locator("[data-net=WAVE]")).to_have_count(1)
    panel = preferences(me)
    panel.get_by_label("Show lines to variable inputs").uncheck()
    panel.get_by_label("Show lines from variable outputs").uncheck()
    expect(me.canvas.locator("[data-net=WAVE]")).to_have_count(0)
    panel.get_by_label("Show lines to variable inputs").check()
    panel.get_by_label("Show lines from variable outputs").check()
    expect(me.canvas.locator("[data-net=WAVE]")).to_have_count(1)


def test_preferences_are_written_to_the_users_file_when_they_are_changed_or_at_the_end(begin, lab, page, people):
    # R-B12, R-G01
    program = begin(f"--base={lab.path}", "--no-connect")
    me = people(program.enter(page))
    preferences(me).get_by_label("Show periods instead of frequencies").check()
    expect(me.page.get_by_label("Show periods instead of frequencies")).to_be_checked()
    page.goto("about:blank")
    program.end()
    assert any(path.is_file() for path in program.home.iterdir()), "a file of preferences is in the home directory"
    again = begin(f"--base={lab.path}", "--no-connect", folder=program.home.parent)
    me = people(again.enter(page))
    expect(preferences(me).get_by_label("Show periods instead of frequencies")).to_be_checked()


def test_panels_stand_as_they_were_shaped_also_in_another_browser(me, program, new_page):  # R-G01
    border = me.page.get_by_role("separator", name="Width of the library")
    width = int(border.get_attribute("aria-valuenow"))
    border.focus()
    for _ in range(4):
        me.page.keyboard.press("ArrowRight")
    expect(border).to_have_attribute("aria-valuenow", str(width + 64))
    for _ in range(10):  # it is kept as soon as nobody shapes it any more
        other = program.enter(new_page()).get_by_role("separator", name="Width of the library")
        if other.get_attribute("aria-valuenow") == str(width + 64):
            break
    expect(other).to_have_attribute("aria-valuenow", str(width + 64))
    border.press("Enter")


def test_the_bar_the_buttons_and_the_variables_stand_where_somebody_wants_them(me, program, new_page):  # R-G01
    panel = preferences(me)
    panel.get_by_label("The bar with Stop").select_option("Below everything")
    panel.get_by_label("Variables", exact=True).select_option("Beside the tasks, where there is room")
    panel.get_by_label("My buttons").select_option("In a line beneath everything")
    bar = me.page.get_by_role("banner")
    assert bar.bounding_box()["y"] > me.strip.bounding_box()["y"] > 100
    assert me.page.get_by_role("complementary", name="Task library").bounding_box()["y"] == 0
    expect(me.strip.get_by_role("tab", name=re.compile("^Variables"))).to_have_count(0)
    expect(me.strip.get_by_role("searchbox", name="Find a variable")).to_be_visible()
    stop = bar.get_by_role("button", name=re.compile("^Stop")).bounding_box()
    assert panel.bounding_box()["y"] + panel.bounding_box()["height"] <= stop["y"], "no panel covers Stop"
    for _ in range(10):  # it is kept as soon as nobody chooses any more
        other = program.enter(new_page())
        if other.get_by_role("banner").bounding_box()["y"] > 100:
            break
    assert other.get_by_role("banner").bounding_box()["y"] > 100
    for label, usual in (
        ("The bar with Stop", "Above everything"),
        ("Variables", "In turn with the tasks"),
        ("My buttons", "At the foot of the left column"),
    ):
        panel.get_by_label(label, exact=True).select_option(usual)
    assert bar.bounding_box()["y"] == 0
    expect(me.strip.get_by_role("tab", name=re.compile("^Variables"))).to_be_visible()


def test_warnings_are_switched_off_and_on_again(me):  # R-C08
    me.place("calm")
    expect(me.strip.get_by_role("tab", name="Problems 1")).to_be_visible()
    me.strip.get_by_role("tab", name="Problems 1").click()
    me.strip.get_by_label("Show warnings").uncheck()
    expect(me.strip.get_by_role("tab", name="Problems 0")).to_be_visible()
    me.strip.get_by_label("Show warnings").check()
    expect(me.strip.get_by_role("tab", name="Problems 1")).to_be_visible()


def test_a_button_of_ones_own_runs_a_command_and_shows_what_it_says(me):  # R-G02
    me.page.keyboard.press("Control+k")
    me.page.get_by_role("combobox").fill("My buttons")
    me.page.keyboard.press("Enter")
    panel = me.page.get_by_role("dialog", name="My buttons")
    panel.get_by_role("button", name="Add a button").click()
    panel.get_by_label("Name").fill("greet")
    panel.get_by_label("Command").fill("echo good morning && exit 3")
    panel.get_by_role("button", name="Save").click()
    bar = me.page.get_by_role("region", name="My buttons")
    bar.get_by_role("button", name="greet").click()
    expect(panel.get_by_label("What greet says")).to_contain_text("good morning")
    expect(panel).to_contain_text("failed with code 3")
    panel.get_by_role("button", name="Change greet").click()
    panel.get_by_label("Command").fill("sleep 600")
    panel.get_by_role("button", name="Save").click()
    bar.get_by_role("button", name="greet").click()
    panel.get_by_role("button", name="Halt greet").click()
    expect(panel.get_by_role("button", name="Halt greet")).to_have_count(0)
    panel.get_by_role("button", name="Remove greet").click()
    expect(bar).to_have_count(0)


def test_everything_is_in_spanish_on_wish_and_stays_so(me):  # R-G03
    panel = preferences(me)
    panel.get_by_label("Language").select_option("es")
    expect(me.page.locator("html")).to_have_attribute("lang", "es")
    expect(me.page.get_by_role("complementary", name="Biblioteca de tareas")).to_be_visible()
    english = re.compile(r"\b(the|and|of|with|not|Find|Open|Save|Tasks|Columns|Refresh|Nothing)\b")
    me.page.keyboard.press("Escape")
    shown = me.page.locator("body").inner_text()
    assert not english.search(shown), english.findall(shown)
    me.page.reload()
    expect(me.page.get_by_role("complementary", name="Biblioteca de tareas")).to_be_visible()


def ground(me):
    return me.page.evaluate("getComputedStyle(document.body).backgroundColor")


def test_dark_and_light_follow_the_system_or_a_persons_wish(me):  # R-G01
    light = ground(me)
    me.page.emulate_media(color_scheme="dark")
    dark = ground(me)
    assert dark != light
    me.page.emulate_media(color_scheme="light")
    panel = preferences(me)
    panel.get_by_label("Look").select_option("dark")
    assert ground(me) == dark
    me.page.reload()
    expect(me.canvas).to_be_visible()
    assert ground(me) == dark


def test_the_colours_of_1994_are_the_dissertations(me):  # R-C02, R-C25
    me.place("wave", "calm")
    line = me.canvas.locator("[data-net=WAVE]")
    before = line.evaluate("one => getComputedStyle(one).stroke")
    preferences(me).get_by_label("Look").select_option("1994")
    after = line.evaluate("one => getComputedStyle(one).stroke")
    assert after != before
    red, green, blue = map(int, re.findall(r"\d+", after)[:3])
    assert blue > max(red, green), "an idle line is blue"


COLOURED = """async shown => {
    const picture = new Image()
    picture.src = 'data:image/png;base64,' + shown
    await picture.decode()
    const paper = new OffscreenCanvas(picture.width, picture.height).getContext('2d')
    paper.drawImage(picture, 0, 0)
    const { data } = paper.getImageData(0, 0, picture.width, picture.height)
    let coloured = 0
    for (let k = 0; k < data.length; k += 4) {
        const dots = [data[k], data[k + 1], data[k + 2]]
        if (Math.max(...dots) - Math.min(...dots) > 3) coloured += 1
    }
    return coloured
}"""
"""How many dots of a screenshot have a hue."""


def coloured_dots(me):
    return me.page.evaluate(COLOURED, base64.b64encode(me.page.screenshot()).decode())


def test_the_monochrome_look_has_no_colour_and_what_is_greyed_a_broken_line(me):  # R-G09
    me.place("wave", "calm")
    assert coloured_dots(me) > 0
    panel = preferences(me)
    panel.get_by_label("Look").select_option("Monochrome")
    me.page.keyboard.press("Escape")
    expect(panel).to_have_count(0)
    assert coloured_dots(me) == 0
    broken = "one => getComputedStyle(one).strokeDasharray"
    assert me.icon("wave").locator(".frame").evaluate(broken) != "none"  # it is placed already
    assert me.icon("gain").locator(".frame").evaluate(broken) == "none"


def test_sounds_can_be_switched_off(me):  # R-G06
    panel = preferences(me)
    sounds = panel.get_by_label("Sounds for success, error and end")
    was = sounds.is_checked()
    sounds.set_checked(not was)
    me.page.reload()
    expect(preferences(me).get_by_label("Sounds for success, error and end")).to_be_checked(checked=not was)


def test_pins_differ_by_shape_and_not_by_colour_alone(me):  # R-C02
    me.place("gain", "calm")

    def outlines(task):
        drawn = me.canvas.locator(f"[data-task={task}]").locator("path, circle, rect")
        return drawn.evaluate_all("all => all.map((one) => one.tagName + (one.getAttribute('d') ?? ''))")

    assert outlines("gain") != outlines("calm")


def test_what_a_person_did_stands_in_the_diary(program, me):  # R-H01
    me.place("wave")
    me.box("wave").click()
    me.page.keyboard.press("r")
    expect(me.page.get_by_role("button", name="Undo: flipping wave")).to_be_enabled()
    files = [path for path in program.state.rglob("*") if path.is_file() and "diary" in str(path)]
    text = "".join(path.read_text() for path in files)
    for event in ("insert_icon", "flip_icon", "wave"):
        assert event in text
