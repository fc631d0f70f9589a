"""Several browsers at one environment, broken lines, lost runtimes, and messages that are none."""

import json
import os
import re
import signal
import subprocess
from pathlib import Path

import pytest
from playwright.sync_api import expect

pytestmark = pytest.mark.page


@pytest.fixture(scope="module")
def program(begin, lab):
    return begin(f"--base={lab.path}")


@pytest.fixture
def two(program, new_page, people):
    """Two persons who look at the same blank configuration."""
    first, other = people(program.enter(new_page())), people(program.enter(new_page()))
    name = first.blank()
    other.tab(name).click()
    expect(other.page.get_by_role("application", name=f"canvas of {name}")).to_be_visible()
    first.libraries("bench")
    other.libraries("bench")
    return first, other


def test_what_one_does_the_other_sees_and_may_take_back(two):  # R-X10
    first, other = two
    first.place("wave", "calm")
    expect(other.box("calm")).to_be_visible()
    expect(other.locus("WAVE")).to_be_visible()
    other.page.get_by_role("button", name="Undo: placing calm").click()
    expect(first.box("calm")).to_have_count(0)


def test_two_who_move_one_icon_at_the_same_time_see_it_in_one_place_in_the_end(two):  # R-C10
    first, other = two
    first.place("wave")
    expect(other.box("wave")).to_be_visible()
    start = first.corner("wave")
    box = {person: person.box("wave").bounding_box() for person in two}
    for person in two:
        person.page.mouse.move(box[person]["x"] + 50, box[person]["y"] + 20)
        person.page.mouse.down()
    first.page.mouse.move(*first.at(500, 300), steps=3)
    other.page.mouse.move(*other.at(200, 450), steps=3)
    first.page.mouse.up()
    other.page.mouse.up()
    for person in two:
        expect(person.page.get_by_role("button", name="Undo: moving wave")).to_be_enabled()
    other.page.get_by_role("button", name="Undo: moving wave").click()
    expect(first.page.get_by_role("button", name="Redo: moving wave")).to_be_enabled()
    first.page.get_by_role("button", name="Redo: moving wave").click()
    for person in two:
        expect(person.page.get_by_role("button", name="Redo: moving wave")).to_have_count(0)
    assert first.corner("wave") == other.corner("wave") != start


def test_when_one_leaves_the_other_goes_on(two):  # R-X10
    first, other = two
    first.page.close()
    other.place("wave")
    expect(other.box("wave")).to_be_visible()


def test_each_browser_shows_its_own_configuration_and_its_own_selection(two):  # R-C06
    first, other = two
    first.place("wave", "calm")
    first.box("wave").click()
    expect(other.box("wave")).to_have_attribute("aria-pressed", "false")
    other.blank()
    expect(first.box("wave")).to_be_visible()


def test_a_key_opens_one_door_once(program, new_page, excused):  # R-C18
    excused += ["403", "favicon"]
    page = new_page()
    address = program.address()
    page.goto(address)
    expect(page.get_by_role("banner")).to_be_visible()
    stranger = new_page()
    assert stranger.goto(address).status == 403
    expect(stranger.get_by_text("works once")).to_be_visible()


def test_a_page_whose_line_was_cut_shows_it_and_has_everything_when_it_is_back(program, new_page, people, excused):
    # R-X10
    excused.append("WebSocket|ERR_")
    page = new_page()
    lines, isolated = [], []

    def passed(socket):
        if isolated:
            socket.close()
            return
        lines.append(socket)
        socket.connect_to_server()

    page.route_web_socket(re.compile("/ws$"), passed)
    me = people(program.enter(page))
    witness = people(program.enter(new_page()))
    name = witness.blank()
    me.tab(name).click()
    isolated.append(True)
    lines[-1].close()
    expect(page.get_by_text("not connected to the environment, trying again")).to_be_visible()
    witness.libraries("bench")
    witness.place("wave")
    isolated.clear()
    expect(me.box("wave")).to_be_visible(timeout=20_000)
    expect(page.get_by_text("not connected to the environment, trying again")).to_have_count(0)


@pytest.mark.parametrize(
    "message",
    ["nonsense", "{}", json.dumps({"cid": 1, "act": {"t": "Explode"}}), json.dumps({"cid": "x", "act": {"t": "New"}}),
     json.dumps({"cid": 1, "act": {"t": "New", "extra": 1}}), "[" * 5_000],
)  # fmt: skip
def test_a_malformed_message_is_refused_and_nobody_loses_his_connection(two, message):  # R-X01, R-F01
    first, other = two
    answer = first.page.evaluate(
        """message => new Promise(done => {
          const socket = new WebSocket(new URL('ws', location.href.replace(/^http/, 'ws')))
          socket.onopen = () => socket.send(message)
          socket.onmessage = (event) => {
            const told = JSON.parse(event.data)
            if (told.t === 'Refused') done(told.reason.key)
          }
          socket.onclose = (event) => done(event.code)
        })""",
        message,
    )
    assert answer == "desk.no_act"
    first.place("wave")
    expect(other.box("wave")).to_be_visible()


def test_a_lost_runtime_leaves_the_layout_and_connecting_starts_another(program, new_page, people):  # R-C12, R-E10
    me = people(program.enter(new_page()))
    name = me.blank()
    me.libraries("bench")
    page = me.page
    connect(me, name)
    me.place("wave", "calm")
    me.state("wave", "OFF")
    me.box("wave").click(modifiers=["Shift"])
    me.state("wave", "ON")
    corner = me.corner("calm")
    killed = [pid for pid in children(program.process.pid) if "onika" in command(pid)]
    os.kill(killed[0], signal.SIGKILL)
    expect(page.get_by_text("Not connected", exact=True)).to_be_visible(timeout=20_000)
    expect(me.box("wave")).to_be_visible()
    assert me.corner("calm") == corner
    page.get_by_role("button", name="Reconnect").click()
    expect(page.get_by_text("Not connected", exact=True)).to_have_count(0, timeout=30_000)
    me.state("calm", "OFF")
    me.state("wave", "")


def connect(me, name):
    me.page.locator("body").press("Alt+c")
    me.page.get_by_role("dialog", name=f"Connect {name}").get_by_role("button", name="Connect", exact=True).click()
    expect(me.page.get_by_role("button", name="Release")).to_be_visible(timeout=30_000)


def children(pid):
    listing = subprocess.run(["pgrep", "-P", str(pid)], capture_output=True, text=True, check=False)
    return [int(number) for number in listing.stdout.split()]


def command(pid):
    return Path(f"/proc/{pid}/cmdline").read_text().replace("\0", " ")
