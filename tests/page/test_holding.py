"""Two environments at one runtime, each with its own page: who holds what, hand-overs, silence, cuts, Stop (X12)."""

import os
import re
import signal
import subprocess
import sys
from itertools import count

import pytest
from playwright.sync_api import expect

from kit.labs.laboratory import Laboratory, job, target
from kit.labs.small_tasks import small_laboratory
from onika.link.token import digest, new_token

from .test_access import violations_on

pytestmark = pytest.mark.page

COUNT = count(1)


class There:
    """A runtime alone, with the users ann, bob and eve, who only looks; and a lab that both environments have."""

    def __init__(self, folder):
        self.folder, self.tokens = folder, {name: new_token() for name in ("ann", "bob", "eve")}
        roles = {"ann": "owner", "bob": "programmer", "eve": "viewer"}
        lines = [f"{name} {roles[name]} {digest(token)}" for name, token in self.tokens.items()]
        (folder / "users").write_text("\n".join(lines) + "\n")
        self.lab = small_laboratory(folder / "bench")
        own = Laboratory(self.lab.path)
        own.application("asks", [job("pauseC", "Unheard job")])
        own.application("thrice", [step for _ in range(3) for step in (job("pauseC", "Pause job"), pause("1.0"))])
        self.environment = os.environ | {"XDG_STATE_HOME": str(folder / "state")}
        words = ["--listen", "127.0.0.1:0", "--no-fifo", "--users", str(folder / "users"), "--rtpu", "rt0"]
        self.process = subprocess.Popen(
            [sys.executable, "-m", "onika.host", *words], stdout=subprocess.PIPE, text=True, env=self.environment
        )
        self.url = re.search(r"listening on ([^\s,]+)", self.process.stdout.readline())[1]

    def run(self, name, user, *options):
        """An application begun from a command line elsewhere."""
        onika = "from onika.cli import main; main()"
        words = ["run", str(self.lab.path / "appl" / f"{name}.appl"), "--runtime", self.url, *options]
        environment = self.environment | {"ONIKA_TOKEN": self.tokens[user]}
        return subprocess.Popen(
            [sys.executable, "-c", onika, *words], env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
        )


def pause(seconds):
    return target("for_a_while", "Pause object", seconds)


class Side:
    """A person at the page of an environment, connected with the runtime as a user."""

    def __init__(self, program, person, name):
        self.program, self.person, self.page, self.name = program, person, person.page, name
        self.holding = self.page.get_by_role("dialog", name="Who may move the robots")
        self.cards = self.page.get_by_role("region", name="Offers and losses")
        self.refusal = self.page.get_by_role("alertdialog", name="Refused")

    def connects(self, there, subsystem):
        self.home = subsystem
        self.page.locator("body").press("Alt+c")
        panel = self.page.get_by_role("dialog", name=re.compile("^Connect"))
        panel.get_by_label("another").check()
        panel.get_by_label("Address").fill(there.url)
        panel.get_by_label("Token").fill(there.tokens[self.name])
        panel.get_by_label("Subsystem").fill(subsystem)
        panel.get_by_role("button", name="Connect", exact=True).click()
        expect(panel).to_have_count(0)
        expect(self.page.get_by_role("button", name=re.compile("Who may move the robots"))).to_be_visible()
        self.page.locator("body").press("Alt+h")
        expect(self.holding).to_be_visible()

    def row(self, name=""):
        """What is held, by its name: else the subsystem that it is connected with."""
        name = name or self.home
        return self.holding.get_by_role("group", name=name, exact=True)

    def press(self, name, row=""):
        self.row(row).get_by_role("button", name=name, exact=True).click()

    def confirms(self, name):
        self.refusal.get_by_role("button", name=name, exact=True).click()
        expect(self.refusal).to_have_count(0)

    def holds(self, text, row=""):
        expect(self.row(row)).to_contain_text(text)


@pytest.fixture(scope="module")
def there(tmp_path_factory):
    place = There(tmp_path_factory.mktemp("there"))
    yield place
    place.process.terminate()
    assert place.process.wait(20) == 0
    place.process.stdout.close()


@pytest.fixture(scope="module")
def programs():
    """An environment each."""
    return {}


@pytest.fixture
def side(there, begin, programs, new_page, people, excused):
    """Makes a person at an environment, with a blank configuration."""
    excused.append("WebSocket|ERR_")  # programs are killed under their pages

    def entered(name):
        if name not in programs or programs[name].process.poll() is not None:
            programs[name] = begin(f"--base={there.lab.path}", "--no-connect")
        person = people(programs[name].enter(new_page()))
        person.blank()
        person.libraries("bench")
        return Side(programs[name], person, name)

    return entered


@pytest.fixture
def home():
    """A subsystem for one test."""
    return f"home{next(COUNT)}"


@pytest.fixture
def two(there, side, home):
    """Ann holds a subsystem, in which wave is ON; bob looks at the same."""
    ann, bob = side("ann"), side("bob")
    ann.connects(there, home)
    ann.person.drag(ann.person.icon("wave"), 140, 120)
    ann.person.state("wave", "OFF")
    ann.person.box("wave").click(modifiers=["Shift"])
    ann.person.state("wave", "ON")
    bob.connects(there, home)
    yield ann, bob
    for person in (ann, bob):
        is_there = person.program.process.poll() is None
        if is_there and person.row(home).get_by_role("button", name="Release").is_visible():
            person.press("Release")
            person.holds("Held by nobody")


