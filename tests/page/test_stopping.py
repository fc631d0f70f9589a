"""Stop works whatever is open, in any window, and while nobody answers (law 27, X12)."""

import os
import re
import signal

import pytest
from playwright.sync_api import expect

from kit.process.process_tree import runtime_of

pytestmark = pytest.mark.page


@pytest.fixture(scope="module")
def program(begin, lab):
    """With a runtime in wall time."""
    return begin(f"--base={lab.path}", "--rtpu=rt0")


@pytest.fixture
def me(program, new_page, people, excused):
    """Somebody whose configuration is connected, and whose way to the environment can be cut."""
    excused.append("WebSocket|ERR_")
    page = new_page()
    wires = page.wires = []
    page.is_cut = False

    def through(ours):
        if page.is_cut:
            ours.close()
            return
        ours.connect_to_server()
        wires.append(ours)

    page.route_web_socket(re.compile("/ws"), through)
    person = people(program.enter(page))
    name = person.blank()
    person.libraries("bench")
    page.locator("body").press("Alt+c")
    page.get_by_role("dialog", name=f"Connect {name}").get_by_role("button", name="Connect", exact=True).click()
    expect(page.get_by_role("button", name="Release")).to_be_visible(timeout=30_000)
    return person


def reset(me):
    return me.page.get_by_role("button", name="Reset", exact=True)


def goes_on(me):
    expect(reset(me)).to_be_visible()
    reset(me).click()
    expect(reset(me)).to_have_count(0)


def test_with_any_dialog_open_it_stops_from_the_keyboard_and_by_its_button(me):  # R-G04
    for keys in ("Control+o", "Control+Shift+s", "Control+k", "F1", "Control+,", "Alt+h"):
        me.page.locator("body").press(keys)
        me.page.keyboard.press("Control+.")
        goes_on(me)
        me.page.get_by_role("button", name="Stop", exact=True).click()
        goes_on(me)
        me.page.keyboard.press("Escape")


def test_it_is_in_reach_in_a_narrow_window_and_in_the_palette(me):  # R-G04, R-X11
    for width, height in ((320, 480), (480, 320)):
        me.page.set_viewport_size({"width": width, "height": height})
        me.page.get_by_role("button", name="Stop", exact=True).click()
        goes_on(me)
    me.page.set_viewport_size({"width": 1200, "height": 800})
    me.page.locator("body").press("Control+k")
    me.page.keyboard.type("stop everything")
    me.page.keyboard.press("Enter")
    goes_on(me)


def test_what_is_pressed_while_the_page_is_cut_off_is_said_and_sent_as_soon_as_it_is_back(me):  # R-G04
    me.page.is_cut = True
    me.page.wires[-1].close()
    expect(me.page.get_by_text(re.compile("[Nn]ot connected|trying again")).first).to_be_visible()
    me.page.keyboard.press("Control+.")
    expect(me.page.get_by_text(re.compile("use the emergency stop")).first).to_be_visible()
    me.page.is_cut = False
    goes_on(me)


def test_a_frozen_runtime_is_told_at_once_and_can_be_ended(me, program):  # R-X12
    late = me.page.get_by_role("alertdialog", name="Stop is not answered")
    frozen = runtime_of(program.process.pid)
    os.kill(frozen, signal.SIGSTOP)
    me.page.keyboard.press("Control+.")
    expect(late).to_contain_text(re.compile(r"nothing has answered for \d+ s"))
    os.kill(frozen, signal.SIGCONT)
    expect(late).to_have_count(0)
    goes_on(me)
    os.kill(frozen, signal.SIGSTOP)
    me.page.keyboard.press("Control+.")
    late.get_by_role("button", name="End the runtime").click()
    expect(me.page.get_by_text(re.compile("a new runtime is there")).first).to_be_visible(timeout=30_000)
    expect(late).to_have_count(0)
