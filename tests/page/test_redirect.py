"""Another robot for a program, and the look at it before it runs: from the start icon's menu to the end of the run."""

import re

import pytest
from playwright.sync_api import expect

from kit.labs.laboratory import Laboratory, job, joints

from .run_end import runs_to_its_end

pytestmark = pytest.mark.page

ABOVE = (0.181442, -0.625356, 2.700589, 0.0, 1.06636, 1.752238)
LEANING = (0.2, -0.6, 2.7, 0.0, 0.0, 0.0)
"""Within the reach of a PUMA; a SCARA only holds its hand upright."""


@pytest.fixture(scope="module")
def program(begin, tmp_path_factory):
    """With a runtime of its own, and small applications in its home."""
    folder = tmp_path_factory.mktemp("onika")
    own = Laboratory(folder / "home" / "onika")
    own.application("reach", [job("jmoveC", "Joint job"), joints("there", *ABOVE, duration=2.0)])
    own.application("twice", [job("jmoveC", "Joint job"), joints("there", *ABOVE, duration=2.0)] * 2)
    for name in ("lean", "crooked"):
        own.application(name, [job("jmoveC", "Joint job"), joints("leaning", *LEANING, duration=2.0)])
    return begin(folder=folder)


class Operator:
    """Somebody who has another robot than the one a program was made for."""

    def __init__(self, page):
        self.page = page
        self.run = page.get_by_role("region", name="Run", exact=True)
        self.workspace = page.get_by_role("region", name="Workspace")
        self.refusal = page.get_by_role("alertdialog", name="Refused")
        self.card = self.workspace.get_by_role("tooltip")

    def opens(self, name):
        self.page.locator("body").press("Control+o")
        panel = self.page.get_by_role("dialog", name="Open an application")
        panel.get_by_role("searchbox").fill(name)
        panel.get_by_role("button", name=f"Open {name}", exact=True).click()
        expect(panel).to_have_count(0)

    def icon(self, step):
        return self.workspace.locator(f'[data-step="{step}"]')

    def mark(self, kind, of):
        """A mark on an icon: `fault`, `note`, `redirect`."""
        return self.workspace.locator(f'[data-{kind}="{of}"]')

    def panel(self, name):
        return self.page.get_by_role("dialog", name=f"Redirect {name}")

    def seat(self, name, task):
        return self.panel(name).get_by_role("radiogroup", name=f"Who stands for {task}")

    def checks(self):
        self.page.locator("body").press("Alt+k")

    def runs(self):
        self.run.get_by_role("button", name=re.compile("^Run")).click()


@pytest.fixture
def me(program, page):
    program.enter(page)
    page.get_by_role("button", name="Applications", exact=True).click()
    return Operator(page)


def choose(me, name, other):
    """By keyboard alone."""
    me.page.locator("body").press("Alt+i")
    radio = me.seat(name, "puma").get_by_role("radio", name=re.compile(rf"^{other} the"))
    radio.focus()
    me.page.keyboard.press("Space")
    expect(radio).to_be_checked()
    me.page.keyboard.press("Escape")
    expect(me.panel(name)).to_have_count(0)


@pytest.mark.slow
def test_another_robot_is_chosen_at_the_start_icon_and_does_the_program(me):  # R-E09, R-X02
    me.opens("reach")
    me.icon(0).click(button="right")
    me.page.get_by_role("menuitem", name="Redirect…").click()
    panel = me.panel("reach")
    expect(me.seat("reach", "puma").get_by_role("radio", name="puma As the program says")).to_be_checked()
    expect(panel.get_by_text("Generic tasks")).to_be_visible()
    expect(panel.get_by_text("jtraj", exact=True).first).to_be_hidden()
    me.seat("reach", "puma").get_by_role("radio", name=re.compile("^scara the")).check()
    panel.get_by_role("button", name="Check before running").click()
    expect(panel.get_by_text("Checked: nothing keeps it from running.")).to_be_visible()
    panel.get_by_role("button", name="Close").last.click()
    expect(me.mark("redirect", 0)).to_be_visible()
    expect(me.workspace.get_by_role("button", name=re.compile("^Redirected: puma → scara"))).to_be_visible()
    expect(me.run.get_by_role("note", name="Redirected: puma → scara")).to_contain_text("The file is not changed.")
    expect(me.page.get_by_role("region", name="The program as sentences")).to_contain_text("puma → scara")
    expect(me.mark("note", 2)).to_be_visible()
    me.icon(2).hover()
    expect(me.card).to_contain_text("there is re-resolved for scara, by the pose that it is for puma")
    me.runs()
    runs_to_its_end(me.page)
    me.run.get_by_role("button", name="All as the program says").click()
    expect(me.mark("redirect", 0)).to_have_count(0)
    expect(me.mark("note", 2)).to_have_count(0)
    expect(me.page.locator(".tabs")).not_to_contain_text("•")


