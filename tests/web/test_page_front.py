import asyncio
import contextlib
import http.client
import json
import threading

import pytest
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from kit.desk.environment_fixture import EnvironmentFixture
from onika.model.task import Task
from onika.web.hub import Hub
from onika.web.page_front import PageFront
from onika.web.replay_program import NoValues
from onika.web.server import bound

pytestmark = pytest.mark.site


class Program:
    """An environment that is there when the test says so."""

    def __init__(self, folder, wrong):
        self._sitting = EnvironmentFixture(folder, (Task("a", "a", outvar=("Q",), frequency=1.0),))
        self._wrong = wrong

    async def run(self, opens):
        if self._wrong is not None:
            raise self._wrong
        environment = self._sitting.environment
        opened = opens(environment, Hub(environment, NoValues()))
        try:
            await opened.serve((asyncio.Event().wait(),))
        finally:
            opened.close()


class Fronted:
    """A front in a thread of its own, whose environment is loaded once `loads` is set."""

    def __init__(self, folder, wrong=None):
        self.loads = threading.Event()
        self.ended = None
        self._folder, self._wrong = folder, wrong
        self._told, self._ready = [], threading.Event()
        self._thread = threading.Thread(target=self._live)

    def _live(self):
        try:
            asyncio.run(self._run())
        except BaseException as raised:
            self.ended = raised

    async def _run(self):
        self._loop, self._task = asyncio.get_running_loop(), asyncio.current_task()
        await PageFront(bound(0), self._tell, self._folder / "state").run(self._load)

    def _load(self):
        assert self.loads.wait(30)
        return Program(self._folder, self._wrong)

    def _tell(self, address):
        self._told.append(address)
        self._ready.set()

    def __enter__(self):
        self._thread.start()
        assert self._ready.wait(30)
        return self

    def __exit__(self, *_):
        self.loads.set()
        with contextlib.suppress(RuntimeError):  # it has ended by itself
            self._loop.call_soon_threadsafe(self._task.cancel)
        self.join()

    def join(self):
        self._thread.join(30)
        assert not self._thread.is_alive()

    def ask(self, path, **headers):
        """What comes back for a path of the page."""
        self.host = self._told[0].removeprefix("http://").partition("/")[0]
        link = http.client.HTTPConnection(self.host, timeout=30)
        link.request("GET", path, headers=headers)
        answer = link.getresponse()
        answer.read()
        link.close()
        return answer

    def browser(self):
        """The cookie of a browser that has come in by the address that was told last."""
        key = self._told[-1].partition("/?")[2]
        return self.ask(f"/?{key}").headers["set-cookie"].partition(";")[0]

    def meet(self, cookie):
        """Its WebSocket."""
        return connect(f"ws://{self.host}/ws", additional_headers={"Cookie": cookie}, origin=f"http://{self.host}")


def test_the_page_is_there_before_its_environment_and_a_browser_waits_for_it(tmp_path):  # R-C20, R-X08
    with Fronted(tmp_path) as front:
        cookie = front.browser()
        assert front.ask("/", Cookie=cookie).status in (200, 503)  # 503: the page was not built
        with front.meet(cookie) as gone, front.meet(cookie) as stays:
            gone.close()
            with pytest.raises(TimeoutError):
                stays.recv(timeout=0)
            front.loads.set()
            assert json.loads(stays.recv(timeout=30))["t"] == "Snapshot"


def test_nobody_comes_in_without_the_key_before_the_environment_is_there_either(tmp_path):  # R-X11
    with Fronted(tmp_path) as front:
        assert front.ask("/").status == 403
        assert front.ask("/", Host="elsewhere.example").status == 421


def test_what_its_environment_raises_ends_the_page(tmp_path):
    with Fronted(tmp_path, wrong=OSError("no place left")) as front:
        front.loads.set()
        front.join()
    assert isinstance(front.ended, OSError)


def test_a_browser_that_waits_for_what_will_not_come_is_let_go(tmp_path):
    with Fronted(tmp_path, wrong=OSError("no place left")) as front:
        with front.meet(front.browser()) as waiting:
            front.loads.set()
            with pytest.raises(ConnectionClosed):
                waiting.recv(timeout=30)
        front.join()


def test_what_a_browser_says_before_the_environment_is_there_is_heard_then(tmp_path):
    with Fronted(tmp_path) as front, front.meet(front.browser()) as early:
        early.send(json.dumps({"cid": 7, "act": {"t": "New"}}))
        front.loads.set()
        while (message := json.loads(early.recv(timeout=30)))["t"] != "Ok":
            pass
        assert message["cid"] == 7
