"""What a hand may touch in a simulated workcell, pressed in the page."""

import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


@pytest.fixture(scope="module")
def program(begin):
    """With the simulated arm, alive."""
    return begin("jmoveC")


def test_a_panic_button_pressed_in_the_page_holds_the_arm_until_it_is_let_go(program, page, people):  # R-K06, R-E08
    me = people(program.enter(page))
    me.state("puma", "OFF")
    page.keyboard.press("Escape")
    me.box("puma").click(modifiers=["Shift"])
    me.state("puma", "ON")
    page.get_by_role("button", name="Workcell boxes").click()
    button = page.get_by_role("group", name="What a hand may touch").get_by_role(
        "button", name=re.compile("panic_left")
    )
    button.focus()
    page.keyboard.press("Enter")
    expect(button).to_have_attribute("aria-pressed", "true")
    expect(button).to_contain_text("pressed")
    me.state("puma", "ERROR")
    button.click()
    expect(button).to_have_attribute("aria-pressed", "false")
