"""The run of an application at the page: steered, explained, asked and told in words, with jobs that only wait."""

import os
import re
import signal

import pytest
from playwright.sync_api import expect

from kit.labs.laboratory import Laboratory, job, target
from kit.process.process_tree import runtime_of

pytestmark = pytest.mark.page

LONG, SHORT = "3600", "0.04"

SICK = '''"""A trigger that always fails."""

from onika.module import Module


class Sick(Module):
    trigger = True

    def cycle(self):
        raise ValueError("the sensor is dead")
'''

ROWS = (
    "MODULE  {0}\nDESC  {0}\nINCONST  none\nOUTCONST  none\nINVAR  none\nOUTVAR  none\nTASKTYPE  periodic\nFREQ  20\n"
)


def wait(seconds, *marks):
    """A pause of so many seconds, as two icons."""
    return job("pauseC", "Pause job", *marks) + target("for_a_while", "Pause object", seconds)


@pytest.fixture(scope="module")
def program(begin, tmp_path_factory):
    """With a runtime of its own, and small applications in its home."""
    folder = tmp_path_factory.mktemp("onika")
    own = Laboratory(folder / "home" / "onika")
    own.module("sick", SICK)
    own.task("sick", ROWS.format("sick"))
    own.configuration("sickC", "sick 20")
    own.application("slow", [wait(LONG), wait(SHORT), wait(LONG), wait(SHORT)])
    own.application("quick", [wait(SHORT), wait(SHORT)])
    own.application("fails", [job("sickC"), wait(SHORT)])
    own.application("asks", [job("pauseC", "Unheard job")])
    tagged = "SYNCHTAG    meet"
    own.application("meets", [wait(SHORT, tagged)], [wait(LONG), wait(SHORT, tagged)], parallel=True)
    return begin(folder=folder)


class Operator:
    """Somebody who runs what others have made."""

    def __init__(self, page):
        self.page = page
        self.run = page.get_by_role("region", name="Run", exact=True)
        self.keys = self.run.get_by_role("group", name="Run")
        self.workspace = page.get_by_role("region", name="Workspace")
        self.jobs = self.workspace.get_by_role("option", name=re.compile("; action "))
        self.beside = page.get_by_role("list", name="Running beside it")
        self.refusal = page.get_by_role("alertdialog", name="Refused")

    def opens(self, name):
        self.page.locator("body").press("Control+o")
        panel = self.page.get_by_role("dialog", name="Open an application")
        panel.get_by_role("searchbox").fill(name)
        panel.get_by_role("button", name=f"Open {name}", exact=True).click()
        expect(panel).to_have_count(0)

    def starts(self, name):
        self.opens(name)
        former = self.run.get_by_role("button", name="Dismiss")
        if former.is_visible():  # the result of an earlier run of it says the same words
            former.click()
            expect(former).to_have_count(0)
        self.run.get_by_role("button", name=re.compile("^Run")).click()

    def press(self, words):
        self.keys.get_by_role("button", name=words, exact=True).click()

    def ends_all(self):
        """Whatever still runs is ended, here and beside, so that the next story begins from nothing."""
        self.page.keyboard.press("Escape")
        while self.beside.is_visible():
            other = self.beside.get_by_role("button", name=re.compile("^Abort ")).first
            words = other.get_attribute("aria-label")
            other.click()
            expect(self.beside.get_by_role("button", name=words, exact=True)).to_have_count(0)
        if self.keys.get_by_role("button", name="Abort", exact=True).is_visible():
            self.press("Abort")
            expect(self.run.get_by_text("Ended early")).to_be_visible()

    def flow(self, number):
        return self.run.get_by_role("group", name=f"Flow {number}", exact=True)

    def went_well(self):
        expect(self.run.get_by_text(re.compile(r"Done: "))).to_be_visible()

    def ended_early(self, why):
        expect(self.run.get_by_text("Ended early")).to_be_visible()
        expect(self.run).to_contain_text(why)


