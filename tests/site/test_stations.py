"""Three real runtimes at one environment, one of them cut off: the others lose nothing, and are as quick (F02)."""

import contextlib
import os
import queue
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from kit.labs.laboratory import Laboratory, job, target
from kit.labs.small_tasks import small_laboratory
from onika.desk.environment.environment import Environment
from onika.desk.environment.handlers import HANDLERS
from onika.desk.environment.initial_model import opened
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.runtime_launch import RuntimeLauncher
from onika.desk.environment.run_recorder import RunRecorder
from onika.desk.environment.stations import Stations
from onika.desk.run.run_review import Review
from onika.store.site import open_site
from onika.wire import act, event

pytestmark = pytest.mark.site

PATIENCE_S = 60.0
TURNS = 20
NAMES = ("pittsburgh", "albuquerque", "livermore")


COUNTS = """
from onika.module import Module, OutVar, finish

class Counts(Module):
    trigger = True
    COUNT = OutVar("double", "-", "cycles")

    def cycle(self):
        self.COUNT += 1.0
        return finish() if self.COUNT == 25.0 else None
"""


class There:
    """A runtime alone, which listens on loopback."""

    def __init__(self, folder):
        words = [sys.executable, "-m", "onika.host", "--listen", "127.0.0.1:0", "--no-fifo", "--rtpu", "rt0"]
        self.process = subprocess.Popen(
            words, stdout=subprocess.PIPE, text=True, env=os.environ | {"XDG_STATE_HOME": str(folder)}
        )
        match = re.search(r"listening on (\S+), token in (.*)$", self.process.stdout.readline())
        self.url, self.token = match[1], Path(match[2]).read_text().strip()

    def cut(self):
        """Nothing of it is heard, as with a line that is cut, until it is `mended`."""
        self.process.send_signal(signal.SIGSTOP)

    def mended(self):
        self.process.send_signal(signal.SIGCONT)

    def end(self):
        self.mended()
        self.process.terminate()
        self.process.wait(20)
        self.process.stdout.close()


class Sites:
    """An environment with three stations, and at each a configuration of which one task is turned ON and OFF."""

    def __init__(self, folder):
        lab = small_laboratory(folder / "bench")
        pause = [job("pauseC", "Pause job"), target("for_a_while", "Pause object", "0.5")]
        tagged = [job("pauseC", "Pause job", "SYNCHTAG meet"), target("for_a_while", "Pause object", "0.2")]
        Laboratory(lab.path).application("three", [*pause, *tagged], [*pause, *tagged], pause * 4, parallel=True)
        Laboratory(lab.path).module("counts", COUNTS)
        Laboratory(lab.path).plain_task("counts", writes="COUNT", hz=50)
        Laboratory(lab.path).configuration("countsC", "counts 50")
        Laboratory(lab.path).application("counted", *([job("countsC")] for _ in NAMES), parallel=True)
        site = open_site([lab.path], {}, None)
        self.there = {name: There(folder / name) for name in NAMES}
        self.things, self.says, self.heard = queue.Queue(), [], []
        self.stations = Stations(RuntimeLauncher(), self.things.put, time.monotonic)
        model, _ = opened(site, None, {})
        recorder = RunRecorder()
        services = Services(site, time.monotonic, folder / "state", recorder=recorder)
        self.environment = Environment(model, HANDLERS, services, self.stations)
        recorder.attend(self.environment)
        self.environment.listeners.append(self)
        self.stations.begin(self.environment)
        receive = self.environment.receive

        def hear(message, station=""):
            if isinstance(message, event.TaskState):
                self.heard.append((station, message.state))
            receive(message, station)

        self.environment.receive = hear
        self.docs = {}
        for name, there in self.there.items():
            self.do(act.AddStation(there.url, there.token, name))
            self.docs[name] = self.do(act.New())
            self.do(act.Place(self.docs[name], "wave", 0, 0))
            self.do(act.Connect(self.docs[name], station=name))
            self.until(lambda name=name: self.state(name) == "OFF")

    def patch(self, patch):
        pass

    def say(self, say):
        self.says.append(say)

    def do(self, wish):
        given = []
        self.environment.do(wish, "me", given.append)
        self.until(lambda: given)
        assert given[0].no is None, given[0].no
        return given[0].value

    def until(self, reached):
        end = time.monotonic() + PATIENCE_S
        while not reached():
            assert time.monotonic() < end, f"it did not come; said was {[str(say.text) for say in self.says[-5:]]}"
            with contextlib.suppress(queue.Empty):
                self.things.get(timeout=0.05)()

    def state(self, name):
        return self.environment.tree.documents[self.docs[name]].tasks["wave"].state

    def turned(self, name):
        """Turn the task at a station; how long it took until its state was told, in s."""
        wanted = "OFF" if self.state(name) == "ON" else "ON"
        begin = time.monotonic()
        self.do(act.Toggle(self.docs[name], "wave"))
        self.until(lambda: self.state(name) == wanted)
        return time.monotonic() - begin

    def end(self):
        self.stations.end()
        for there in self.there.values():
            there.end()


