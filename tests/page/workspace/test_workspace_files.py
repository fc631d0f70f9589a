"""What the workspace makes of files: written by hand, strange, broken, changed meanwhile, and become an icon."""

import re

import pytest
from playwright.sync_api import expect

from kit.labs.laboratory import Laboratory, job, joints
from onika.store.shipped import shipped

from .builder import CLOSE, OPEN, Builder

pytestmark = pytest.mark.page


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A home with a dictionary and applications of its own, some of them strange."""
    folder = tmp_path_factory.mktemp("onika")
    own = Laboratory(folder / "home" / "onika")
    own.application("by_hand", [job("jmoveC", "Joint job"), joints("home", 0, 0, 0, 0, 0, 0)])
    own.application("strange", [job("jmoveC", "Unheard job"), job("opengripC")])
    own.application("half", [job("opengripC"), job("vanishedC")])
    broken = own.application("broken", [job("opengripC"), job("closegripC")])
    broken.write_text(broken.read_text()[:-200])
    twice = shipped() / "generic" / "dict" / "ten.onk"
    (own.path / "dict").mkdir()
    (own.path / "dict" / "ten.onk").write_text(twice.read_text().replace("ten times", "ten times here"))
    return folder


@pytest.fixture(scope="module")
def program(begin, folder):
    return begin("--no-connect", folder=folder)


@pytest.fixture
def empty(program, page):
    """Somebody with no application in front."""
    program.enter(page)
    page.get_by_role("button", name="Applications", exact=True).click()
    builder = Builder(page)
    expect(builder.icon("opengripC")).to_be_attached()
    return builder


@pytest.fixture
def me(empty):
    """Somebody with a blank application of one flow in front."""
    empty.blank()
    return empty


def test_what_was_written_by_hand_opens_and_is_read_as_sentences(empty):  # R-D14, R-X11
    empty.opens("by_hand")
    expect(empty.steps).to_have_count(4)
    empty.says("Complete.")
    expect(empty.page.get_by_role("region", name="The program as sentences")).to_contain_text("1")


def test_an_unknown_type_acts_as_a_complete_job_and_is_told(empty):  # R-D16
    empty.opens("strange")
    expect(empty.steps).to_have_count(4)
    expect(empty.page.get_by_role("button", name=re.compile("acts as Complete job"))).to_be_visible()


def test_a_missing_configuration_is_a_fault_that_leads_to_its_icon(empty):  # R-E01, R-D04
    empty.opens("half")
    run = empty.page.get_by_role("region", name="Run", exact=True)
    run.get_by_role("button", name=re.compile("no configuration vanishedC")).click()
    expect(empty.step(2)).to_have_attribute("aria-selected", "true")
    expect(run.get_by_role("button", name=re.compile("^Run "))).to_be_disabled()


def test_a_broken_file_opens_as_far_as_it_goes_and_is_not_overwritten_unasked(empty, folder):  # R-B07, R-X01
    path = folder / "home" / "onika" / "appl" / "broken.appl"
    before = path.read_text()
    empty.opens("broken")
    expect(empty.steps).to_have_count(4)
    empty.page.locator("body").press("Control+s")
    expect(empty.refusal).to_contain_text("would be lost")
    assert path.read_text() == before


def test_what_changes_on_the_disk_meanwhile_is_told_and_nothing_is_lost(me, folder):  # R-X10
    me.insert("opengripC")
    me.page.locator("body").press("Control+s")
    panel = me.page.get_by_role("dialog")
    panel.get_by_role("textbox").first.fill("shared")
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(panel).to_have_count(0)
    me.insert("closegripC")
    path = folder / "home" / "onika" / "appl" / "shared.appl"
    path.write_text(path.read_text().replace("opengripC", "closegripC"))
    expect(me.page.get_by_text(re.compile("changed on the disk")).first).to_be_visible()
    me.has(OPEN, CLOSE)
    me.page.locator("body").press("Control+s")
    expect(me.refusal).to_contain_text("has changed since it was read")


def test_an_application_becomes_an_icon_or_it_is_said_why_not(me):  # R-D09
    me.insert("opengripC")
    me.page.get_by_role("button", name="As icon…").click()
    expect(me.page.get_by_text(re.compile("has no file yet")).first).to_be_visible()


def test_the_panel_of_the_icon_that_is_asked_for_while_the_file_is_saved_stays(program, new_page):  # R-D09
    page, held, is_held = new_page(), [], []

    def through(ours):
        server = ours.connect_to_server()
        server.on_message(lambda message: held.append(message) if is_held else ours.send(message))
        page.answers = lambda: [ours.send(held.pop(0)) for _ in range(len(held))]

    page.route_web_socket(re.compile("/ws"), through)
    builder = Builder(program.enter(page))
    page.get_by_role("button", name="Applications", exact=True).click()
    expect(builder.icon("opengripC")).to_be_attached()
    builder.blank()
    builder.insert("opengripC")
    page.locator("body").press("Control+s")
    saving = page.get_by_role("dialog")
    saving.get_by_role("textbox").first.fill("quick")
    is_held.append(True)
    saving.get_by_role("button", name="Save", exact=True).click()
    page.get_by_role("button", name="As icon…").click()
    panel = page.get_by_role("dialog", name=re.compile("as an icon"))
    expect(panel).to_contain_text("Asking what icon this would make")
    is_held.clear()
    page.answers()
    expect(panel).to_contain_text("Complete application")


def test_with_holes_of_one_type_it_takes_such_a_target(empty, folder):  # R-D09
    empty.blank()
    empty.insert("jmoveC")
    empty.page.locator("body").press("Control+s")
    panel = empty.page.get_by_role("dialog")
    panel.get_by_role("textbox").first.fill("go_there")
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(panel).to_have_count(0)
    empty.page.get_by_role("button", name="As icon…").click()
    panel = empty.page.get_by_role("dialog")
    expect(panel).to_contain_text("Joint application")
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(empty.icon("go_there")).to_be_attached()
    assert "ONIKON" in (folder / "home" / "onika" / "dict" / "go_there.onk").read_text()


def test_a_name_counts_once_over_all_dictionaries_and_the_later_one_is_told(empty):  # R-D15
    expect(empty.icon("ten")).to_have_count(1)
    expect(empty.icon("ten")).to_have_text("ten times here")
    expect(empty.page.get_by_text(re.compile("the name ten once in all dictionaries")).first).to_be_attached()


def test_parallel_flows_become_no_icon_where_one_of_them_lacks_an_action(empty):  # R-D09
    empty.blank(2, "Several flows, side by side")
    empty.insert("jmoveC")
    empty.page.locator("body").press("Control+s")
    panel = empty.page.get_by_role("dialog")
    panel.get_by_role("textbox").first.fill("half_parallel")
    panel.get_by_role("button", name="Save", exact=True).click()
    expect(panel).to_have_count(0)
    empty.page.get_by_role("button", name="As icon…").click()
    expect(empty.page.get_by_text("flow 1 is empty").first).to_be_visible()