@pytest.fixture
def me(program, page):
    program.enter(page)
    page.get_by_role("button", name="Applications", exact=True).click()
    operator = Operator(page)
    yield operator
    operator.ends_all()


def test_it_runs_to_its_end_and_says_so_in_words(me):  # R-E11, R-E14, R-E07
    me.starts("quick")
    me.went_well()
    expect(me.run).to_contain_text(re.compile(r"Done: all 2 actions"))
    expect(me.run).to_contain_text(re.compile(r"\d s"))


def test_a_flow_is_paused_after_its_action_steps_and_goes_on(me):  # R-E07, R-E13
    me.starts("slow")
    expect(me.flow(0)).to_contain_text("1 of 4")
    me.press("Pause")
    expect(me.flow(0)).to_contain_text("pauses after this")
    me.press("Skip to…")
    me.jobs.nth(1).click()
    expect(me.flow(0)).to_contain_text("is paused")
    me.press("Step")
    expect(me.flow(0)).to_contain_text("3 of 4")
    expect(me.flow(0)).to_contain_text("pauses after this")
    me.press("Skip to…")
    me.jobs.nth(3).click()
    expect(me.run.get_by_role("button", name="Continue", exact=True).first).to_be_visible()
    me.press("Continue")
    me.went_well()


def test_nothing_but_breakpoints_is_changed_while_it_runs(me):  # R-D18, R-E07
    me.starts("slow")
    expect(me.flow(0)).to_contain_text("1 of 4")
    expect(me.workspace.locator("header")).to_contain_text("Locked while it runs.")
    me.jobs.first.click()
    me.page.keyboard.press("Delete")
    me.page.keyboard.press("m")
    expect(me.jobs.first).to_have_attribute("aria-label", re.compile("breakpoint"))
    expect(me.jobs).to_have_count(4)
    me.page.keyboard.press("m")
    expect(me.jobs.first).not_to_have_attribute("aria-label", re.compile("breakpoint"))
    me.press("Abort")
    me.ended_early("aborted by the user")


def test_run_twice_and_in_two_browsers_is_one_run(me, program, new_page):  # R-E12, R-X01
    other = Operator(program.enter(new_page()))
    other.page.get_by_role("button", name="Applications", exact=True).click()
    for person in (me, other):
        person.opens("slow")
    buttons = [person.run.get_by_role("button", name=re.compile("^Run")).element_handle() for person in (me, other)]
    for button in buttons:
        button.evaluate("button => { button.click(); button.click() }")
    for person in (me, other):
        expect(person.flow(0)).to_contain_text("1 of 4")
    other.press("Abort")
    for person in (me, other):
        person.ended_early("aborted by the user")


def test_two_run_side_by_side_and_each_is_steered_where_it_is_seen(me):  # R-C18, R-E12, R-E07
    beside = me.beside
    me.starts("slow")
    expect(me.flow(0)).to_contain_text("1 of 4")
    me.opens("meets")
    me.run.get_by_role("button", name=re.compile("^Run")).click()
    expect(me.flow(1)).to_contain_text("1 of 2")
    expect(beside).to_contain_text("slow")
    expect(beside).to_contain_text("Running")
    me.press("Pause")
    expect(me.flow(1)).to_contain_text("pauses after this")
    expect(beside).to_contain_text("Running")
    beside.get_by_role("button", name="slow", exact=True).click()
    expect(me.flow(0)).to_contain_text("1 of 4")
    expect(beside).to_contain_text("meets")
    beside.get_by_role("button", name="Abort meets").click()
    expect(beside).to_have_count(0)
    expect(me.flow(0)).to_contain_text("1 of 4")
    me.press("Abort")
    me.ended_early("aborted by the user")


