"""A running application that is looked into, and one that takes over what lives, and puts it back."""

import re

import pytest
from playwright.sync_api import expect

from kit.labs.laboratory import Laboratory, job

pytestmark = pytest.mark.page

TICK = '''"""A trigger that counts and never ends."""

from onika.module import Module, OutVar


class Tick(Module):
    trigger = True
    COUNT = OutVar("double", "-", "how often it was called")

    def cycle(self):
        self.COUNT = self.COUNT + 1.0
'''
BEAT = """from onika.module import Module


class Beat(Module):
    def cycle(self):
        return None
"""
BRIEF = """from onika.module import Module, finish


class Brief(Module):
    trigger = True

    def cycle(self):
        return finish()
"""
ROWS = "MODULE  {0}\nDESC  {0}\nINCONST  none\nOUTCONST  none\nINVAR  none\nOUTVAR  {1}\nTASKTYPE  periodic\nFREQ  20\n"


@pytest.fixture(scope="module")
def program(begin, tmp_path_factory):
    folder = tmp_path_factory.mktemp("onika")
    own = Laboratory(folder / "home" / "onika")
    for name, source, writes in (("tick", TICK, "COUNT"), ("beat", BEAT, "none"), ("brief", BRIEF, "none")):
        own.module(name, source)
        own.task(name, ROWS.format(name, writes))
    own.configuration("tickC", "tick 20 rt0")
    own.configuration("idleC", "beat 20 rt0")
    own.configuration("briefC", "beat 20", "brief 20")
    own.application("slow", [job("tickC"), job("tickC")], [job("tickC")], parallel=True)
    own.application("short", [job("briefC")])
    return begin("--rtpu=rt0", "--rtpu=rt1", folder=folder)


def open_one(page, kind, name):
    page.locator("body").press("Control+o")
    panel = page.get_by_role("dialog", name=f"Open {kind}")
    panel.get_by_role("searchbox").fill(name)
    panel.get_by_role("button", name=f"Open {name}", exact=True).click()
    expect(panel).to_have_count(0)


@pytest.fixture
def run(program, page):
    """The panel of a run of two flows that both wait."""
    program.enter(page)
    page.get_by_role("button", name="Applications", exact=True).click()
    open_one(page, "an application", "slow")
    run = page.get_by_role("region", name="Run", exact=True)
    run.get_by_role("button", name=re.compile("^Run")).click()
    expect(run.get_by_role("group", name="Flow 1", exact=True)).to_contain_text("1 of 1")
    yield run
    page.keyboard.press("Escape")
    if run.is_visible():
        run.get_by_role("button", name="Abort", exact=True).click()


def test_a_run_is_looked_into_at_the_upper_level_and_its_configuration_alive(run, page):  # R-E11, R-C14, R-C27, R-C15
    table = page.get_by_role("grid", name="Tasks and their figures")
    expect(table).to_have_count(0)
    run.get_by_role("button", name="Look inside", exact=True).click()
    row = table.get_by_role("row").filter(has_text="tick")
    expect(row).to_contain_text("ON")
    expect(row).to_contain_text(re.compile(r"rt\d"))
    page.get_by_role("combobox", name=re.compile("^Of")).select_option(label="flow1 of slow")
    expect(row).to_contain_text("ON")
    page.get_by_role("tab", name=re.compile("^Variables")).click()
    variable = page.get_by_role("grid", name="State variables").get_by_role("row").filter(has_text="COUNT")
    expect(variable).to_contain_text(re.compile(r"\d"))
    variable.click()
    expect(page.get_by_role("group", name="Plots").locator("canvas")).to_be_visible()
    workspace = page.get_by_role("region", name="Workspace")
    workspace.get_by_role("option", name=re.compile("; action ")).first.click(modifiers=["Shift"])
    note = page.get_by_role("status").filter(has_text="Belongs to flow 0 of slow")
    expect(note).to_be_visible()
    page.keyboard.press("Control+a")
    page.keyboard.press("Delete")
    expect(page.get_by_role("alertdialog")).to_contain_text("shows flow0 of slow")
    page.keyboard.press("Escape")
    note.get_by_role("button", name="To the icon").click()
    run.get_by_role("button", name="Abort", exact=True).click()
    expect(run.get_by_text("Ended early")).to_be_visible()
    page.get_by_role("button", name="Tasks", exact=True).click()
    expect(page.get_by_role("status").filter(has_text="slow has ended")).to_be_visible()


def test_a_run_asks_for_a_unit_and_once_for_what_lives_in_its_way_which_is_put_back(program, page, people):
    # R-C18, R-E12, Equation (1)
    me = people(program.enter(page))
    open_one(page, "a configuration", "idleC")
    page.locator("body").press("Alt+c")
    page.get_by_role("dialog", name="Connect idleC").get_by_role("button", name="Connect", exact=True).click()
    me.state("beat", "OFF")
    me.box("beat").click(modifiers=["Shift"])
    me.state("beat", "ON")
    page.get_by_role("button", name="Applications", exact=True).click()
    open_one(page, "an application", "short")
    run = page.get_by_role("region", name="Run", exact=True)
    run.get_by_role("button", name=re.compile("^Run")).click()
    expect(me.refusal).to_contain_text("on which processing unit beat, brief run: rt0 or rt1?")
    me.refusal.get_by_role("button", name="All on rt1").click()
    expect(me.refusal).to_contain_text("beat is in both: it ends, and begins anew; brief comes; ")
    expect(me.refusal).to_contain_text("afterwards idleC is put back, beat ON again")
    me.refusal.get_by_role("button", name="Take over and run").click()
    expect(run.get_by_text(re.compile("Done: "))).to_be_visible()
    page.get_by_role("button", name="Tasks", exact=True).click()
    me.state("beat", "ON")
    expect(me.canvas.locator("[data-task=beat]")).to_contain_text("ON · rt0")
