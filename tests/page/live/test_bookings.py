"""A robot that is shared by time, on the page of who is booked there, and the network that offers it (F09, F06)."""

import os
import re
import subprocess
import sys

import pytest
from playwright.sync_api import expect

from kit.fabric.announced_site import AnnouncedSite
from onika.desk.run.remote_runtime import connect
from onika.fabric.card import OfferedRuntime
from onika.fabric.phone_book import BOOK
from onika.fabric.signed_card import bound
from onika.link.token import digest
from onika.wire import booking
from onika.wire.booking import STEP_S

from ..test_access import violations_on

pytestmark = pytest.mark.page


@pytest.fixture(scope="module")
def address(tmp_path_factory):
    """A runtime whose robot is `arm`; ann and bob may come."""
    folder = tmp_path_factory.mktemp("there")
    (folder / "users").write_text("".join(f"{name} programmer {digest(name)}\n" for name in ("ann", "bob")))
    (folder / "users").chmod(0o600)
    words = ["--virtual", "--listen", "127.0.0.1:0", "--users", str(folder / "users"), "--robot", "arm"]
    runtime = subprocess.Popen(
        [sys.executable, "-m", "onika.host", *words],
        stdout=subprocess.PIPE, text=True, env=os.environ | {"XDG_STATE_HOME": str(folder / "state")},
    )  # fmt: skip
    yield runtime.stdout.readline().split("listening on ")[1].split(",")[0].strip()
    runtime.terminate()
    runtime.wait(20)
    runtime.stdout.close()


@pytest.fixture(scope="module")
def program(begin, lab):
    """The environment with the laboratory of small tasks, unconnected."""
    return begin(f"--base={lab.path}", "--no-connect")


@pytest.fixture
def me(program, page, people):
    """A person with a blank configuration in front."""
    person = people(program.enter(page))
    person.blank()
    return person


@pytest.fixture
def web(tmp_path, address):
    """A folder with the card of a site whose runtime that is."""
    site = AnnouncedSite(tmp_path, "cmu.puma")
    (tmp_path / BOOK).write_bytes(bound([site.card(runtimes=(OfferedRuntime(address, ("arm",)),))]))
    return tmp_path


def test_a_robot_that_the_network_offers_is_booked_until_another_user_follows(me, address, web):  # R-F09, R-F06
    page = me.page
    page.locator("body").press("Alt+c")
    stations = page.get_by_role("dialog", name=re.compile("^Connect"))
    stations.get_by_label("another").check()
    stations.get_by_text("What the network offers").click()
    stations.get_by_label("Place", exact=True).fill(str(web))
    stations.get_by_role("button", name="Add", exact=True).click()
    expect(stations.get_by_role("list", name="Sites")).to_contain_text("new to you")
    stations.get_by_role("button", name="Trust this key").click()
    expect(stations.get_by_role("list", name="Sites")).to_contain_text("known")
    stations.get_by_role("button", name=f"Use {address}").click()
    stations.get_by_label("Name").fill("shared")
    stations.get_by_label("Token").fill("ann")
    stations.get_by_role("button", name="Only the runtime").click()
    expect(stations.get_by_role("listitem").filter(has_text="shared")).to_contain_text("is there")
    page.keyboard.press("Escape")

    page.locator("body").press("Alt+h")
    page.get_by_role("dialog", name="Who may move the robots").get_by_role("button", name="Bookings…").click()
    panel = page.get_by_role("dialog", name="Bookings")
    robot = panel.get_by_role("region", name="arm")
    expect(robot).to_contain_text("Free: who comes first may move it")
    robot.get_by_label("What for").fill("welding")
    robot.get_by_role("button", name="Book", exact=True).click()
    expect(robot).to_contain_text("It is your time")
    row = robot.get_by_role("listitem")
    expect(row).to_contain_text("welding")
    until = row.locator(".when").inner_text()
    row.get_by_role("button", name=re.compile("^30 min more")).click()
    expect(row.locator(".when")).not_to_have_text(until)
    assert violations_on(page) == []
    row.get_by_role("button", name=re.compile("^Cancel")).click()
    expect(robot).to_contain_text("Nothing is booked")

    with connect(address, "ann") as ann, connect(address, "bob") as bob:
        now_s = ann.ask(booking.Bookings()).now_s
        end_s = booking.step_after(now_s + 90)  # it is announced ten minutes before
        assert isinstance(ann.ask(booking.Book(int(now_s), end_s, "finish")), booking.Booked)
        assert isinstance(bob.ask(booking.Book(end_s, end_s + 6 * STEP_S)), booking.Booked)
        expect(robot).to_contain_text("what you hold comes to rest; then bob comes")
        panel.get_by_role("tab", name="By person").click()
        expect(panel.get_by_role("list", name="Bookings of bob")).to_contain_text("arm")
        page.keyboard.press("Escape")
        card = page.get_by_role("group", name="Your time with arm ends")
        expect(card).to_contain_text("bob comes next")
        expect(card).to_contain_text("finishes its actions and pauses")
        card.get_by_role("button", name="Understood").click()
        expect(card).to_have_count(0)