def test_who_waits_for_whom_is_shown_and_the_waiting_one_released(me):  # R-X03, R-E07
    me.starts("meets")
    expect(me.flow(0)).to_contain_text("waits at meet for Flow 1")
    me.flow(0).get_by_role("button", name="Release: Flow 0").click()
    expect(me.flow(0)).to_contain_text("has done all")
    me.flow(1).get_by_role("button", name="Next: Flow 1").click()
    me.went_well()


def test_flows_that_meet_begin_together(me):  # R-X03, R-E04
    me.starts("meets")
    expect(me.flow(0)).to_contain_text("waits at meet for Flow 1")
    me.flow(1).get_by_role("button", name="Next: Flow 1").click()
    me.went_well()
    expect(me.run).to_contain_text("at meet")


def test_a_stop_is_explained_and_the_choice_is_carried_out(me):  # R-X06, R-E08
    me.starts("fails")
    why = me.page.get_by_role("dialog", name=re.compile("stopped at"))
    expect(why).to_contain_text("the sensor is dead")
    for choice in ("Try again", "Leave this action", "Go on with another action", "End the run"):
        expect(why.get_by_role("button", name=re.compile(choice))).to_be_visible()
    why.get_by_role("button", name=re.compile("Leave this action")).click()
    me.went_well()


def test_to_try_again_fails_again_and_the_run_can_be_ended(me):  # R-X06, R-E08, R-E14
    me.starts("fails")
    why = me.page.get_by_role("dialog", name=re.compile("stopped at"))
    why.get_by_role("button", name=re.compile("Try again")).click()
    expect(why).to_contain_text("the sensor is dead")
    why.get_by_role("button", name=re.compile("End the run")).click()
    me.ended_early("ended by you, after: cycle: ValueError: the sensor is dead")


def test_the_last_seconds_are_kept_at_the_stop_and_at_the_end_and_can_be_looked_at(me):  # R-X05, R-X06
    me.starts("fails")
    why = me.page.get_by_role("dialog", name=re.compile("stopped at"))
    expect(why.get_by_role("button", name="Look at the last seconds")).to_be_visible()
    why.get_by_role("button", name=re.compile("End the run")).click()
    me.ended_early("ended by you, after: cycle: ValueError: the sensor is dead")
    me.run.get_by_role("button", name="Look at the last seconds").click()
    expect(me.page.get_by_text("Recording of fails")).to_be_visible()
    me.page.get_by_role("button", name="Close the recording").click()


def test_what_a_task_is_not_told_it_asks_in_a_form(me):  # R-E15, R-D16, R-C13
    me.starts("asks")
    panel = me.page.get_by_role("dialog", name=re.compile("asks$"))
    field = panel.get_by_role("textbox", name=re.compile("^duration,"))
    for nonsense, complaint in (("soon", "no number"), ("NaN", "no"), ("1e999", "no"), ("-1", "below")):
        field.fill(nonsense)
        expect(panel).to_contain_text(re.compile(complaint))
    field.fill("0.04")
    panel.get_by_role("button", name="Send").click()
    me.went_well()


def test_a_lost_runtime_ends_the_run_with_its_reason_and_the_next_run_has_another(me, program):  # R-E10
    me.starts("slow")
    expect(me.flow(0)).to_contain_text("1 of 4")
    os.kill(runtime_of(program.process.pid), signal.SIGKILL)
    me.ended_early("the runtime is lost")
    me.starts("quick")
    me.went_well()


def test_the_workcell_is_put_back(me):  # R-E12
    me.starts("quick")
    me.went_well()
    me.run.get_by_role("button", name="Put the workcell back").click()
    expect(me.page.get_by_text(re.compile("the workcell is back")).first).to_be_visible()


def test_a_browser_that_comes_back_in_mid_run_sees_it(me):  # R-E11, R-X10
    me.starts("slow")
    expect(me.flow(0)).to_contain_text("1 of 4")
    me.page.reload()
    expect(me.flow(0)).to_contain_text("1 of 4")
    me.press("Abort")
    me.ended_early("aborted by the user")
