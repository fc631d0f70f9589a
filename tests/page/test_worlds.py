"""One arm real, the other simulated: from the panel to the end of the run the page says which is which (E09)."""

import os
import re

import pytest
from playwright.sync_api import expect

from kit.labs.laboratory import Laboratory, job, joints
from kit.worlds.installed_world import install_world

from .run_end import runs_to_its_end

pytestmark = pytest.mark.page


def flow(first):
    """An arm goes to one side, and after a meeting to the other."""
    begin = joints("begin", first, -1.1, 2.2, 0.0, 0.7, 0.8, duration=1.0)
    end = joints("end", -first, -1.1, 2.2, 0.0, 0.7, 0.8, duration=1.5)
    return [job("jmoveC", "Joint job"), begin, job("jmoveC", "Joint job", "SYNCHTAG meet"), end]


@pytest.fixture(scope="module")
def program(begin, tmp_path_factory):
    """With a world that counts as real, and an application of two flows on one arm."""
    folder = tmp_path_factory.mktemp("onika")
    packages = folder / "packages"
    packages.mkdir()
    Laboratory(folder / "home" / "onika").application("twins", flow(0.8), flow(-0.6), parallel=True)
    with pytest.MonkeyPatch.context() as patch:
        search = filter(None, (str(install_world(packages, "cell")), os.environ.get("PYTHONPATH")))
        patch.setenv("PYTHONPATH", os.pathsep.join(search))
        return begin(folder=folder)


def test_one_arm_is_real_beside_a_simulated_one_and_each_flow_says_its_world(program, page):  # R-E09
    program.enter(page)
    page.get_by_role("button", name="Applications", exact=True).click()
    page.locator("body").press("Control+o")
    opening = page.get_by_role("dialog", name="Open an application")
    opening.get_by_role("searchbox").fill("twins")
    opening.get_by_role("button", name="Open twins", exact=True).click()
    run = page.get_by_role("region", name="Run", exact=True)
    workspace = page.get_by_role("region", name="Workspace")
    expect(run).to_contain_text("boxes:arm_left")  # which both flows would move: so it cannot run

    page.locator("body").press("Alt+i")
    panel = page.get_by_role("dialog", name="Redirect twins")
    panel.get_by_role("radio", name="flow 1", exact=True).check(force=True)
    worlds = panel.get_by_role("radiogroup", name="Which world stands for boxes")
    expect(worlds.get_by_role("radio", name=re.compile("^boxes( · simulated)? As the program says"))).to_be_checked()
    # the runtime is asked as soon as it is there
    expect(worlds.get_by_role("radio", name=re.compile("^boxes@flow1 · simulated a copy"))).to_be_visible(
        timeout=30_000
    )
    worlds.get_by_role("radio", name="cell · real").check()
    panel.get_by_role("button", name="Check before running").click()
    expect(panel.get_by_text("Checked: nothing keeps it from running.")).to_be_visible(timeout=30_000)
    panel.get_by_role("button", name="Close").last.click()

    marks = workspace.locator(".head [data-world]")
    expect(marks).to_have_text(["boxes · simulated", "cell · real"])
    expect(run.get_by_role("note", name="Redirected: boxes → cell in flow 1")).to_be_visible()
    expect(run.get_by_text("Ready to run")).to_be_visible()
    run.get_by_role("button", name=re.compile("^Run")).click()
    for number, world in enumerate(("boxes · simulated", "cell · real")):
        expect(run.get_by_role("group", name=f"flow {number}").locator("[data-world]")).to_have_text(world)
    expect(marks).to_have_text(["boxes · simulated", "cell · real"])
    workcells = page.get_by_role("group", name="Which workcell")
    expect(workcells.get_by_role("button", name="cell · real")).to_be_visible()
    page.reload()
    for number, world in enumerate(("boxes · simulated", "cell · real")):
        expect(run.get_by_role("group", name=f"flow {number}").locator("[data-world]")).to_have_text(world)
    runs_to_its_end(page)
    run.get_by_role("button", name="All as the program says").click()
    expect(marks).to_have_count(0)
