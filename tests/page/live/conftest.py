"""A configuration that is connected, of which nothing lives any more in the end."""

import pytest
from playwright.sync_api import expect


@pytest.fixture(scope="module")
def program(begin, lab):
    """The environment with a runtime of two processing units in wall time."""
    return begin(f"--base={lab.path}", "--rtpu=rt0", "--rtpu=rt1")


@pytest.fixture
def me(program, page, people):
    """A person with a blank configuration that is connected; in the end nothing of it lives any more."""
    person = people(program.enter(page))
    name = person.blank()
    person.libraries("bench")
    page.locator("body").press("Alt+c")
    page.get_by_role("dialog", name=f"Connect {name}").get_by_role("button", name="Connect", exact=True).click()
    expect(page.get_by_role("button", name="Release")).to_be_visible(timeout=30_000)
    yield person
    if not page.is_closed():
        page.keyboard.press("Escape")
        person.canvas.evaluate("one => one.focus()")
        page.keyboard.press("Control+a")
        page.keyboard.press("Delete")
        expect(person.canvas.locator("[data-task]")).to_have_count(0)
