import asyncio
import contextlib
import http.client
import json
import threading

import pytest
from websockets.sync.client import connect

from kit.labs.laboratory import Laboratory, job
from onika.desk.environment.file.recovery import Recovery
from onika.files.rmod import RmodText
from onika.model.task import Task
from onika.store.base_directory import BaseDirectory
from onika.store.shipped import shipped
from onika.store.site import Site
from onika.web.environment_options import EnvironmentOptions
from onika.web.page_front import PageFront
from onika.web.program import EnvironmentProgram
from onika.web.server import bound

pytestmark = pytest.mark.site


class Running:
    """A program in a thread of its own, without a runtime, and one browser that has come in."""

    def __init__(self, folder, *files):
        self.base = BaseDirectory(folder / "base")
        self.base.save_task(RmodText(Task("a", "a", outvar=("Q",), frequency=1.0)))
        site = Site((self.base,), shipped() / "prefs", folder)
        self._state = folder / "state"
        self._program = EnvironmentProgram(site, EnvironmentOptions(files, is_connected=False), self._state)
        self.addresses = []
        self._told = threading.Condition()
        self._thread = threading.Thread(target=lambda: asyncio.run(self._run()))

    async def _run(self):
        self._loop, self._task = asyncio.get_running_loop(), asyncio.current_task()
        with contextlib.suppress(asyncio.CancelledError):
            await PageFront(bound(0), self._tell, self._state).run(lambda: self._program)

    def _tell(self, address):
        with self._told:
            self.addresses.append(address)
            self._told.notify_all()

    def __enter__(self):
        self._thread.start()
        with self._told:
            assert self._told.wait_for(lambda: self.addresses, 30)
        return self

    def __exit__(self, *_):
        self._loop.call_soon_threadsafe(self._task.cancel)
        self._thread.join(30)
        assert not self._thread.is_alive()

    def browser(self):
        """A socket as a page has it, and the tree it was told first."""
        host, _, path = self.addresses[-1].removeprefix("http://").partition("/")
        link = http.client.HTTPConnection(host, timeout=60)
        link.request("GET", "/" + path)
        cookie = link.getresponse().headers["set-cookie"].partition(";")[0]
        link.close()
        return connect(f"ws://{host}/ws", additional_headers={"Cookie": cookie}, origin=f"http://{host}")


def until(socket, wanted):
    """The first message that is wanted; those before it are passed over."""
    while True:
        message = json.loads(socket.recv(timeout=60))
        if wanted(message):
            return message


def snapshot(socket):
    return until(socket, lambda message: message["t"] == "Snapshot")["tree"]


def send(socket, **act):
    socket.send(json.dumps({"cid": 1, "act": act}))
    return until(socket, lambda message: message.get("cid") == 1)


def test_a_session_begins_with_a_blank_configuration_and_each_address_lets_one_browser_in(tmp_path):  # R-C21
    with Running(tmp_path) as program:
        with program.browser() as first, program.browser() as two:
            trees = [snapshot(first), snapshot(two)]
        assert [[doc["name"] for doc in tree["documents"].values()] for tree in trees] == [["Untitled-1"]] * 2
        assert len(set(program.addresses)) == 3


def test_what_is_not_there_is_told_and_the_rest_is_opened(tmp_path):
    with Running(tmp_path, "nowhere") as program, program.browser() as browser:
        assert [document["name"] for document in snapshot(browser)["documents"].values()] == ["Untitled-1"]
        assert (
            "nowhere"
            in until(browser, lambda message: message["t"] == "Say" and message["level"] == "error")["text"]["text"]
        )


def test_a_file_that_another_writes_appears_by_itself(tmp_path):  # R-C01
    with Running(tmp_path) as program, program.browser() as browser:
        assert sorted(snapshot(browser)["tasks"]) == ["a"]
        program.base.save_task(RmodText(Task("b", "b", outvar=("R",), frequency=1.0)))
        until(
            browser,
            lambda message: message["t"] == "Patch" and any(path == ["tasks", "b"] for path, _ in message["changes"]),
        )


def test_what_is_not_saved_is_there_the_next_time(tmp_path):
    with Running(tmp_path) as program, program.browser() as browser:
        doc = next(iter(snapshot(browser)["documents"]))
        assert send(browser, t="Place", doc=doc, task="a", x=10, y=20)["t"] == "Ok"
    with Running(tmp_path) as program, program.browser() as browser:
        (document,) = [document for document in snapshot(browser)["documents"].values() if document.get("tasks")]
        assert document["tasks"]["a"]["x"] == 10
        assert document["is_dirty"]


def test_what_is_being_written_at_the_end_is_there_the_next_time(tmp_path, monkeypatch):
    writes, leaves = Recovery.carry_out, Recovery.leave
    begun, left = threading.Event(), threading.Event()

    def slowly(self, changes):
        if changes:
            begun.set()
            left.wait(0.5)  # an end that does not wait for a slow disk is over by then
        return writes(self, changes)

    def leave(self, *, keeps=False):
        leaves(self, keeps=keeps)
        left.set()

    monkeypatch.setattr(Recovery, "carry_out", slowly)
    monkeypatch.setattr(Recovery, "leave", leave)
    with Running(tmp_path) as program:
        with program.browser() as browser:
            doc = next(iter(snapshot(browser)["documents"]))
            send(browser, t="Place", doc=doc, task="a", x=10, y=20)
        assert begun.wait(30)
    with Running(tmp_path) as program, program.browser() as browser:
        assert [document for document in snapshot(browser)["documents"].values() if document.get("tasks")]


def test_what_was_discarded_is_not(tmp_path):
    with Running(tmp_path) as program, program.browser() as browser:
        doc = next(iter(snapshot(browser)["documents"]))
        send(browser, t="Place", doc=doc, task="a", x=10, y=20)
        send(browser, t="Close", doc=doc, discards=True)
    with Running(tmp_path) as program, program.browser() as browser:
        assert not [document for document in snapshot(browser)["documents"].values() if document.get("tasks")]


def test_preferences_have_a_file_after_the_first_session(tmp_path):  # R-B12
    with Running(tmp_path):
        assert not (tmp_path / ".onika").exists()
    assert "MINPINSEP" in (tmp_path / ".onika").read_text()


def test_a_line_for_each_act_of_a_user_stands_in_the_diary(tmp_path):  # R-H01
    with Running(tmp_path) as program, program.browser() as browser:
        doc = next(iter(snapshot(browser)["documents"]))
        send(browser, t="Place", doc=doc, task="a", x=10, y=20)
    (file,) = (tmp_path / "state" / "diary").glob("*.log")
    lines = file.read_text().splitlines()
    assert sum("\tinsert_icon\ta\t" in line for line in lines) == 1


def test_an_application_is_judged_soon_after_it_was_opened_and_when_its_files_change(tmp_path):  # R-E01
    files = Laboratory(tmp_path / "base")
    path = files.application("play", [job("goneC")])
    with Running(tmp_path, str(path)) as running, running.browser() as socket:

        def mentions(words):
            return lambda message: message["t"] in ("Snapshot", "Patch") and words in json.dumps(message)

        until(socket, mentions("there is no configuration goneC"))
        files.plain_task("b", writes="B")
        files.module("b", "# b\n")
        files.configuration("goneC", "b 100")
        until(
            socket,
            lambda message: (
                message["t"] == "Patch" and any(p[-1] != "files" and "faults" in p for p, _ in message["changes"])
            ),
        )
