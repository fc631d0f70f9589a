"""What a hand may touch in a simulated workcell, pressed in the page."""

import base64
import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page

RED = """async picture => {
  const image = new Image()
  image.src = `data:image/png;base64,${picture}`
  await image.decode()
  const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height })
  const context = canvas.getContext('2d')
  context.drawImage(image, 0, 0)
  const { data } = context.getImageData(0, 0, image.width, image.height)
  const red = []
  for (let k = 0; k < data.length; k += 4)
    if (data[k] > 110 && data[k + 1] < 0.4 * data[k] && data[k + 2] < 0.4 * data[k])
      red.push([(k / 4) % image.width, Math.floor(k / 4 / image.width)])
  return red
}"""
"""The pixels of a picture that are as red as the cap of a panic button."""


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


def test_a_click_on_a_button_in_the_picture_presses_it(program, page):  # R-K06
    program.enter(page)
    page.get_by_role("button", name="Workcell boxes").click()
    scene = page.get_by_role("application", name=re.compile("^The workcell in three dimensions")).locator("canvas")
    expect(scene).to_be_visible()
    buttons = page.get_by_role("group", name="What a hand may touch").get_by_role("button")
    pressed = buttons.and_(page.locator("[aria-pressed=true]"))
    click_on_red(page, scene)
    expect(pressed).to_have_count(1)
    page.get_by_role("group", name="What a hand may touch").get_by_role("button", pressed=True).click()
    expect(pressed).to_have_count(0)


def click_on_red(page, scene):
    """Click into the middle of what is red in a picture, as soon as there is something."""
    for _ in range(40):
        red = {tuple(pixel) for pixel in page.evaluate(RED, base64.b64encode(scene.screenshot()).decode())}
        within = sorted((x, y) for x, y in red if {(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)} <= red)
        if within:
            x, y = within[len(within) // 2]
            return scene.click(position={"x": x, "y": y})
        page.wait_for_timeout(250)
    raise AssertionError("expected a red cap in the picture, found none")
