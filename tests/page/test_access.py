"""axe-core finds nothing on any screen, in light and in dark."""

import re
from pathlib import Path

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page

AXE = Path(__file__).parents[2] / "browser" / "node_modules" / "axe-core" / "axe.min.js"


@pytest.fixture(scope="module")
def program(begin, lab):
    return begin(f"--base={lab.path}")


def violations_on(page):
    page.evaluate(AXE.read_text() + "; undefined")
    page.evaluate("Promise.all(document.getAnimations().map((one) => one.finished.catch(() => undefined)))")
    results = page.evaluate("axe.run(document, { resultTypes: ['violations'] })")
    return [
        (violation["id"], [node["target"][0] for node in violation["nodes"]][:3]) for violation in results["violations"]
    ]


def first_start(me):
    expect(me.page.get_by_role("heading", name="Put tasks together.")).to_be_visible()


def canvas(me):
    name = me.blank()
    me.libraries("bench")
    me.page.locator("body").press("Alt+c")
    panel = me.page.get_by_role("dialog", name=f"Connect {name}")
    panel.get_by_role("button", name="Connect", exact=True).click()
    expect(panel).to_have_count(0, timeout=30_000)
    me.place("wave", "calm", "sick", "aim", "gain")
    for task in ("wave", "sick", "aim"):
        me.box(task).click(modifiers=["Shift"])
    expect(me.page.get_by_role("dialog", name=re.compile("aim asks"))).to_be_visible()
    me.state("sick", "ERROR")
    me.icon("tone").click()


def sheet(me):
    me.blank()
    me.libraries("generic")
    me.place("pd")
    me.box("pd").click()


def job(me):
    me.blank()
    me.libraries("generic")
    me.place("jtraj")
    me.page.get_by_role("button", name="Save as job…").click()
    expect(me.page.get_by_role("dialog", name=re.compile("as a job"))).to_be_visible()


def preferences(me):
    me.page.keyboard.press("Control+,")
    expect(me.page.get_by_role("dialog", name="Preferences")).to_be_visible()


def files(me):
    me.page.keyboard.press("Control+o")
    expect(me.page.get_by_role("dialog", name="Open a configuration")).to_be_visible()


def texts(me):
    me.blank()
    me.libraries("bench")
    me.icon("wave").click(button="middle", modifiers=["Shift"])
    expect(me.page.get_by_role("dialog", name="Source of wave").get_by_role("textbox")).to_be_visible()


def helps(me):
    me.page.keyboard.press("?")
    expect(me.page.get_by_role("dialog", name="Help sheet")).to_be_visible()


@pytest.mark.parametrize("screen", [first_start, canvas, sheet, job, preferences, files, texts, helps])
def test_nothing_stands_in_the_way_of_those_who_see_hear_or_move_otherwise(program, page, people, screen):  # R-G04
    if not AXE.exists():
        pytest.skip("axe-core is not installed: npm ci in browser/")
    me = people(program.enter(page))
    screen(me)
    light = violations_on(page)
    page.emulate_media(color_scheme="dark")
    assert (light, violations_on(page)) == ([], [])
