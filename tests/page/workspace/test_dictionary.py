"""The dictionaries at the page: found, fitted, inserted, edited and made (table B.3)."""

import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


@pytest.fixture(scope="module")
def program(begin):
    """The environment with what is shipped, unconnected; what is made goes into its own home."""
    return begin("--no-connect")


class Reader:
    """Somebody at the upper level, with a blank application in front."""

    def __init__(self, page):
        self.page = page
        self.dictionary = page.get_by_role("complementary", name="Dictionary")
        self.workspace = page.get_by_role("region", name="Workspace")
        self.refusal = page.get_by_role("alertdialog", name="Refused")

    def icon(self, name):
        return self.page.locator(f"#onikon-{name}")

    def step(self, k):
        """What stands at a place behind the start icon, which is 0."""
        return self.workspace.locator("[data-step]").nth(k)

    def has_steps(self, count):
        """Wait until so many stand between start and end."""
        expect(self.workspace.locator("[data-step]")).to_have_count(count + 2)

    def panel(self, name):
        return self.page.get_by_role("dialog", name=name)

    def blank(self):
        self.page.locator("body").press("Alt+n")
        panel = self.panel("New application")
        panel.get_by_role("button", name="Begin", exact=True).click()
        expect(panel).to_have_count(0)


@pytest.fixture
def me(program, page):
    program.enter(page)
    page.get_by_role("button", name="Applications", exact=True).click()
    reader = Reader(page)
    expect(reader.icon("opengripC")).to_be_attached()
    reader.blank()
    return reader


def groups(me):
    return [text.strip() for text in me.dictionary.get_by_role("heading", level=2).all_inner_texts()]


def test_icons_stand_by_type_between_their_edges_with_words_beneath(me):  # R-D01, R-D02
    titles = [re.sub(r"\s+FIT.*", "", text.upper().replace("\n", " ")) for text in groups(me)]
    assert titles[:4] == ["COMPLETE JOBS", "COMPLETE APPLICATIONS", "NO-OPS", "JOINT TARGETS"]
    icon = me.icon("opengripC")
    expect(icon).to_have_text("open the hand")
    expect(icon.locator("path.band")).to_have_count(2)


def test_they_may_be_pictures_words_or_both(me):  # R-H04
    icon = me.icon("opengripC")
    me.dictionary.get_by_role("button", name="Pictures", exact=True).click()
    expect(icon).to_have_text("")
    expect(icon.locator("image")).to_have_count(1)
    me.dictionary.get_by_role("button", name="Words", exact=True).click()
    expect(icon).to_have_text("open the hand")
    expect(icon.locator("image")).to_have_count(0)
    expect(icon.locator("path.band")).to_have_count(0)
    me.dictionary.get_by_role("button", name="+ words", exact=True).click()


def test_one_dictionary_alone_or_all_together(me):  # R-D01
    tabs = me.dictionary.get_by_role("group", name="Dictionaries")
    tabs.get_by_role("button", name=re.compile(r"^puma \d")).click()
    expect(me.icon("home")).to_have_count(0)
    expect(me.icon("jmoveC")).to_be_attached()
    tabs.get_by_role("button", name=re.compile(r"^All \d")).click()
    expect(me.icon("home")).to_be_attached()


def test_a_search_finds_and_enter_inserts_what_fits_first(me):  # R-C03, R-D03
    page = me.page
    me.icon("jmoveC").dblclick()
    me.has_steps(2)
    page.keyboard.press("Control+f")
    page.keyboard.type("square")
    page.keyboard.press("Enter")
    me.has_steps(2)
    expect(me.workspace).to_contain_text("Complete")


def test_only_what_fits_at_the_marked_place(me):  # R-D03, R-D19
    me.icon("jmoveC").focus()
    me.page.keyboard.press("Enter")
    fits = me.dictionary.get_by_role("button", name="Fits here")
    fits.click()
    expect(me.icon("home")).to_be_visible()
    expect(me.icon("cmoveC")).to_have_count(0)
    assert groups(me)[0].upper().replace("\n", " ") == "JOINT TARGETS FIT THE HOLE"
    me.icon("home").dblclick()
    expect(me.icon("cmoveC")).to_be_attached()


def test_what_does_not_fit_is_refused_beside_the_pointer(me):  # R-D03, R-X01
    me.icon("jmoveC").dblclick()
    me.has_steps(2)
    me.dictionary.get_by_role("searchbox").fill("box")  # what fits is shown whole, whatever was searched for
    me.icon("box3_bx").dblclick()
    expect(me.refusal).to_contain_text("does not fit")
    me.refusal.get_by_role("button", name=re.compile("that fit$")).click()
    expect(me.icon("home")).to_be_visible()
    expect(me.icon("box3_bx")).to_have_count(0)


