"""How each course is walked from its first lesson to its last tick, as its words say."""

import re
from collections.abc import Callable

from playwright.sync_api import expect

from .learner import PATIENCE_MS, SHIFT, Learner


def first(me: Learner) -> None:
    """The tutorial: every deed by the mouse, as it is told."""
    me.is_at("new")
    me.begins()
    me.is_at("complete")
    me.puts(0, "opengripC")
    me.is_at("job")
    me.puts(1, "jmoveC")
    me.is_at("fill")
    me.holes.click()
    me.icon("box2_aj").click()
    me.holes.click(button="right")
    me.is_at("out")
    me.step(3).click()
    me.page.keyboard.press("Delete")
    me.is_at("back")
    me.page.keyboard.press("Control+z")
    me.is_at("run")
    me.runs()
    me.is_at("pause")
    me.says("perform.pause")
    me.is_at("goOn")
    me.says("perform.continue")
    me.is_at("end")
    me.has_run()
    me.is_at("save")
    me.saves("my_first")


def loops(me: Learner) -> None:
    me.is_at("loopSee")
    me.sees("wave_three")
    me.is_at("twoActions")
    me.begins()
    me.puts(0, "opengripC", "closegripC")
    me.is_at("loop")
    me.repeats(1, 1, 2)
    me.is_at("loopRun")
    me.runs()
    me.is_at("loopWithin")
    me.has_run()
    me.repeats(1, 3, 3)
    me.runs()


def branches(me: Learner) -> None:
    me.is_at("branchSee")
    me.sees("see_the_lamp")
    me.is_at("branch")
    me.begins()
    me.puts(0, "opengripC", "closegripC")
    me.branches(2, 2, "LAMP == 1")
    me.is_at("branchFlows")
    me.fills("opengripC", "closegripC")
    me.is_at("branchRun")
    me.runs()
    me.is_at("branchMiddle")
    me.has_run()
    me.branches(3, 3, "LAMP == 1", "GRIP_MEZ[0] < 0.07")
    me.fills("closegripC", "noop", "opengripC")
    me.runs()


def meetings(me: Learner) -> None:
    me.is_at("meetSee")
    me.sees("both_wave")
    me.is_at("twoFlows")
    me.begins(2)
    me.is_at("tags")
    me.puts(0, "opengripC", "closegripC")
    me.puts(4, "opengrip_rightC", "closegrip_rightC")
    me.tags(1, "A")
    me.tags(5, "A")
    me.is_at("meet")
    me.runs()
    me.is_at("meetTwice")
    me.has_run()
    me.tags(2, "B")
    me.tags(6, "B")
    me.runs()


def arms(me: Learner) -> None:
    me.is_at("armsSee")
    me.sees("two_arms")
    me.is_at("armsFlows")
    me.begins(2)
    me.puts(0, "jmoveC", "aside")
    me.puts(4, "jmove_rightC", "aside")
    me.is_at("armsRun")
    me.runs()
    me.is_at("armsWait")
    me.has_run()
    me.puts(6, "jmove_rightC", "home")
    me.tags(1, "A")
    me.tags(7, "A")
    me.runs()


def nesting(me: Learner) -> None:
    me.is_at("nestSee")
    me.sees("visit_boxes")
    me.is_at("nestInside")
    me.step(1).click(modifiers=SHIFT)
    me.is_at("nestUse")
    me.begins()
    me.puts(0, "visit", "box2_aj")
    me.is_at("nestRun")
    me.runs()
    me.is_at("nestOwn")
    me.has_run()
    me.begins()
    me.puts(0, "opengripC", "closegripC")
    me.saves("greet")
    me.page.get_by_role("button", name=me.t("upper.asIcon")).click()
    panel = me.page.get_by_role("dialog", name=me.t("iconify.title", name="greet"))
    panel.get_by_role("button", name=me.t("icon.save"), exact=True).click()
    expect(panel).to_have_count(0)
    me.begins()
    me.puts(0, "greet")
    me.runs()


def seeking(me: Learner) -> None:
    me.is_at("seekSee")
    me.sees("try_to_grasp")
    me.is_at("seekRefused")
    me.step(3).click()
    me.page.keyboard.press("Delete")
    me.is_at("seekMended")
    me.page.keyboard.press("Control+z")
    me.is_at("seekStops")
    me.step(1).click()
    me.page.keyboard.press("Delete")
    me.puts(0, "closegripC")
    me.runs()
    me.is_at("seekOwn")
    me.page.get_by_role("button", name=re.compile(me.t("stopped.abort"))).first.click()
    expect(me.run_panel.get_by_text(me.t("perform.ended")).first).to_be_visible(timeout=PATIENCE_MS)
    me.step(1).click()
    me.page.keyboard.press("Control+z")
    me.page.keyboard.press("Control+z")
    me.step(6).click()
    me.page.keyboard.press("Delete")
    me.runs()


WALKS: dict[str, tuple[Callable[[Learner], None], int]] = {
    "first": (first, 11),
    "loops": (loops, 5),
    "branches": (branches, 5),
    "meetings": (meetings, 5),
    "arms": (arms, 4),
    "nesting": (nesting, 5),
    "seeking": (seeking, 5),
}
"""By course, with how many lessons it has."""
