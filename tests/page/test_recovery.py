"""What was not saved outlives a crash."""

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


def test_what_was_not_saved_is_there_again_after_the_program_was_killed(begin, lab, page, people):  # R-X10
    first = begin(f"--base={lab.path}", "--no-connect")
    me = people(first.enter(page))
    name = me.blank()
    me.libraries("bench")
    me.place("wave", "calm")
    corner = me.corner("calm")
    kept = first.state / "onika" / "recovery"
    while not any(b"calm" in path.read_bytes() for path in kept.rglob("*") if path.is_file()):
        expect(me.box("calm")).to_be_visible()
    page.goto("about:blank")
    first.kill()
    second = begin(f"--base={lab.path}", "--no-connect", folder=first.home.parent)
    me = people(second.enter(page))
    me.tab(name).click()
    me.stands("calm", *corner)
    expect(me.tab(name)).to_have_accessible_name(f"{name} changed, not saved")
