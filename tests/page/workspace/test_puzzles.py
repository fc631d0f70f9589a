"""Puzzles in the page: begun, missed, solved, and what is kept of that."""

import re

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


@pytest.fixture(scope="module")
def program(begin):
    return begin("--upper")


@pytest.fixture
def user(program, page):
    """Somebody who has opened the puzzles."""
    page.goto(program.address())
    page.get_by_role("button", name="Puzzles", exact=True).click()
    return page


def panel(page, name):
    return page.get_by_role("dialog", name=name)


def put(page, *words):
    dictionary = page.get_by_role("complementary", name="Dictionary", exact=True)
    for word in words:
        dictionary.get_by_text(word, exact=True).first.dblclick()


def run(page):
    page.get_by_role("button", name=re.compile(r"^(Run |Put back and run)")).first.click()


def test_a_puzzle_is_missed_then_solved_and_the_best_result_stays(user):  # R-G10
    puzzles = panel(user, "Puzzles")
    first = puzzles.get_by_role("button", name="Out of the way")
    expect(first).to_have_attribute("aria-expanded", "true")  # it is the next one that is not solved
    puzzles.get_by_role("button", name="Begin", exact=True).click()
    expect(user.get_by_text("Nothing happens yet.")).to_be_visible()
    put(user, "move the joints", "straight up, out of the way")
    run(user)
    expect(puzzles.get_by_text("Not yet", exact=True)).to_be_visible(timeout=30_000)
    expect(puzzles.get_by_text("the arm is at the left, away from the table: not yet so")).to_be_visible()
    expect(puzzles.get_by_text("Tries so far: 1")).to_be_visible()
    puzzles.get_by_role("button", name="Hint (2 left)").click()
    expect(puzzles.get_by_text("Hint 1:")).to_be_visible()
    user.locator("[data-step]").nth(2).click()
    user.keyboard.press("Delete")
    put(user, "to the left, away from the table")
    run(user)
    expect(puzzles.get_by_text("Solved")).to_be_visible(timeout=30_000)
    user.reload()
    expect(puzzles.get_by_role("img", name=re.compile("of 3 stars"))).to_be_visible()
