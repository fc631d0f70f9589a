"""Every puzzle, solved in the page: begun, missed, looked up in its hints, and solved."""

import re

import pytest
from playwright.sync_api import expect

from .solvings import SOLVINGS

pytestmark = [pytest.mark.page, pytest.mark.slow]


@pytest.mark.parametrize("number", range(len(SOLVINGS)), ids=list(SOLVINGS))
def test_a_puzzle_is_missed_and_then_solved_in_the_page(learner, number):  # R-G10, R-H07
    me = learner()
    me.takes("puzzles")
    expect(me.panel.locator("ol > li")).to_have_count(len(SOLVINGS))
    me.opens(number)
    expect(me.workspace.get_by_role("heading", level=1)).to_have_text(list(SOLVINGS)[number])
    me.puts(0, "noop")
    me.gets("puzzle.notYet")
    me.takes_out(1)
    me.takes_hints()
    list(SOLVINGS.values())[number](me)
    me.gets("puzzle.solved")
    expect(me.verdict).to_contain_text(me.t("puzzle.stars", n=3))
    expect(me.panel.get_by_text(re.compile(me.t("puzzle.tries", n="[2-4]")))).to_be_visible()
    me.has_done(1)
