"""A runtime in another language, made after the documents of the protocol: console, runs and environment use it."""

import contextlib
import os
import queue
import shutil
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from kit.process.cli_process import ONIKA
from onika.desk.environment.environment import Environment
from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.runtime_launch import RuntimeLauncher
from onika.desk.environment.state.model import Model
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.desk.environment.stations import Stations
from onika.desk.run.remote_runtime import connect
from onika.store.library import open_libraries
from onika.store.site import open_site
from onika.wire import act, event, live, request
from onika.wire.runtime_standing import Standing
from onika.words.reason import NOTHING

pytestmark = pytest.mark.site

ROOMS = Path(__file__).parents[2] / "docs" / "examples" / "rooms"


class Rooms:
    """The runtime of the model house as a process."""

    def __init__(self, folder: Path) -> None:
        self.token_file = folder / "token"
        self._process = subprocess.Popen(
            [node(), str(ROOMS / "runtime.mjs"), str(self.token_file)], stdout=subprocess.PIPE, text=True
        )
        assert self._process.stdout is not None
        self.url = self._process.stdout.readline().partition("listening on ")[2].partition(",")[0]

    def onika(self, *words: str) -> subprocess.CompletedProcess[str]:
        command = [*ONIKA, *words, "--token-file", str(self.token_file)]
        return subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)

    def script(self, folder: Path, *lines: str) -> subprocess.CompletedProcess[str]:
        path = folder / "script"
        path.write_text("\n".join(lines))
        return self.onika("console", self.url, "--base", str(ROOMS), "--script", str(path), "--no-console")

    def close(self) -> None:
        self._process.terminate()
        self._process.wait(10)
        if self._process.stdout is not None:
            self._process.stdout.close()


def node() -> str:
    path = shutil.which("node")
    if path is None and os.environ.get("CI"):
        pytest.fail("There is no Node on the PATH, and under CI the example must be tried.")
    if path is None:
        pytest.skip("There is no Node on the PATH.")
    return path


@pytest.fixture(scope="module")
def rooms(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Rooms]:
    runtime = Rooms(tmp_path_factory.mktemp("rooms"))
    yield runtime
    runtime.close()


def test_the_tests_of_the_example_itself_pass() -> None:
    tests = subprocess.run([node(), "--test", str(ROOMS)], capture_output=True, text=True, timeout=60, check=False)
    assert tests.returncode == 0, tests.stdout


def test_the_console_turns_its_tasks_on_reads_writes_stops_and_resets(rooms, tmp_path):  # R-A19
    first = rooms.script(
        tmp_path, "tasks", "on rooms", "on thermostat", "on warm 14", "wait warm off within 20", "read WARMTH",
        "kill warm", "write WISH 12 14", "wait WARMTH[0] < 13 within 20", "read WISH", "stop", "tasks", "on rooms",
    )  # fmt: skip
    assert first.returncode == 1, first.stdout + first.stderr
    assert "main/rooms       OFF    rt0   20" in first.stdout
    assert "main/warm signals FINISH 0" in first.stdout
    assert "WARMTH = 13.5" in first.stdout
    assert "WISH = 12  14" in first.stdout
    assert first.stdout.count("main/rooms OFF") == 1, "Stop turns it off"
    assert "everything is stopped; reset it first" in first.stdout + first.stderr
    second = rooms.script(tmp_path, "reset", "spawn warm", "on rooms", "on warm", "answer warm 30", "wait 0.1", "off")
    assert second.returncode == 0, second.stdout + second.stderr
    assert "main/warm asks for level double in degC, how warm both rooms shall be, from 5 to 30" in second.stdout
    assert "main/warm ON" in second.stdout