@pytest.fixture
def sites(tmp_path):
    sites = Sites(tmp_path)
    yield sites
    sites.end()


def test_where_one_of_three_runtimes_is_cut_off_the_others_lose_nothing_and_stop_at_once(sites):  # R-F02, law 27
    sites.turned("livermore")
    sites.there["livermore"].cut()
    sites.until(lambda: sites.environment.tree.stations["livermore"].is_cut)
    sites.heard.clear()
    for _ in range(TURNS):
        for name in NAMES[:2]:
            sites.turned(name)
    told = [(name, state) for _ in range(TURNS // 2) for state in ("ON", "OFF") for name in NAMES[:2]]
    assert sites.heard == told
    begin = time.monotonic()
    answer = sites.do(act.Stop())
    sites.until(lambda: all(sites.environment.tree.stations[name].is_stopped for name in NAMES[:2]))
    assert time.monotonic() - begin < 1.0 and "livermore" in str(answer)
    sites.there["livermore"].mended()
    sites.until(lambda: sites.environment.tree.stations["livermore"].is_stopped)


def test_of_a_run_at_three_runtimes_two_meet_while_the_third_is_cut_off_and_stop_reaches_all(
    sites,
):  # R-E12, R-F02, law 27, law 28
    doc = sites.do(act.Open("three"))
    for flow, name in enumerate(NAMES):
        sites.do(act.PlaceFlow(doc, f"flow{flow}", name))
    sites.do(act.Run(doc))
    flows = sites.environment.tree.run.flows
    assert [flow.station for flow in flows.values()] == list(NAMES)

    def done():
        return [flow.done for flow in sites.environment.tree.run.flows.values()]

    sites.until(lambda: done()[:2] == [1, 1])  # all have begun together
    sites.there["livermore"].cut()
    sites.until(lambda: done()[:2] == [2, 2])  # they have met at the tag
    sites.until(lambda: sites.environment.tree.stations["livermore"].is_cut)
    assert sites.environment.tree.run.state == "running"
    assert [sites.environment.tree.stations[name].is_cut for name in NAMES] == [False, False, True]
    assert "livermore" in str(sites.do(act.Stop()))
    sites.until(lambda: all(sites.environment.tree.stations[name].is_stopped for name in NAMES[:2]))
    sites.there["livermore"].mended()
    sites.until(lambda: sites.environment.tree.stations["livermore"].is_stopped)
    sites.until(lambda: sites.environment.tree.run.state == "over")
    assert not sites.environment.tree.run.is_completed and "livermore" in str(sites.environment.tree.run.cause)


def test_a_run_at_three_runtimes_is_recorded_as_one(sites):  # R-X05, R-E12
    doc = sites.do(act.Open("counted"))
    for flow, name in enumerate(NAMES):
        sites.do(act.PlaceFlow(doc, f"flow{flow}", name))
    sites.do(act.Run(doc, is_recorded=True))
    sites.until(lambda: sites.environment.tree.run.state == "over")
    run = sites.environment.tree.run
    assert run.is_completed, run.cause
    with Review(Path(run.recording)) as review:
        assert review.is_whole and review.ending["completed"] == "yes"
        assert review.run.stations == dict(zip(run.flows, NAMES, strict=True))
        assert [len(flow.intervals) for flow in review.flows] == [1, 1, 1]
        assert set(review.series) == {f"{flow}/COUNT" for flow in run.flows}
        for series in review.series.values():
            held = [count for _, count in series.values()]
            assert len(set(held)) > 3
            assert held == sorted(held)


def test_where_a_run_at_three_runtimes_cannot_be_recorded_it_does_not_begin(sites, tmp_path):  # R-X05
    doc = sites.do(act.Open("three"))
    for flow, name in enumerate(NAMES):
        sites.do(act.PlaceFlow(doc, f"flow{flow}", name))
    (tmp_path / "state").write_text("in the way of the folder")
    given = []
    sites.environment.do(act.Run(doc, is_recorded=True), "me", given.append)
    sites.until(lambda: given)
    assert given[0].no is not None
    assert given[0].no.remedies[0].act.is_recorded is False


@pytest.mark.slow
def test_the_others_are_as_quick_as_with_three_that_are_heard(sites):  # R-F02
    whole, during = [], []
    for _ in range(6):  # in turns, so that what else the machine does is in both
        whole += [sites.turned(name) for _ in range(40) for name in NAMES[:2]]
        sites.there["livermore"].cut()
        sites.until(lambda: sites.environment.tree.stations["livermore"].is_cut)
        during += [sites.turned(name) for _ in range(40) for name in NAMES[:2]]
        sites.there["livermore"].mended()
        sites.until(lambda: not sites.environment.tree.stations["livermore"].is_cut)
    ranks = [sorted(took)[len(took) * share // 100] for took in (whole, during) for share in (50, 99)]
    median, slowest, median_cut, slowest_cut = ranks
    assert median_cut <= 1.1 * median + 1e-3 and slowest_cut <= 1.1 * slowest + 5e-3, ranks
