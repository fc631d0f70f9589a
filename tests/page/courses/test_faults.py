"""Every planted fault, mended in the page with what it shows."""

import pytest
from playwright.sync_api import expect

from .mendings import MENDINGS

pytestmark = [pytest.mark.page, pytest.mark.slow]


@pytest.mark.parametrize("number", range(len(MENDINGS)), ids=list(MENDINGS))
def test_a_planted_fault_is_mended_in_the_page(learner, number):  # R-H07
    me = learner()
    me.takes("faults")
    expect(me.panel.locator("ol > li")).to_have_count(len(MENDINGS))
    me.opens(number)
    expect(me.workspace.get_by_role("heading", level=1)).to_have_text(list(MENDINGS)[number])
    list(MENDINGS.values())[number](me)
    me.gets("puzzle.mended")
