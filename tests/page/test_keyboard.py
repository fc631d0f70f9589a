"""From an empty canvas to a running, saved configuration without a mouse."""

import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


@pytest.fixture(scope="module")
def program(begin, lab):
    return begin(f"--base={lab.path}")


def test_a_configuration_is_built_switched_on_answered_and_saved_by_keys_alone(program, page, people, lab):
    # R-G04, R-C11, R-C13
    me = people(program.enter(page))
    keys = page.keyboard
    expect(page.get_by_role("button", name="Release")).to_be_visible(timeout=30_000)
    for task in ("wave", "calm", "aim"):
        keys.press("Control+f")
        keys.type(task)
        keys.press("Enter")
        expect(me.icon(task)).to_be_focused()
        keys.press("Enter")
        me.state(task, "OFF")
        keys.press("Control+f")
        keys.press("Control+a")
        keys.press("Delete")
    for _ in range(60):
        if page.evaluate("document.activeElement.closest('[data-task]') !== null"):
            break
        keys.press("Tab")
    expect(page.locator(":focus")).to_have_attribute("aria-label", re.compile("OFF"))
    reach(me, "wave")
    keys.press("Shift+Enter")
    me.state("wave", "ON")
    reach(me, "aim")
    keys.press("Shift+Enter")
    me.state("aim", "ASKING")
    form = page.get_by_role("dialog", name=re.compile("aim asks"))
    expect(form).to_be_visible()
    field = form.get_by_role("textbox")
    for _ in range(80):
        if field.evaluate("one => one === document.activeElement"):
            break
        keys.press("Tab")
    keys.type("0.5")
    keys.press("Enter")
    me.state("aim", "ON")
    keys.press("Control+s")
    panel = page.get_by_role("dialog", name=re.compile("^Save Untitled"))
    expect(panel.get_by_label("Name", exact=True)).to_be_focused()
    keys.type("keyedC")
    keys.press("Tab")
    keys.type(str(lab.path)[:5])
    keys.press("Tab")
    keys.press("Tab")
    expect(panel.get_by_role("button", name="Save", exact=True)).to_be_focused()
    keys.press("Enter")
    expect(me.tab("keyedC")).to_be_visible()
    assert [*lab.path.glob("conf/keyedC.conf"), *program.home.rglob("keyedC.conf")]


def reach(me, task):
    """Walk from task to task by the arrow keys."""
    for way in ("Alt+ArrowLeft", "Alt+ArrowUp", "Alt+ArrowRight", "Alt+ArrowDown", "Alt+ArrowLeft", "Alt+ArrowUp"):
        for _ in range(6):
            if me.box(task).evaluate("one => one === document.activeElement || one.contains(document.activeElement)"):
                return
            me.page.keyboard.press(way)
    expect(me.box(task)).to_be_focused()


NAME = "document.activeElement.getAttribute('aria-label') || document.activeElement.textContent.trim()"
RING = """() => [document.activeElement, document.activeElement.parentElement].some((one) => {
  const style = getComputedStyle(one)
  return style.outlineStyle !== 'none' || style.boxShadow !== 'none'
})"""


def test_the_first_tab_stops_are_in_order_and_the_ring_is_seen(program, page, people):  # R-G04
    me = people(program.enter(page))
    me.blank()
    seen = []
    for _ in range(12):
        page.keyboard.press("Tab")
        seen.append((page.evaluate(NAME), page.evaluate(RING)))
    assert len({name for name, _ in seen}) >= 8
    assert [name for name, ring in seen if not ring] == []
