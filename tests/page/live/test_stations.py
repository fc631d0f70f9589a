"""One page, two real runtimes beside each other: chips, the dialog, who holds what where, a cut, Stop (F02, C18)."""

import os
import re
import signal
import subprocess
import sys

import pytest
from playwright.sync_api import expect

from kit.labs.laboratory import Laboratory, job, target
from kit.labs.small_tasks import small_laboratory
from onika.link.token import digest, new_token

pytestmark = pytest.mark.page


class There:
    """A runtime alone, with one user."""

    def __init__(self, folder):
        self.token = new_token()
        (folder / "users").write_text(f"ann owner {digest(self.token)}\n")
        self.token_file = folder / "token"
        self.token_file.write_text(self.token)
        self.token_file.chmod(0o600)
        words = ["--listen", "127.0.0.1:0", "--no-fifo", "--users", str(folder / "users"), "--rtpu", "rt0"]
        self.process = subprocess.Popen(
            [sys.executable, "-m", "onika.host", *words],
            stdout=subprocess.PIPE,
            text=True,
            env=os.environ | {"XDG_STATE_HOME": str(folder / "state")},
        )
        self.url = re.search(r"listening on ([^\s,]+)", self.process.stdout.readline())[1]

    def end(self):
        self.process.send_signal(signal.SIGCONT)
        self.process.terminate()
        self.process.wait(20)
        self.process.stdout.close()


@pytest.fixture(scope="module")
def places(tmp_path_factory):
    places = {name: There(tmp_path_factory.mktemp(name)) for name in ("cmu", "sandia")}
    yield places
    for place in places.values():
        place.end()


@pytest.fixture(scope="module")
def program(begin, lab, places):
    """With one station from its start."""
    cmu = places["cmu"]
    return begin(f"--base={lab.path}", "--no-connect", f"--at=cmu={cmu.url}", f"--token-file=cmu={cmu.token_file}")


@pytest.fixture
def me(program, page, people):
    person = people(program.enter(page))
    page.get_by_role("button", name="Tasks", exact=True).click()
    person.libraries("bench")
    return person


@pytest.fixture(scope="module")
def lab(tmp_path_factory):
    """That of small tasks, and an application of two flows that have no tag in common."""
    lab = small_laboratory(tmp_path_factory.mktemp("base") / "bench")
    steps = [job("pauseC", "Pause job"), target("for_a_while", "Pause object", "1.0")]
    Laboratory(lab.path).application("apart", steps * 2, steps, parallel=True)
    tagged = [job("pauseC", "Pause job", "SYNCHTAG meet"), target("for_a_while", "Pause object", "0.2")]
    Laboratory(lab.path).application("together", [*steps, *tagged], [*tagged, *steps], parallel=True)
    return lab


def chip(me, name):
    return me.page.get_by_role("group", name="Stations").get_by_role("button", name=re.compile(f"^{name}"))


def turned_on(me, connect):
    """A configuration of its own in which wave is ON, connected in the dialog as `connect` does it."""
    me.blank()
    me.drag(me.icon("wave"), 140, 120)
    me.page.locator("body").press("Alt+c")
    panel = me.page.get_by_role("dialog", name=re.compile("^Connect"))
    connect(panel)
    panel.get_by_role("button", name="Connect", exact=True).click()
    expect(panel).to_have_count(0)
    me.state("wave", "OFF")
    me.box("wave").click(modifiers=["Shift"])
    me.state("wave", "ON")


def opened(me, name):
    """An application, on the page of applications."""
    me.page.get_by_role("button", name="Applications", exact=True).click()
    me.page.locator("body").press("Control+o")
    opening = me.page.get_by_role("dialog", name="Open an application")
    opening.get_by_role("searchbox").fill(name)
    opening.get_by_role("button", name=f"Open {name}", exact=True).click()
    expect(opening).to_have_count(0)


def run_apart(me, name):
    """Its two flows are placed at the two stations, and it is run; the panel of the run."""
    page = me.page
    page.locator("body").press("Alt+i")
    redirect = page.get_by_role("dialog", name=f"Redirect {name}")
    for flow, station in (("0", "cmu"), ("1", "sandia")):
        redirect.locator("label.chip").filter(has_text=re.compile(rf"flow {flow}$", re.I)).click()
        redirect.get_by_label("Runs at").select_option(label=station)
        expect(redirect.get_by_label("Runs at")).to_have_value(station)
    page.keyboard.press("Escape")
    run = page.get_by_role("region", name="Run", exact=True)
    run.get_by_role("button", name=re.compile("^Run")).click()
    return run


