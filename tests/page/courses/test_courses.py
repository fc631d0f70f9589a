"""Every course of the page, walked from its first lesson to its last tick, and acts that get none."""

import re

import pytest
from playwright.sync_api import expect

from .walks import WALKS

pytestmark = [pytest.mark.page, pytest.mark.slow]


@pytest.mark.parametrize("language", ["en", "es"])
@pytest.mark.parametrize("course", WALKS)
def test_a_course_can_be_walked_as_its_words_say(learner, course, language):  # R-H07
    me = learner(language)
    me.takes(course)
    walk, lessons = WALKS[course]
    walk(me)
    me.has_done(lessons)


def test_what_only_looks_like_it_gets_no_tick(learner):  # R-H07
    me = learner()
    me.takes("loops")
    me.is_at("loopSee")
    me.begins()
    me.puts(0, "opengripC", "closegripC")  # a program of one's own is not the one to be looked at
    me.runs()
    me.has_run()
    me.is_at("loopSee")
    me.sees("wave_three")
    me.is_at("twoActions")  # the example itself is no program of one's own
    me.begins()
    me.puts(0, "opengripC", "jmoveC")
    me.is_at("twoActions")  # a hole is left
    me.takes("meetings")
    me.begins(2)
    me.puts(0, "opengripC")
    me.puts(3, "opengrip_rightC")
    me.tags(1, "A")
    me.tags(4, "B")
    me.is_at("meetSee")
    expect(me.panel.locator("li.done")).to_have_count(0)


def test_a_shipped_program_is_none_of_ones_own_and_a_changed_one_none_to_look_at(learner):  # R-H07
    me = learner()
    me.takes("loops")
    me.sees("wave_three")
    me.is_at("twoActions")
    me.begins()
    me.puts(0, "opengripC", "closegripC")
    me.repeats(1, 1, 2)
    me.is_at("loopRun")
    me.page.get_by_title(re.compile("wave_three.appl$")).click()  # its run is over, and it came round
    expect(me.workspace.get_by_role("heading", level=1)).to_have_text("wave_three")
    me.is_at("loopRun")
    me.takes_out(1)
    me.panel.get_by_role("button", name=me.t("tutorial.again")).click()
    me.is_at("loopSee")
    expect(me.lesson).to_contain_text(me.t("tutorial.changed", name="wave_three").partition(" (")[0])


def test_a_form_of_one_program_goes_when_another_comes(learner):
    me = learner()
    me.takes("loops")
    me.begins()
    me.puts(0, "opengripC", "closegripC")
    me.step(1).click()
    me.chooses(1, "upper.repeat")
    field = me.page.get_by_role("textbox", name=me.t("upper.howOften"))
    expect(field).to_be_visible()
    me.lesson.get_by_role("button", name=me.t("tutorial.open", name="wave_three")).click()
    expect(me.workspace.get_by_role("heading", level=1)).to_have_text("wave_three")
    expect(field).to_have_count(0)


def test_a_puzzle_whose_run_does_not_count_gets_no_tick(learner):  # R-G10, R-H07
    me = learner()
    me.takes("faults")
    me.opens(0)
    me.runs()
    expect(me.verdict).to_contain_text(me.t("puzzle.notYet"), timeout=60_000)
    expect(me.panel.locator("li.done")).to_have_count(0)