def test_an_open_dialog_keeps_every_key(me):  # R-G04
    keys = me.page.keyboard
    me.icon("opengripC").dblclick()
    me.has_steps(1)
    me.page.locator("body").press("Alt+t")
    panel = me.panel("New target")
    expect(panel.get_by_label("Name", exact=True)).to_be_focused()
    keys.type("my place")
    keys.press("Tab")  # the button that has come is no stop
    expect(panel.get_by_label("Words")).to_be_focused()
    panel.get_by_role("button", name=re.compile("my-place")).click()
    expect(panel.get_by_label("Name", exact=True)).to_be_focused()
    panel.get_by_role("button", name="Cancel").focus()
    for key in ("Delete", "Control+z", "x", "m", "/"):
        keys.press(key)
    expect(panel).to_be_visible()
    me.has_steps(1)


def test_arrow_keys_walk_and_enter_inserts(me):  # R-G04
    me.icon("lamp_litC").focus()
    me.page.keyboard.press("Home")
    first = me.page.evaluate("document.activeElement.id")
    me.page.keyboard.press("ArrowRight")
    assert me.page.evaluate("document.activeElement.id") != first
    me.page.keyboard.press("ArrowLeft")
    assert me.page.evaluate("document.activeElement.id") == first
    me.page.keyboard.press("Enter")
    me.has_steps(1)


def test_an_icon_is_dragged_into_a_flow(me):  # R-G04
    box = me.icon("opengripC").bounding_box()
    ground = me.workspace.locator(".ground").bounding_box()
    mouse = me.page.mouse
    mouse.move(box["x"] + 30, box["y"] + 20)
    mouse.down()
    mouse.move(ground["x"] + 120, ground["y"] + 60, steps=6)
    mouse.up()
    me.has_steps(1)


def test_a_press_on_nothing_selects_nothing(me):  # R-G04: B.3, row 2
    me.icon("opengripC").click()
    expect(me.icon("opengripC")).to_have_attribute("aria-pressed", "true")
    me.dictionary.get_by_role("heading", level=2).first.click()
    expect(me.icon("opengripC")).to_have_attribute("aria-pressed", "false")


def test_shift_and_a_click_open_what_is_behind(me):  # R-D12, R-G04: B.3, rows 3 and 4
    page = me.page
    me.icon("put_back").click(modifiers=["Shift"])
    expect(page.get_by_role("navigation").get_by_role("button", name=re.compile("^put_back"))).to_be_visible()
    me.icon("jmoveC").click(modifiers=["Shift"])
    expect(page.get_by_role("application", name="canvas of jmoveC")).to_be_visible()
    page.get_by_role("button", name="Applications", exact=True).click()


def test_the_middle_button_shows_an_action_and_opens_the_values_of_a_target(me):  # R-G04: B.3, rows 5 and 6
    me.icon("jmoveC").click(button="middle")
    panel = me.panel("move the joints")
    expect(panel).to_contain_text("Joint job")
    expect(panel).to_contain_text("jmoveC")
    me.icon("home").click(button="middle")
    panel = me.page.get_by_role("dialog")
    expect(panel.get_by_label(re.compile(r"^duration, s"))).to_have_value("3")
    me.page.keyboard.press("Escape")


def test_shift_and_the_middle_button_open_the_picture(me):  # R-G04: B.3, row 7
    me.icon("jmoveC").click(button="middle", modifiers=["Shift"])
    grid = me.panel("move the joints").get_by_role("application", name=re.compile("^Picture, 32 by 32"))
    expect(grid).to_be_visible()