def test_flows_are_carried_out_at_two_runtimes_and_meet_there_by_themselves(me, places):  # R-E12, R-F02, law 28
    page = me.page
    opened(me, "apart")
    chip(me, "cmu").click()
    panel = page.get_by_role("dialog", name="Stations")
    panel.get_by_label("Name").fill("sandia")
    panel.get_by_label("Address").fill(places["sandia"].url)
    panel.get_by_label("Token").fill(places["sandia"].token)
    panel.get_by_role("button", name="Connect", exact=True).click()
    expect(panel).to_have_count(0)
    expect(chip(me, "sandia")).to_be_visible()
    run = run_apart(me, "apart")
    for flow, station in (("0", "cmu"), ("1", "sandia")):
        expect(run.get_by_role("group", name=f"Flow {flow}")).to_contain_text(station)
    expect(page.get_by_text(re.compile("^apart is done: 3 actions")).first).to_be_visible(timeout=20_000)
    opened(me, "together")
    page.keyboard.press("Alt+r")
    run = run_apart(me, "together")
    expect(run).to_contain_text(re.compile(r"flows meet at tags on cmu, sandia.*held after [\d.]+ ms"), timeout=20_000)
    expect(page.get_by_text(re.compile("^together is done: 4 actions")).first).to_be_visible(timeout=30_000)
    expect(run).to_contain_text("held after")
    run.get_by_role("button", name="Look at the recording").click()  # R-X05
    expect(page.get_by_text("Recording of together")).to_be_visible()
    page.get_by_role("button", name="Close the recording").click()
    page.keyboard.press("Alt+r")


def test_configurations_are_on_at_two_runtimes_and_stop_reaches_the_one_that_is_heard(
    me, places
):  # R-F02, R-C18, law 27
    expect(chip(me, "cmu")).to_be_visible()
    turned_on(me, lambda panel: panel.get_by_label("cmu", exact=True).check())
    expect(chip(me, "cmu")).to_contain_text("Untitled-")

    def another(panel):
        panel.get_by_label("another").check()
        panel.get_by_label("Name").fill("sandia")
        panel.get_by_label("Address").fill(places["sandia"].url)
        panel.get_by_label("Token").fill(places["sandia"].token)

    turned_on(me, another)
    expect(chip(me, "sandia")).to_contain_text("Untitled-")
    me.page.locator("body").press("Alt+h")
    holding = me.page.get_by_role("dialog", name="Who may move the robots")
    expect(holding.get_by_role("heading", name=re.compile("^(cmu|sandia)"))).to_have_count(2)
    expect(holding.get_by_text("Held by you")).to_have_count(2)
    me.page.locator("body").press("Alt+h")

    os.kill(places["cmu"].process.pid, signal.SIGSTOP)
    expect(chip(me, "cmu")).to_contain_text("not heard")
    me.page.keyboard.press("Control+.")
    expect(chip(me, "sandia")).to_contain_text("stopped")
    expect(me.page.get_by_text(re.compile("Stop is given; nothing is heard of cmu")).first).to_be_visible()
    os.kill(places["cmu"].process.pid, signal.SIGCONT)
    expect(chip(me, "cmu")).to_contain_text("stopped")  # it was told as soon as it could hear
    me.page.get_by_role("button", name="Reset", exact=True).click()
    expect(me.page.get_by_role("button", name="Reset", exact=True)).to_have_count(0)
    expect(chip(me, "sandia")).not_to_contain_text("stopped")
    expect(chip(me, "cmu")).not_to_contain_text("stopped")

    chip(me, "cmu").click()
    panel = me.page.get_by_role("dialog", name=re.compile("^Connect"))
    listed = panel.get_by_role("listitem").filter(has_text="sandia")
    expect(listed).to_contain_text(re.compile(r"round trip [\d.]+ ms"))
    panel.get_by_role("listitem").filter(has_text="cmu").get_by_role("button", name="Leave").click()
    me.page.get_by_role("alertdialog", name="Refused").get_by_role("button", name="Leave it").click()
    expect(chip(me, "cmu")).to_have_count(0)
    expect(chip(me, "sandia")).to_be_visible()
