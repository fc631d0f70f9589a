"""Two levels, one tool: going from one to the other, what is behind a picture, the tutorial, the upper level alone."""

import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


@pytest.fixture(scope="module")
def program(begin):
    return begin("assemble", "--no-connect")


@pytest.fixture
def user(program, page):
    """Somebody who looks at the assembly of boxes."""
    program.enter(page)
    page.goto(page.url.partition("#")[0] + "#/appl/assemble")
    expect(page).to_have_title(re.compile("assemble"))
    return page


def tab(page, name):
    return page.get_by_role("navigation").get_by_role("button", name=re.compile(rf"^{name}( |$)"))


def level(page, name):
    return page.get_by_role("group", name="Level").get_by_role("button", name=name)


def step(page, number):
    return page.locator(f'[data-step="{number}"]').first


def test_a_session_that_was_given_an_application_begins_with_it(begin, page):  # R-G05, R-C20
    begin("go_home", "--no-connect").enter(page)
    expect(level(page, "Applications")).to_have_attribute("aria-pressed", "true")
    expect(page).to_have_url(re.compile("#/appl/go_home$"))


def test_the_other_level_is_one_key_away_and_nothing_is_lost_on_the_way(user):  # R-G05
    step(user, 2).click()
    picked = user.get_by_role("region", name="Workspace").get_by_role("option", selected=True)
    expect(picked).to_have_count(1)
    user.keyboard.press("Control+Shift+L")
    expect(user.get_by_role("complementary", name="Task library")).to_be_visible()
    user.keyboard.press("Delete")  # means the canvas now, and nothing is picked there
    level(user, "Applications").click()
    expect(picked).to_have_count(1)
    expect(user.get_by_role("button", name="Undo", exact=True)).to_be_disabled()


def test_a_job_shows_its_configuration_where_the_pointer_rests_and_opens_below(user):  # R-G05, R-D12
    step(user, 2).hover()
    card = user.get_by_role("tooltip")
    expect(card).to_contain_text("7 tasks: puma")
    assert card.locator("rect").count() == 7
    step(user, 2).click(modifiers=["Shift"])
    expect(user.get_by_text("is made of this: what is saved here is what it runs at its next start")).to_be_visible()
    expect(tab(user, "jmoveC")).to_have_attribute("aria-current", "page")
    user.get_by_role("button", name="Back to assemble").click()
    expect(tab(user, "assemble")).to_have_attribute("aria-current", "page")


def test_the_dictionary_shows_it_too(user):  # R-G05
    libraries = user.get_by_role("complementary", name="Dictionary", exact=True)
    libraries.get_by_text("wave with both arms together").first.hover()
    expect(user.get_by_role("tooltip")).to_contain_text("both_wave")


def test_applications_are_found_with_their_first_icons(user):  # R-D04
    user.keyboard.press("Control+o")
    panel = user.get_by_role("dialog", name="Open an application")
    panel.get_by_role("searchbox").fill("go_home")
    expect(panel.get_by_role("listitem")).to_have_count(1)
    expect(panel.get_by_role("listitem").locator("image")).to_have_count(3)
    panel.get_by_role("button", name="Open go_home").click()
    expect(tab(user, "go_home")).to_have_attribute("aria-current", "page")
    user.keyboard.press("Alt+w")
    expect(tab(user, "go_home")).to_have_count(0)


def test_the_help_sheet_has_pictures_and_the_tables_of_both_levels(user):  # R-G04, R-H05
    user.keyboard.press("?")
    sheet = user.get_by_role("dialog", name="Help sheet")
    expect(sheet.get_by_role("heading", name="A hole keeps a place")).to_be_visible()
    sheet.get_by_role("button", name="Keys and mouse").click()
    for words in (
        "Mouse in the dictionary",
        "Mouse in the workspace",
        "Mouse on the canvas",
        "Shift + middle, on an icon",
    ):
        expect(sheet.get_by_text(words).first).to_be_attached()


def test_the_tutorial_sees_what_is_done_and_goes_on_after_a_reload(user):  # R-H05
    user.keyboard.press("Control+k")
    user.get_by_role("combobox", name="All commands").fill("tutorial")
    user.keyboard.press("Enter")
    lesson = user.get_by_role("dialog", name="Tutorial, 15 minutes").locator("[aria-current=step]")
    expect(lesson).to_contain_text("Make a new application")
    user.get_by_role("button", name="New application…").first.click()
    user.get_by_role("button", name="Begin", exact=True).click()
    expect(lesson).to_contain_text("open the hand")
    libraries = user.get_by_role("complementary", name="Dictionary", exact=True)
    libraries.get_by_text("open the hand", exact=True).first.dblclick()
    expect(lesson).to_contain_text("move the joints")
    libraries.get_by_text("move the joints", exact=True).first.dblclick()
    expect(lesson).to_contain_text("Fill the hole")
    for words in ("above the box with the triangle", "move the joints", "above the box with the triangle"):
        libraries.get_by_text(words, exact=True).first.dblclick()
    # A hole of another job that was filled is no target that was taken out and put back.
    workspace = user.get_by_role("region", name="Workspace")
    expect(workspace.get_by_text("Complete.", exact=True)).to_be_visible()
    expect(lesson).to_contain_text("Take the target out again")
    workspace.locator("[data-step]").nth(3).click()
    user.keyboard.press("Delete")
    expect(lesson).to_contain_text("Undo that")
    user.keyboard.press("Control+z")
    expect(lesson).to_contain_text("Run it")
    expect(lesson).to_be_in_viewport(ratio=0.9)
    user.reload()
    expect(lesson).to_contain_text("Run it")
    expect(lesson).to_be_in_viewport(ratio=0.9)


def test_who_needs_only_the_upper_level_has_no_other_until_it_is_wished(begin, page):  # R-G05, R-C20
    begin("assemble", "--upper", "--no-connect").enter(page)
    expect(page.get_by_role("group", name="Level")).to_have_count(0)
    page.keyboard.press("Control+Shift+L")
    step(page, 2).click(modifiers=["Shift"])
    expect(tab(page, "assemble")).to_be_visible()
    page.keyboard.press("Control+,")
    page.get_by_label("Show the lower level").check()
    level(page, "Tasks").click()
    expect(page.get_by_role("complementary", name="Task library")).to_be_visible()
