"""A recorded run as one file: opened from the disk, without network, it plays as the page plays it."""

import math
import random
import re
from pathlib import Path

import pytest
from msgspec import to_builtins
from playwright.sync_api import expect

from onika.cli import main
from onika.desk.environment.lone_review import read_alone
from onika.store.site import open_site

pytestmark = pytest.mark.page

MOST_BYTES = 5_000_000
WHOLE, CUT = "assemble", "cut"


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """The files of an assembly of the boxes, and of one that was cut short."""
    folder = tmp_path_factory.mktemp("shared")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_STATE_HOME", str(folder / "state"))
        patch.chdir(folder)
        assert main(["run", "assemble", "--virtual", "--no-black-box", "--record", f"{WHOLE}.mcap"]) == 0
        whole = (folder / f"{WHOLE}.mcap").read_bytes()
        (folder / f"{CUT}.mcap").write_bytes(whole[: len(whole) // 2])
        for name in (WHOLE, CUT):
            assert main(["share", f"{name}.mcap"]) == 0
    return folder


@pytest.fixture
def opened(new_page, folder):
    """Opens a file as somebody who was sent it, without network; what it asks for is noted."""
    asked = []

    def open_file(name, width=1440, height=900):
        page = new_page()
        page.context.set_offline(True)
        page.set_viewport_size({"width": width, "height": height})
        page.on("request", lambda request: asked.append(request.url))
        page.add_init_script("localStorage['onika.showsWorkcell'] ??= 'false'")
        page.goto((folder / f"{name}.html").as_uri())
        expect(time_line(page)).to_be_visible()
        return page

    yield open_file
    assert [url for url in asked if not url.startswith(("file:", "data:", "blob:"))] == []


def time_line(page):
    return page.get_by_role("slider", name=re.compile("Time of the recording|Tiempo de la grabación"))


def flat(value):
    """Numbers in one row; what is no number is none."""
    if isinstance(value, list | tuple):
        return [number for part in value for number in flat(part)]
    return [None if isinstance(value, float) and not math.isfinite(value) else value]


def without_empty(value):
    """Maps that hold nothing say nothing; nor does what stands on the machine where it was recorded."""
    if not isinstance(value, dict):
        return list(map(without_empty, value)) if isinstance(value, list | tuple) else value
    parts = {name: without_empty(part) for name, part in value.items()}
    return {name: part for name, part in parts.items() if part != {} and name not in ("recording", "black_box", "path")}


def test_fifty_instants_equal_the_recording(opened, folder):  # R-X21: Chromium without network: 50 instants
    page = opened(WHOLE)
    looked_at = read_alone(folder / f"{WHOLE}.mcap", open_site([], {}, None))
    subject, review = looked_at.subject, looked_at.subject.review
    chosen = random.Random(21)
    for wanted_s in [0.0, 99.0, *(chosen.uniform(0.0, subject.view.end_s) for _ in range(48))]:
        shown = page.evaluate("at_s => onikaRun.instant(at_s)", wanted_s)
        at_s = shown["at_s"]
        assert -1e-9 <= min(wanted_s, subject.view.end_s) - at_s <= 0.0101
        recorded = review.at(at_s, with_pictures=False)
        assert shown["tasks"] == recorded.tasks
        assert without_empty(shown["run"]) == without_empty(to_builtins(subject.replay.at(at_s)))
        assert {name: flat(value) for name, value in shown["values"].items()} == {
            name: flat(value) for name, value in recorded.variables.items()
        }
        poses = flat(recorded.poses.get("boxes") or review.first_poses("boxes"))
        assert shown["poses"]["boxes"]["rows"] == pytest.approx(poses, rel=1e-6, abs=1e-9)
        assert shown["poses"]["boxes"]["lit"] == review.lit("boxes", at_s)
    review.close()


def test_it_is_small_and_plays_from_the_disk(opened, folder):  # R-X21: at most 5 MB; icons, time line, sentences
    assert (folder / f"{WHOLE}.html").stat().st_size <= MOST_BYTES
    page = opened(WHOLE)
    expect(page).to_have_title(re.compile("assemble"))
    expect(page.locator(".workspace").get_by_role("option")).not_to_have_count(0)
    page.keyboard.press(".")
    page.keyboard.press("ArrowRight")
    now = page.get_by_role("region", name="The program as sentences").locator("[aria-current=step]")
    expect(now).to_contain_text("Move the joints")
    expect(page.get_by_text("Under way")).to_be_visible()
    page.keyboard.press("End")
    expect(page.get_by_text("The run was completed.")).to_be_visible()
    page.keyboard.press("Home")
    page.get_by_role("button", name="Play", exact=True).click()
    expect(page.get_by_text("Under way")).to_be_visible()


def test_the_workcell_is_drawn_and_variables_are_plotted(opened):  # R-X21: 3-D workcell, plots
    page = opened(WHOLE)
    page.get_by_role("button", name="Show the workcell").click()
    expect(page.locator(".place canvas")).to_be_visible()
    page.get_by_role("button", name="Look inside").first.click()
    page.get_by_role("tab", name=re.compile("ariables")).click()
    page.get_by_role("row", name=re.compile(r"Q_MEZ\b")).first.get_by_role("button").last.click()
    expect(page.locator(".plot canvas")).to_be_visible()


COUNTED = """draws => {
  window.pictures = 0
  const get = HTMLCanvasElement.prototype.getContext
  HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
    if (!kind.startsWith('webgl')) return get.call(this, kind, ...more)
    window.pictures += kind === 'webgl2'
    return draws ? get.call(this, kind, ...more) : null
  }
}"""
"""Counts how often somebody begins to draw in three dimensions, which the browser can or not."""


def plays_for_seconds(page):
    """Play until the third second."""
    page.keyboard.press("Space")
    expect(time_line(page)).to_have_attribute("aria-valuenow", re.compile(r"^([3-9]|\d\d)"), timeout=30_000)


def test_the_workcell_is_built_once_however_long_it_plays(opened):  # R-X21
    page = opened(WHOLE)
    page.evaluate(COUNTED, True)
    page.get_by_role("button", name="Show the workcell").click()
    expect(page.locator("canvas").last).to_be_visible()
    plays_for_seconds(page)
    assert page.evaluate("window.pictures") == 1


def test_a_browser_that_cannot_draw_in_three_dimensions_is_told_of_and_tries_once(opened, excused):  # R-X21
    excused.append("WebGL")
    page = opened(WHOLE)
    page.evaluate(COUNTED, False)
    page.get_by_role("button", name="Show the workcell").click()
    expect(page.get_by_text("This browser cannot draw in three dimensions")).to_be_visible()
    tries = page.evaluate("window.pictures")
    plays_for_seconds(page)
    expect(page.get_by_text("This browser cannot draw in three dimensions")).to_be_visible()
    assert page.evaluate("window.pictures") == tries


def test_a_cut_recording_plays_to_its_end_and_says_so(opened):  # R-X21: bad input
    page = opened(CUT)
    expect(page.get_by_text(re.compile("Cut short: it ends in the middle"))).to_be_visible()
    page.keyboard.press("End")
    expect(page.get_by_text("Under way")).to_be_visible()


def test_nothing_in_it_can_be_changed(opened):  # R-X21: it only plays
    page = opened(WHOLE)
    icon = page.locator(".workspace").get_by_role("option").nth(2)
    icon.click(button="right")
    expect(page.get_by_role("menu")).to_have_count(0)
    for name in ("Continue from here", "Compare with…", "Close the recording", "Save as icon…"):
        expect(page.get_by_role("button", name=name)).to_have_count(0)


def test_it_speaks_spanish_and_fits_a_small_window(opened):  # R-X21: English, Spanish
    page = opened(WHOLE, 900, 700)
    page.get_by_role("combobox", name="Language").first.select_option("es")
    expect(page.get_by_role("region", name="El programa en frases")).to_be_visible()
    assert page.evaluate("document.documentElement.scrollWidth") <= 900


def test_a_spoilt_file_says_so(new_page, folder):  # R-X21: bad input
    spoilt = Path(folder / "spoilt.html")
    text = (folder / f"{WHOLE}.html").read_text()
    at = text.index('id="run">') + 2000
    spoilt.write_text(text[:at] + "AAAA" * 20 + text[at + 80 :])
    page = new_page()
    page.goto(spoilt.as_uri())
    expect(page.get_by_text("This file cannot be played")).to_be_visible()
