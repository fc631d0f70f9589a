import contextlib
import queue
import time

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from kit.desk.runtime_line import RuntimeLine
from onika.desk.environment.environment import Environment
from onika.desk.environment.outcome.outcome import Done, Order
from onika.desk.environment.stations import Stations
from onika.link.lost import LinkLost, LossCause
from onika.model.task import Task
from onika.wire import act, live, reading, request
from onika.words.reason import Reason

PATIENCE_S = 60.0
CMU, SANDIA = "wss://cmu.example:7994", "wss://sandia.example:7994"


class Lab(EnvironmentFixture):
    """An environment with stations; `lines` are their runtimes, by address."""

    def __init__(self, folder):
        super().__init__(folder, (Task("a", "a", outvar=("A",), frequency=10.0),))
        (folder / "module" / "a.py").write_text("# a\n")
        self.things, self.lines, self.now = queue.Queue(), {}, 100.0
        self.stations = Stations(self.open, self.things.put, lambda: self.now)
        model, handlers = self.environment.model, self.environment._handlers
        self.environment = Environment(model, handlers, self.surroundings, self.stations)
        self.environment.listeners.append(self)
        self.stations.begin(self.environment)

    def open(self, url, token, simulator=None):
        self.lines[url] = RuntimeLine()
        return self.lines[url]

    def answer(self, request, by="me"):
        given = []
        self.environment.do(request, by, given.append)
        self.until(lambda: given)
        return given[0]

    def until(self, reached):
        end = time.monotonic() + PATIENCE_S
        while not reached():
            assert time.monotonic() < end, "it did not come"
            with contextlib.suppress(queue.Empty):
                self.things.get(timeout=0.05)()


@pytest.fixture
def lab(tmp_path):
    lab = Lab(tmp_path)
    lab.here = lab.new("a")
    lab.do(act.Connect(lab.here))
    lab.do(act.AddStation(CMU))
    lab.do(act.AddStation(SANDIA))
    yield lab
    lab.stations.end()


def test_each_station_has_a_runtime_of_its_own(lab):  # R-F02
    assert list(lab.lines) == ["", CMU, SANDIA]
    lab.do(act.AddUnit("rt7", station="cmu"))
    there = [url for url, line in lab.lines.items() if live.AddUnit("rt7") in line.asked]
    assert there == [CMU]


def test_a_stop_does_not_wait_for_a_station_that_does_not_answer(lab):  # law 27, R-F02
    lab.lines[CMU].silent = (request.Stop, live.Reset)
    assert lab.do(act.Stop()) is None
    lab.until(lambda: lab.environment.tree.stations["sandia"].is_stopped)
    assert lab.environment.tree.runtime.is_stopped
    assert any(isinstance(asked, request.Stop) for asked in lab.lines[CMU].asked)


def test_a_runtime_that_is_lost_ends_no_other(lab):  # R-F02, R-E10
    lab.lines[CMU].say(LinkLost(LossCause.CLOSED, Reason.plain("the cable")))
    lab.until(lambda: lab.environment.tree.stations["cmu"].state == "lost")
    assert lab.lines[CMU].is_left and not lab.lines[""].is_left and not lab.lines[SANDIA].is_left
    lab.do(act.Toggle(lab.here, "a"))
    lab.do(act.AddStation(name="cmu"))
    assert lab.environment.tree.stations["cmu"].state == "linked" and not lab.lines[CMU].is_left


def test_a_station_that_is_silent_is_said_to_be_cut_and_one_far_away_has_a_round_trip(lab):  # R-F02
    lab.until(lambda: lab.environment.tree.stations["cmu"].round_trip_ms >= 0.0)
    lab.lines[CMU].is_heard = False
    lab.lines[CMU].say()
    lab.until(lambda: lab.environment.tree.stations["cmu"].is_cut)
    assert not lab.environment.tree.runtime.is_cut and lab.environment.tree.runtime.round_trip_ms < 0.0
    lab.lines[CMU].is_heard = True
    lab.lines[CMU].say()
    lab.until(lambda: not lab.environment.tree.stations["cmu"].is_cut)
    said = [say.text.key for say in lab.says]
    assert said.count("run.station_cut") == said.count("run.station_heard") == 1


def test_a_station_that_is_left_is_left_for_good(lab):  # R-F02
    line = lab.lines[CMU]
    lab.do(act.RemoveStation("cmu"))
    lab.until(lambda: line.is_left)
    answers = []

    def answered(model, response):
        answers.append(response)
        return Done(model)

    lab.stations.send(Order(live.Survey(), answered, station="cmu"))
    lab.until(lambda: answers)
    assert answers[0].reason.key == "run.not_linked"


def test_what_is_watched_comes_of_all_stations_in_one_frame_under_its_own_names(lab):  # R-F02, R-C14
    doc = lab.new("a")
    lab.do(act.Connect(doc, station="cmu"))
    home = lab.environment.model.documents[doc].live.subsystem
    here = lab.environment.model.documents[lab.here].live.subsystem
    lab.stations.watch(frozenset((f"{doc}/A", f"{lab.here}/A")), frozenset(("cmu/boxes", "boxes")), False, 30.0)
    lab.until(lambda: live.Attend(("*",), (f"{home}/A",), ("boxes",), 30.0) in lab.lines[CMU].asked)
    lab.until(lambda: live.Attend(("*",), (f"{here}/A",), ("boxes",), 30.0) in lab.lines[""].asked)
    lab.lines[CMU].seen = {
        f"{home}/A": reading.encode(reading.Variable(7 * 10**9, 1, 4.0)),
        "world:boxes": reading.encode(reading.Poses(7 * 10**9, b"")),
    }
    lab.lines[""].seen = {f"{here}/A": reading.encode(reading.Variable(3 * 10**9, 1, 5.0))}
    for line in lab.lines.values():
        line.say()
    values, poses, times = {}, {}, set()

    def has_come():
        frame = lab.stations.frame()
        if frame is not None:
            values.update(frame.values)
            poses.update(frame.poses)
            times.add(frame.at_s)
        return len(values) == 2 and poses

    lab.until(has_come)
    assert values == {f"{doc}/A": 4.0, f"{lab.here}/A": 5.0} and list(poses) == ["cmu/boxes"]
    assert 7.0 not in times
