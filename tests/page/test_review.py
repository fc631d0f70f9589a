"""Recorded runs at the page: all that is drawn follows the instant that is looked at, and two lie beside each other."""

import os
import re
import subprocess
import sys
import time
from pathlib import Path

import pytest
from playwright.sync_api import Error, expect

pytestmark = pytest.mark.page

AXE = Path(__file__).parents[2] / "browser" / "node_modules" / "axe-core" / "axe.min.js"
NAME = "assemble-20261121-231500.mcap"
CUT = "assemble-20261121-231000.mcap"
ABORTED = "aborted.mcap"
"""The same run until it was aborted, elsewhere."""
SHARE = 0.5
"""So much is left of the one that was cut short."""

INSTANT = """() => {
    const canvas = [...document.querySelectorAll('.plot canvas')].at(-1)
    const { width, height } = canvas
    const paint = document.createElement('canvas').getContext('2d')
    paint.fillStyle = getComputedStyle(document.querySelector('.grip')).fill
    paint.fillRect(0, 0, 1, 1)
    const [r, g, b] = paint.getImageData(0, 0, 1, 1).data
    const { data } = canvas.getContext('2d').getImageData(0, 0, width, height)
    const counts = Array.from({ length: width }, (_, x) => {
        let n = 0
        for (let y = 0; y < height; y += 1) {
            const k = 4 * (y * width + x)
            n += data[k] === r && data[k + 1] === g && data[k + 2] === b
        }
        return n
    })
    const most = Math.max(...counts)
    return most > height / 2 ? counts.indexOf(most) / width : null
}"""
"""Where in the plot the line of the instant stands, as a part of its width; null: nowhere."""


@pytest.fixture(scope="module")
def program(begin, tmp_path_factory):
    """The environment with a recording of a whole assembly, and one of it that was cut short."""
    folder = tmp_path_factory.mktemp("recorded")
    recordings = folder / "state" / "onika" / "recordings"
    recordings.mkdir(parents=True)
    inherited = {name: value for name, value in os.environ.items() if not name.startswith("ONIKA_")}
    (folder / "script").write_text("wait 8\nabort\n")
    for path, *words in ((recordings / NAME,), (folder / ABORTED, "--script", str(folder / "script"))):
        subprocess.run(
            [sys.executable, "-c", "from onika.cli import main; main()", "run", "assemble", "--virtual", "--record",
             str(path), *words],
            env={**inherited, "HOME": str(folder), "XDG_STATE_HOME": str(folder / "aside")},
            check=not words, capture_output=True, timeout=200,
        )  # fmt: skip
    whole = (recordings / NAME).read_bytes()
    (recordings / CUT).write_bytes(whole[: int(len(whole) * SHARE)])
    return begin("assemble", "--no-connect", folder=folder)


@pytest.fixture
def user(program, page):
    """Somebody who looks at no recording yet, and at no workcell: without graphics hardware its pictures take long."""
    page.add_init_script("localStorage['onika.showsWorkcell'] ??= 'false'")
    program.enter(page)
    page.goto(page.url.partition("#")[0] + "#/appl/assemble")
    expect(page).to_have_title(re.compile("assemble"))
    if bar(page).count():
        page.get_by_role("button", name="Close the recording").click()
    expect(bar(page)).to_have_count(0)
    return page


def bar(page):
    return page.get_by_role("region", name="Recording", exact=True)


def time_line(page):
    return page.get_by_role("slider", name="Time of the recording")


def open_one(page, which="first"):
    """Open one of the list: the first is the newest, and both began when the run did."""
    page.keyboard.press("Alt+o")
    panel = page.get_by_role("dialog", name="Open a recording")
    items = panel.get_by_role("listitem")
    expect(items).to_have_count(2)
    cut = items.filter(has_text="cut short")
    item = cut if which == "cut" else items.filter(has_not_text="cut short")
    item.get_by_role("button", name=re.compile("^Open the recording of assemble")).click()
    expect(panel).to_have_count(0)
    expect(bar(page)).to_be_visible()
    expect(time_line(page)).to_be_focused()
    page.keyboard.press("Home")
    expect(page.locator("[aria-current=step]")).to_have_text(re.compile("Open the hand"))


def at(page):
    return float(time_line(page).get_attribute("aria-valuenow"))


def drawn(place):
    """What the workcell looks like; nothing while it is built anew."""
    try:
        return place.screenshot(timeout=5_000)
    except Error:
        return b""


def test_a_recording_is_found_in_the_list_and_shows_the_icon_that_was_carried_out_then(user):  # R-X05
    open_one(user)
    expect(bar(user).get_by_role("heading")).to_have_text("Recording of assemble")
    user.keyboard.press(".")
    expect(user.locator("[aria-current=step]")).to_have_text(re.compile("above the box with the triangle"))
    expect(user.get_by_role("group", name="Flow 0", exact=True).first).to_contain_text("2 of 25")
    rings = user.locator("svg.paper path.ring.running")
    expect(rings).to_have_count(1)
    assert at(user) > 0
    user.keyboard.press("End")
    expect(user.get_by_text("The run was completed.")).to_be_visible()
    expect(rings).to_have_count(0)
    user.keyboard.press(",")
    expect(rings).to_have_count(1)
    user.evaluate(AXE.read_text() + "; undefined")
    results = user.evaluate("axe.run(document, { resultTypes: ['violations'] })")
    assert [
        (violation["id"], [node["target"] for node in violation["nodes"]][:3]) for violation in results["violations"]
    ] == []


