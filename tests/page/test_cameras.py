"""What cameras see stands below the workcell while somebody looks; a click makes a target of a point (F05, F08)."""

import os
import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


def test_pictures_of_a_camera_come_and_a_click_makes_a_target(begin, page):  # R-F05, R-F08, R-B10
    program = begin()
    program.enter(page)
    page.get_by_role("button", name="Applications", exact=True).click()
    page.locator("body").press("Control+o")
    opening = page.get_by_role("dialog", name="Open an application")
    opening.get_by_role("searchbox").fill("gantry_blue")
    opening.get_by_role("button", name="Open gantry_blue", exact=True).click()
    expect(opening).to_have_count(0)
    run = page.get_by_role("region", name="Run", exact=True)
    run.get_by_role("button", name=re.compile("^Run")).click()
    workcell = page.get_by_role("region", name="Workcell bench")
    workcell.get_by_role("button", name="2 cameras", exact=True).click(timeout=30_000)
    cameras = workcell.get_by_role("group", name="Cameras of bench")
    picture = cameras.get_by_role("img", name="What the camera wrist_bay sees")
    other = cameras.get_by_role("img", name="What the camera above sees")
    missing = page.get_by_text("cannot render")
    expect(picture.or_(missing).first).to_be_visible(timeout=30_000)
    if missing.is_visible():
        pytest.skip("this machine cannot render")
    expect(other).to_be_visible()
    expect(cameras).to_contain_text(re.compile(r"wrist_bay\s+\d+\.\d Hz · \d+\.\d s old"))
    if folder := os.environ.get("SHOTS"):
        page.screenshot(path=f"{folder}/camera.png")
        page.emulate_media(color_scheme="dark")
        page.set_viewport_size({"width": 900, "height": 700})
        page.screenshot(path=f"{folder}/camera_dark.png")
        page.emulate_media(color_scheme="light")
        page.set_viewport_size({"width": 1440, "height": 900})
    picture.click(position={"x": 20, "y": 10})
    panel = page.get_by_role("dialog", name="New target")
    expect(panel).to_contain_text("Taken from the picture.")
    if folder:
        page.screenshot(path=f"{folder}/camera_target.png")
    size = picture.bounding_box()
    words = [field.input_value() for field in panel.locator("input[id*=-value-]").all()]
    point = [int(word) for word in words if word.isdigit()][-2:]
    assert point == pytest.approx([320 * 20 / size["width"], 240 * 10 / size["height"]], abs=4)
