"""A session that somebody did in the page is replayed in the page (requirement H08)."""

import shutil

import pytest
from playwright.sync_api import expect

from ..person import Person
from ..run_end import runs_to_its_end

pytestmark = pytest.mark.page


@pytest.fixture(scope="module")
def session(begin, lab, tmp_path_factory):
    """A program whose base directory stands as it was at first beside it."""
    before = tmp_path_factory.mktemp("before") / lab.path.name
    shutil.copytree(lab.path, before)
    return begin(f"--base={lab.path}", "--no-connect"), before


def test_a_session_is_done_again_in_the_page_to_the_same_files(session, begin, lab, new_page, excused, tmp_path):
    program, before = session  # R-H08, R-H01
    me = Person(program.enter(new_page()))
    name = me.blank()
    me.libraries("bench")
    me.place("wave", "gain")
    me.drag(me.box("wave"), 320, 300)
    me.page.keyboard.press("F1")
    expect(me.page.get_by_role("dialog", name="Help")).to_be_visible()
    me.page.keyboard.press("Escape")
    me.page.keyboard.press("Control+s")
    me.page.get_by_role("dialog").get_by_label("Name", exact=True).fill("drawn")
    me.page.get_by_role("dialog").get_by_role("button", name="Save", exact=True).click()
    expect(me.tab("drawn")).to_be_visible()
    corner = me.corner("wave")
    excused.append("CONNECTION_REFUSED|WebSocket")
    program.end()
    (log,) = program.state.rglob("diary/*.log")
    text = log.read_text()
    for event in ("end_drag", "read_help", "close_view", "type_value", "insert_icon", "show_level", "save_conf"):
        assert f"\t{event}\t" in text, event
    assert str(program.home) not in text

    saved = {path: path.read_bytes() for path in lab.path.rglob("*.conf")}
    out = tmp_path / "out"
    again = begin(str(log), f"--base={before}", f"--to={out}", "--speed=0.1", command=("study", "replay"))
    page = new_page()
    page.goto(again.address())
    bar = page.get_by_role("region", name="Replayed session")
    bar.get_by_role("button", name="Step").click()
    bar.get_by_role("combobox").select_option("1000")
    bar.get_by_role("button", name="Play").click()
    expect(bar.get_by_role("button", name="Step")).to_be_disabled(timeout=30_000)
    watcher = Person(page)
    expect(watcher.box("wave")).to_be_visible()
    assert watcher.corner("wave") == corner
    expect(watcher.tab("drawn")).to_be_visible()
    expect(bar.get_by_text("not as it was")).to_have_count(0)
    watcher.page.keyboard.press("Alt+n")
    expect(watcher.refusal.get_by_text("a session is replayed here")).to_be_visible()
    again.end()
    rebuilt = out / "base0" / lab.path.name
    assert {rebuilt / path.relative_to(lab.path): content for path, content in saved.items()} == {
        path: path.read_bytes() for path in rebuilt.rglob("*.conf")
    }
    assert name != "drawn"


def test_a_session_with_a_run_says_what_its_log_does_not_hold_and_asks_for_no_level_that_is_hidden(
    begin, new_page, excused
):  # R-H08
    program = begin("--upper")
    page = new_page()
    page.goto(program.address())
    page.get_by_role("button", name="New application").first.click()
    page.get_by_role("dialog").get_by_role("button", name="Begin", exact=True).click()
    page.locator("#onikon-opengripC").dblclick()
    page.get_by_role("button", name="Run Untitled").click()
    runs_to_its_end(page)
    excused.append("CONNECTION_REFUSED|WebSocket")
    program.end()
    (log,) = program.state.rglob("diary/*.log")
    again = begin(str(log), "--speed=1000", command=("study", "replay"))
    page = new_page()
    page.goto(again.address())
    bar = page.get_by_role("region", name="Replayed session")
    bar.get_by_role("button", name="Play").click()
    expect(bar.get_by_role("button", name="Step")).to_be_disabled(timeout=30_000)
    expect(page.get_by_text("is not in the log of a session")).to_be_visible()
    expect(page.get_by_text("Looking at it")).to_have_count(0)
    expect(page.get_by_role("alertdialog", name="Refused")).to_have_count(0)
    again.end()