def test_a_target_that_the_other_robot_does_not_reach_is_marked_on_its_icon(me):  # R-X02, R-X01
    me.opens("lean")
    choose(me, "lean", "scara")
    me.checks()
    expect(me.mark("fault", 2)).to_be_visible()
    me.icon(2).hover()
    expect(me.card).to_contain_text("scara cannot come to “a target”: the hand would lean")
    expect(me.icon(2)).to_have_attribute("aria-label", re.compile("fault: scara cannot come to"))
    fault = me.run.get_by_role("listitem").filter(has_text="the hand would lean")
    fault.get_by_role("button", name="Let puma do it again").click()
    expect(me.mark("fault", 2)).to_have_count(0)
    expect(me.mark("redirect", 0)).to_have_count(0)


def test_a_run_that_is_refused_marks_the_icons_too_and_may_be_tried_again(me):  # R-X02, R-E01
    me.opens("crooked")
    choose(me, "crooked", "scara")
    expect(me.run.get_by_text("Ready to run")).to_be_visible()
    me.runs()
    expect(me.refusal).to_contain_text("crooked cannot run: scara cannot come to “a target”")
    expect(me.mark("fault", 2)).to_be_visible()
    expect(me.run.get_by_role("button", name=re.compile("^Run"))).to_be_enabled()
    me.refusal.get_by_role("button", name="Let puma do it again").click()
    expect(me.mark("fault", 2)).to_have_count(0)


def test_each_flow_has_its_own_and_who_cannot_is_told_why(me):  # R-E09, R-X01
    me.opens("two_arms")
    me.page.locator("body").press("Alt+i")
    panel = me.panel("two_arms")
    expect(panel.get_by_role("radio", name="Every flow")).to_be_checked()
    panel.get_by_role("radio", name="flow 0", exact=True).check(force=True)
    expect(panel.get_by_role("radio", name=re.compile("^puma_right the"))).to_have_count(0)
    expect(panel.get_by_role("listitem").filter(has_text="puma_right:")).to_contain_text(
        "its device boxes:arm_right is claimed by puma_right"
    )
    me.seat("two_arms", "puma").get_by_role("radio", name=re.compile("^puma_kin the")).check()
    expect(me.mark("redirect", 0)).to_be_visible()
    expect(me.mark("redirect", 1)).to_have_count(0)
    expect(me.run.get_by_role("note", name="Redirected: puma → puma_kin in flow 0")).to_be_visible()


@pytest.mark.slow
def test_a_work_is_ended_redirected_and_gone_on_with_where_it_stood(me):  # R-K06, R-E09
    me.opens("twice")
    me.runs()
    me.run.get_by_role("button", name="Pause", exact=True).first.click()
    expect(me.run.get_by_text(re.compile("paused", re.IGNORECASE)).first).to_be_visible(timeout=20_000)
    me.run.get_by_role("button", name="Abort", exact=True).first.click()
    expect(me.run.get_by_text("Ended early")).to_be_visible(timeout=20_000)
    choose(me, "twice", "puma_kin")
    me.run.get_by_role("button", name="Go on from here").click()
    runs_to_its_end(me.page)
    expect(me.run.get_by_text("Done: 1 action")).to_be_visible()