def test_it_runs_an_application_of_jobs_that_it_knows_as_onikas_own_does(rooms):  # R-A19, R-A15
    expected = ("--expect", "WARMTH[0] < 16.6", "--expect", "WARMTH[1] > 15.4")
    there = rooms.onika("run", "evening", "--local", str(ROOMS), "--runtime", rooms.url, *expected)
    assert there.returncode == 0, there.stdout + there.stderr
    assert "evening: completed, 2 of 2 actions" in there.stdout
    here = [*ONIKA, "run", "evening", "--local", str(ROOMS), "--virtual", *expected]
    assert subprocess.run(here, capture_output=True, timeout=60, check=False).returncode == 0


def test_what_it_has_no_code_for_it_refuses_with_words(rooms):  # R-A19
    refused = rooms.onika("run", "go_home", "--runtime", rooms.url)
    assert refused.returncode == 2
    assert "this runtime knows rooms, thermostat, warm, not arm" in refused.stdout + refused.stderr


def test_a_session_sees_its_events_in_order_and_its_readings(rooms):  # R-A19
    with connect(rooms.url, rooms.token_file.read_text()) as session:
        assert session.ask(live.Attend(("*",), ("main/*",), hz=50.0)) == request.Done()
        standing = session.ask(live.Survey())
        assert isinstance(standing, Standing)
        assert [task.task.name for task in standing.subsystems[0].tasks] == ["rooms", "thermostat", "warm"]
        number = session.ask(live.Change("main", on=(live.Turn("rooms"),))).number
        told = []
        while not any(isinstance(one, event.Edited) for one in told):
            told += session.events(5.0)
        states = [one for one in told if isinstance(one, event.TaskState)]
        assert (states[0].task, states[0].state) == ("rooms", "ON")
        assert next(one for one in told if isinstance(one, event.Edited)).number == number
        assert session.ask(request.Stop(NOTHING)) == request.Done()
        assert session.ask(live.Survey()).is_stopped
        assert session.ask(live.Reset()) == request.Done()


class Desk:
    """An environment that is connected with the model house and shows the tasks of its job."""

    def __init__(self, rooms: Rooms) -> None:
        site = open_site([ROOMS], {}, None)
        self.things = queue.Queue()
        self.stations = Stations(RuntimeLauncher(), self.things.put, time.monotonic)
        model = Model(OpenLibraries(open_libraries(site.directories)))
        self.environment = Environment(model, HANDLERS, Services(site, time.monotonic), self.stations)
        self.stations.begin(self.environment)
        self.do(act.AddStation(rooms.url, rooms.token_file.read_text(), "house"))
        self.doc = self.do(act.New())
        self.do(act.Connect(self.doc, station="house"))

    def do(self, wish):
        given = []
        self.environment.do(wish, "me", given.append)
        self.until(lambda: given)
        assert given[0].no is None, given[0].no
        return given[0].value

    def until(self, reached):
        end = time.monotonic() + 30.0
        while not reached():
            assert time.monotonic() < end, "it did not come"
            with contextlib.suppress(queue.Empty):
                self.things.get(timeout=0.05)()

    def state(self, name):
        return self.environment.tree.documents[self.doc].tasks[name].state


def test_an_environment_shows_its_tasks_turns_them_on_and_answers_what_they_ask(rooms):  # R-A19
    desk = Desk(rooms)
    for name in ("rooms", "thermostat", "warm"):
        desk.until(lambda name=name: desk.state(name) == "OFF")
    desk.do(act.Turn(desk.doc, ("rooms", "thermostat"), is_on=True))
    desk.do(act.Toggle(desk.doc, "warm"))
    desk.until(lambda: desk.environment.tree.documents[desk.doc].tasks["warm"].ask is not None)
    desk.do(act.Answer(desk.doc, "warm", "14"))
    desk.until(lambda: desk.state("warm") == "ON")
    desk.until(lambda: desk.state("warm") == "OFF")
    desk.do(act.Stop())
    desk.until(lambda: desk.state("rooms") == "OFF" and desk.environment.tree.stations["house"].is_stopped)
    desk.do(act.Reset("house"))
    desk.until(lambda: not desk.environment.tree.stations["house"].is_stopped)
    desk.stations.end()
