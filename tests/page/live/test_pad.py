"""A tool is led at the page: by a gamepad, by keys, by dragging it, and where it is becomes a target (F05, K07)."""

import os
import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page

GAMEPAD = """
window.held = {axes: [0, 0, 0, 0], down: []}
navigator.getGamepads = () => [{
  id: 'a pad', connected: true, mapping: 'standard', index: 0, timestamp: 0, axes: window.held.axes,
  buttons: Array.from({length: 17}, (_, k) => ({pressed: held.down.includes(k), value: +held.down.includes(k)})),
}, null, null, null]
"""
PLACES = """
() => {
  const sent = window.sent = []
  const send = WebSocket.prototype.send
  WebSocket.prototype.send = function (text) {
    if (text.includes('"Push"')) sent.push(JSON.parse(text).act)
    return send.call(this, text)
  }
}
"""


def opened(program, page, name):
    page.get_by_role("button", name="Applications", exact=True).click()
    page.locator("body").press("Control+o")
    opening = page.get_by_role("dialog", name="Open an application")
    opening.get_by_role("searchbox").fill(name)
    opening.get_by_role("button", name=f"Open {name}", exact=True).click()
    expect(opening).to_have_count(0)


def shot(page, name):
    if folder := os.environ.get("SHOTS"):
        page.screenshot(path=f"{folder}/{name}.png")


def pushes(page):
    return page.evaluate("sent.splice(0)")


def test_a_tool_is_led_by_gamepad_keys_and_hand_and_its_pose_becomes_a_target(begin, page):  # R-F05, R-K07
    program = begin()
    page.add_init_script(GAMEPAD)
    page.add_init_script(f"({PLACES})()")
    program.enter(page)
    opened(program, page, "teach_by_pad")
    page.get_by_role("region", name="Run", exact=True).get_by_role("button", name=re.compile("^Run")).click()
    page.get_by_role("button", name="Lead by hand").click(timeout=30_000)
    pad = page.get_by_role("region", name="Lead the tool")
    expect(pad.get_by_role("status")).to_contain_text("A job listens.", timeout=30_000)
    shot(page, "pad")

    page.evaluate("held.axes = [0, -1, 0, 0]")
    page.wait_for_function("() => sent.length > 2")
    assert not any(push["is_held"] for push in pushes(page))  # no dead-man
    page.evaluate("held.down = [4]")
    expect(pad.get_by_role("status")).to_have_text("You lead the tool.")
    page.wait_for_function("() => sent.filter((push) => push.is_held && push.axes[0] === 1).length > 5")
    shot(page, "pad_leads")
    page.evaluate("window.dispatchEvent(new Event('blur')); document.hasFocus = () => false")
    expect(pad.get_by_role("status")).to_contain_text("A job listens.")
    page.evaluate("held.down = []; held.axes = [0, 0, 0, 0]; document.hasFocus = () => true")

    pad.focus()
    pushes(page)
    page.keyboard.down("KeyF")
    expect(pad.get_by_role("status")).to_have_text("You lead the tool.")
    page.wait_for_function("() => sent.some((push) => push.axes[2] === -1)")
    page.keyboard.up("KeyF")
    expect(pad.get_by_role("status")).to_contain_text("A job listens.")
    pad.get_by_label("Along the axes of").select_option("the tool")
    place = pad.get_by_role("button", name=re.compile("^left"))
    place.hover()
    page.mouse.down()
    page.wait_for_function("() => sent.some((push) => push.frame === 'tool' && push.axes[1] === 1)")
    page.mouse.up()

    page.evaluate("held.down = [0]")  # the button of the gamepad keeps the pose, and the job goes on
    expect(pad.get_by_text("taught_1 is kept in your dictionary.")).to_be_visible()
    page.evaluate("held.down = []")
    (target,) = program.home.rglob("taught_1.onk")
    assert "Cartesian object" in target.read_text(encoding="utf-8")
    expect(pad.get_by_role("textbox", name="Name of the target")).to_have_value("taught_2")
    expect(pad.get_by_role("status")).to_contain_text("Nobody is led", timeout=10_000)
    expect(pad.get_by_role("status")).to_contain_text("A job listens.", timeout=20_000)
    shot(page, "pad_second")
    page.emulate_media(color_scheme="dark")
    page.set_viewport_size({"width": 900, "height": 700})
    shot(page, "pad_dark_narrow")
    page.emulate_media(color_scheme="light")
    page.set_viewport_size({"width": 1440, "height": 900})
    pad.get_by_role("button", name="Close the pad").click()
    expect(pad).to_have_count(0)