def test_a_target_is_made_taught_in_words_and_edited(me, program):  # R-D08, R-D17
    page = me.page
    page.keyboard.press("Alt+t")
    panel = me.panel("New target")
    expect(panel.get_by_role("radio", name="Joint target", exact=True)).to_be_checked()
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(panel).to_contain_text("A name is needed")
    panel.get_by_label("Name", exact=True).fill("shelf")
    panel.get_by_label("Words").fill("to the shelf")
    for k, word in enumerate(("10°", "-0.7", "2.7", "0", "1", "1.7")):
        panel.get_by_label(f"endpoint [{k}], rad").fill(word)
    duration = panel.get_by_label(re.compile("^duration, s"))
    duration.fill("900")
    expect(panel).to_contain_text("900 is above 600")
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(duration).to_be_focused()
    duration.fill("2")
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(panel).to_have_count(0)
    expect(me.icon("shelf")).to_have_attribute("aria-pressed", "true")
    text = (program.home / "onika" / "dict" / "shelf.onk").read_text()
    assert re.search(r"UI +0\.1745329252 -0\.7 2\.7 0(\.0)? 1(\.0)? 1\.7", text)
    me.icon("shelf").click(button="middle")
    panel = me.panel("to the shelf")
    panel.get_by_label(re.compile("^duration, s")).fill("4")
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(panel).to_have_count(0)
    path = program.home / "onika" / "dict" / "shelf.onk"
    assert re.search(r"UI +4", path.read_text())
    me.icon("shelf").click(button="middle")
    path.write_text(path.read_text().replace("to the shelf", "to the upper shelf"))  # by hand meanwhile; R-X10
    expect(me.panel("to the upper shelf").get_by_role("status")).to_contain_text("changed elsewhere")


def test_what_is_begun_of_a_target_is_kept_until_it_is_cancelled(me):  # R-D21
    me.page.keyboard.press("Alt+t")
    me.panel("New target").get_by_label("Name", exact=True).fill("half_done")
    me.page.keyboard.press("Escape")
    me.page.locator("body").press("Alt+t")
    expect(me.panel("New target").get_by_label("Name", exact=True)).to_have_value("half_done")
    me.panel("New target").get_by_role("button", name="Cancel").click()
    me.page.locator("body").press("Alt+t")
    expect(me.panel("New target").get_by_label("Name", exact=True)).to_have_value("")


def test_present_values_are_asked_of_the_robot_or_it_is_said_what_is_missing(me):  # R-D13
    me.dictionary.get_by_role("button", name="Take the arm’s present position").click()
    panel = me.panel("New target")
    expect(panel.get_by_role("alert")).to_contain_text("measure")


def test_an_icon_of_an_application_alone_is_edited(me):  # R-D17, R-D05
    me.icon("jmoveC").dblclick()
    me.has_steps(2)
    me.icon("home").dblclick()
    expect(me.workspace).to_contain_text("Complete")
    me.step(2).click(button="middle")
    panel = me.page.get_by_role("dialog")
    expect(panel).to_contain_text("only this one changes")
    panel.get_by_label(re.compile("^duration, s")).fill("5")
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(panel).to_have_count(0)
    me.icon("home").click(button="middle")
    expect(me.page.get_by_role("dialog").get_by_label(re.compile("^duration, s"))).to_have_value("3")


def test_the_menu_beside_an_icon_does_the_same(me):  # R-G04
    me.icon("opengripC").click(button="right")
    menu = me.page.get_by_role("menu", name="open the hand")
    expect(menu).to_contain_text("Open its configuration")
    menu.get_by_role("menuitem", name=re.compile("^Insert at")).click()
    me.has_steps(1)


def test_a_new_application_of_several_flows(me):  # R-D04
    me.page.locator("body").press("Alt+n")
    panel = me.panel("New application")
    panel.get_by_text("Several flows, side by side").click()
    panel.get_by_label("How many flows").fill("3")
    panel.get_by_role("button", name="Begin", exact=True).click()
    expect(me.workspace).to_contain_text("3 flows")


def test_targets_of_another_arm_are_not_offered_and_a_line_shows_them(me):  # R-D08, R-D03
    me.icon("jmove_rightC").dblclick()
    me.has_steps(2)
    me.dictionary.get_by_role("button", name="Fits here").click()
    expect(me.icon("box1_ajr")).to_be_visible()
    expect(me.icon("home")).to_be_visible()
    expect(me.icon("box1_aj")).to_have_count(0)
    expect(me.dictionary).to_contain_text("8 of other arms are not shown")
    me.dictionary.get_by_role("button", name="Show them").click()
    expect(me.icon("box1_aj")).to_be_visible()
    expect(me.icon("box1_aj")).to_have_attribute("aria-label", re.compile("for puma$|for puma,"))
    expect(me.dictionary.get_by_role("button", name="Show them")).to_have_count(0)

    me.step(1).click()
    me.page.keyboard.press("/")
    quick = me.panel("Find an icon and insert it")
    expect(quick.get_by_role("option").filter(has_text="8 of other arms are not shown")).to_have_count(1)
    me.page.keyboard.press("ArrowUp")
    me.page.keyboard.press("Enter")
    expect(quick.get_by_role("option").filter(has_text="are not shown")).to_have_count(0)
    me.page.keyboard.press("Escape")
    me.dictionary.get_by_role("button", name="Fits here").click()
