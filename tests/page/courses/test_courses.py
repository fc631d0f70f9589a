"""Every course of the page, walked from its first lesson to its last tick, and acts that get none."""

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


def test_a_puzzle_whose_run_does_not_count_gets_no_tick(learner):  # R-G10, R-H07
    me = learner()
    me.takes("faults")
    me.opens(0)
    me.runs()
    expect(me.verdict).to_contain_text(me.t("puzzle.notYet"), timeout=60_000)
    expect(me.panel.locator("li.done")).to_have_count(0)