def test_states_values_plots_and_the_workcell_are_those_of_the_instant(user):  # R-X05
    open_one(user)
    user.locator('[data-step="2"]').first.click(modifiers=["Shift"])
    canvas = user.get_by_role("application", name="canvas of jmoveC")
    expect(canvas).to_be_visible()
    user.get_by_role("tab", name=re.compile("^Variables")).click()
    row = user.get_by_role("row", name=re.compile("LAMP"))
    row.click()
    for key, lamp, state, where in (
        ("Home", re.compile("^[–0]$"), ", OFF", (0, 0.2)),
        (".", "0", ", ON", (0, 0.3)),
        ("End", "1", "", (0.7, 1)),
    ):
        user.locator("body").press(key)
        expect(canvas.get_by_role("button", name=re.compile(f"^jtraj{state}$"))).to_be_visible()
        expect(row.locator(".value")).to_have_text(lamp)
        user.wait_for_function(
            f"([low, high]) => {{ const x = ({INSTANT})(); return x !== null && x >= low && x <= high }}", arg=where
        )
    assert user.evaluate("document.querySelectorAll('.plot canvas').length") == 1
    user.get_by_role("group", name="Level").get_by_role("button", name="Applications").click()
    user.get_by_role("button", name="Show the workcell").click()
    place = user.get_by_role("application", name=re.compile("workcell|Workcell|view", re.I)).locator("canvas")
    expect(place).to_be_visible()
    before = drawn(place)
    user.locator("body").press("Home")
    expect(bar(user).get_by_role("timer")).to_contain_text("00:00.0")
    until = time.monotonic() + 20
    while drawn(place) in (before, b""):
        assert time.monotonic() < until, "the arm stands as it did at the end"


def test_it_plays_and_walks_by_keys_and_a_page_that_comes_back_stands_where_it_was(user):  # R-X05
    open_one(user)
    user.keyboard.press("Space")
    expect(bar(user).get_by_role("button", name="Pause")).to_be_visible()
    user.wait_for_function("() => document.querySelector('[role=slider]').getAttribute('aria-valuenow') > 0.5")
    user.keyboard.press("Space")
    expect(bar(user).get_by_role("button", name="Play")).to_be_visible()
    for key, moment in (("Home", 0), ("ArrowRight", 1), ("ArrowRight", 2), ("ArrowLeft", 1)):
        user.keyboard.press(key)
        assert at(user) == moment
    box = time_line(user).bounding_box()
    user.mouse.click(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    middle = at(user)
    assert 9 < middle < 14
    user.wait_for_function(
        "at => Math.abs(JSON.parse(localStorage['onika.review'] ?? '{}').at_s - at) < 0.1", arg=middle
    )
    user.reload()
    expect(bar(user)).to_be_visible()
    expect(time_line(user)).to_have_attribute("aria-valuenow", re.compile(f"^{middle}"))


def test_nothing_sets_the_robot_in_motion_meanwhile_but_stop_stays(user):  # R-X05
    open_one(user)
    expect(user.get_by_role("button", name=re.compile("^Run assemble"))).to_have_count(0)
    expect(user.get_by_role("button", name="Abort")).to_have_count(0)
    expect(user.get_by_role("button", name=re.compile("^Stop"))).to_be_enabled()
    user.keyboard.press("F5")
    refusal = user.get_by_role("alertdialog", name="Refused")
    expect(refusal).to_contain_text("You are looking at a recording")
    refusal.get_by_role("button", name="Close the recording").click()
    expect(bar(user)).to_have_count(0)
    expect(user.get_by_role("button", name=re.compile("^Run assemble"))).to_be_visible()


def test_one_that_was_cut_short_says_so_and_the_first_difference_of_two_is_named(user, program):  # R-X05
    open_one(user, "cut")
    expect(bar(user)).to_contain_text("Cut short")
    bar(user).get_by_role("button", name="Compare with…").click()
    panel = user.get_by_role("dialog", name="Compare with")
    panel.get_by_role("textbox").fill(str(program.home.parent / ABORTED))
    panel.get_by_role("button", name="Compare", exact=True).click()
    differs = bar(user).get_by_role("button", name="Go there")
    differs.click(timeout=30_000)
    expect(bar(user)).to_contain_text("First difference at")
    moment = float(re.search(r"First difference at ([\d.]+) s", bar(user).inner_text()).group(1))
    assert abs(at(user) - moment) < 0.1
    assert moment > 5
    expect(bar(user)).to_contain_text("the other")
    user.get_by_role("button", name="Show the workcell").click()
    expect(user.get_by_role("region", name="The other run")).to_be_visible()
    bar(user).get_by_role("button", name="Tolerance…").click()
    bar(user).get_by_label("Times, by").fill("much")
    expect(bar(user).get_by_role("alert")).to_have_text("A number, 0 or more.")
    bar(user).get_by_role("button", name="Show only one").click()
    expect(user.get_by_role("region", name="The other run")).to_have_count(0)


def test_a_recording_that_is_looked_at_is_saved_as_one_file(user, tmp_path):  # R-X21: Share… in the page
    open_one(user)
    with user.expect_download() as saved:
        bar(user).get_by_role("button", name="Share…").click()
    assert saved.value.suggested_filename == NAME.replace(".mcap", ".html")
    saved.value.save_as(tmp_path / "run.html")
    text = (tmp_path / "run.html").read_text()
    assert 'id="run"' in text and len(text) < 5_000_000
    expect(user.get_by_text("It plays in any browser.")).not_to_have_count(0)