def test_the_robots_change_hands_by_offers_and_never_have_two_holders(two):  # R-X12
    ann, bob = two
    ann.holds("Held by you")
    bob.holds("Held by ann#")
    assert bob.row().get_by_role("button").count() == 0
    ann.press("Hand over…")
    ann.page.get_by_role("menuitem", name=re.compile("^bob#")).click()
    ann.holds("It is yours until then")
    expect(bob.cards).to_contain_text(re.compile(r"ann#\d+ offers you home"))
    expect(bob.cards).to_contain_text(re.compile(r"0:[45]\d left"))
    assert [violations_on(bob.page), violations_on(ann.page)] == [[], []]
    bob.cards.get_by_role("button", name="Decline").click()
    expect(bob.cards).to_have_count(0)
    ann.holds("Held by you")
    ann.press("Hand over…")
    ann.page.get_by_role("menuitem", name=re.compile("^bob#")).click()
    ann.press("Withdraw")
    expect(bob.cards).to_have_count(0)
    ann.press("Hand over…")
    ann.page.get_by_role("menuitem", name=re.compile("^bob#")).click()
    bob.cards.get_by_role("button", name="Take it").click()
    bob.holds("Held by you")
    ann.holds("Held by bob#")
    bob.person.state("wave", "ON")  # it stayed on while it changed hands
    ann.person.box("wave").click(modifiers=["Shift"])
    expect(ann.refusal).to_contain_text("held by bob#")
    bob.press("Release")
    ann.press("Take")
    ann.holds("Held by you")


def test_who_only_watches_changes_nothing_and_still_stops_everything(two):  # R-X12
    ann, bob = two
    bob.holding.get_by_role("button", name="Only watch").click()
    expect(bob.holding).to_contain_text("You only watch")
    bob.person.box("wave").click(modifiers=["Shift"])
    expect(bob.refusal).to_be_visible()
    bob.page.keyboard.press("Escape")
    ann.press("Hand over…")
    expect(ann.page.get_by_role("menuitem", name="only watches")).to_have_attribute("aria-disabled", "true")
    ann.page.keyboard.press("Escape")
    bob.page.get_by_role("button", name=re.compile("^Stop")).click()
    ann.person.state("wave", "OFF")
    expect(ann.page.get_by_text("Stop was pressed in the page").first).to_be_visible()
    ann.page.get_by_role("button", name="Reset", exact=True).click()
    bob.holding.get_by_role("button", name="Watch no more").click()
    expect(bob.holding.get_by_role("button", name="Only watch")).to_be_enabled()
    ann.press("Release")
    bob.press("Take")
    bob.holds("Held by you")


def test_a_run_whose_holder_is_gone_is_taken_over_and_goes_on_only_when_somebody_says_so(there, side, home):  # R-X12
    bob = side("bob")
    bob.connects(there, home)
    process = there.run("thrice", "ann", "--on-loss", "finish")
    bob.holds("Held by ann#", row="thrice")
    assert bob.row("thrice").get_by_role("button").count() == 0
    process.kill()
    process.communicate()
    bob.holds("Held by nobody", row="thrice")
    bob.holds("is paused", row="thrice")
    bob.press("Take over…", row="thrice")
    expect(bob.refusal).to_contain_text("starts nothing")
    bob.confirms("Take it over")
    bob.holds("Held by you", row="thrice")
    bob.holds("is paused", row="thrice")
    bob.press("Go on…", row="thrice")
    expect(bob.refusal).to_contain_text("the robot moves")
    bob.confirms("Go on")
    bob.holds("runs", row="thrice")
    bob.press("End it…", row="thrice")
    bob.confirms("End it")
    expect(bob.row("thrice")).to_have_count(0)


def test_what_a_run_asks_is_answered_on_the_page_of_whoever_has_taken_it(two):  # R-X12, R-C13
    ann, bob = two
    ann.page.get_by_role("button", name="Applications", exact=True).click()
    ann.page.locator("body").press("Control+o")
    ann.page.get_by_role("dialog", name="Open an application").get_by_role("button", name="Open asks").click()
    run = ann.page.get_by_role("region", name="Run", exact=True)
    run.get_by_label("If the runtime loses this environment").select_option("it goes on")
    run.get_by_role("button", name=re.compile("^Run")).click()
    bob.holds("asks and waits for an answer", row="asks")
    bob.holds("If its holder is lost, it goes on", row="asks")
    assert bob.page.get_by_role("dialog", name=re.compile("asks$")).count() == 0
    ann.page.locator("body").press("Alt+h")
    ann.press("Hand over…", row="asks")
    ann.page.get_by_role("menuitem", name=re.compile("^bob#")).click()
    bob.cards.get_by_role("button", name="Take it").click()
    form = bob.page.get_by_role("dialog", name=re.compile("asks$"))
    form.get_by_role("textbox", name=re.compile("^duration,")).fill("0.04")
    form.get_by_role("button", name="Send").click()
    expect(form).to_have_count(0)
    expect(bob.row("asks")).to_have_count(0)
    expect(run.get_by_text(re.compile("Done: "))).to_be_visible()
    ann.page.get_by_role("button", name="Tasks", exact=True).click()


def test_a_frozen_environment_loses_what_it_holds_and_is_told_when_it_is_back(two):  # R-X12
    ann, bob = two
    ann.program.process.send_signal(signal.SIGSTOP)
    bob.holds("Held by nobody")
    bob.holds("has been silent for")
    bob.person.state("wave", "OFF")
    expect(bob.holding.get_by_text("Not heard any more")).to_contain_text(re.compile(r"ann#"))
    ann.program.process.send_signal(signal.SIGCONT)
    expect(ann.cards).to_contain_text("You no longer hold home")
    ann.person.state("wave", "OFF")  # nothing comes on by itself
    ann.cards.get_by_role("button", name="Take it again").click()
    ann.holds("Held by you")
    expect(ann.cards).to_have_count(0)
    ann.program.process.kill()
    bob.holds("Held by nobody")
    bob.press("Take")
    bob.holds("Held by you")
