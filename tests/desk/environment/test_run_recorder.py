from dataclasses import replace
from types import SimpleNamespace

import pytest

from kit.plans.plan_builder import PlanBuilder, action
from onika.desk.environment import run_recorder
from onika.desk.environment.run_recorder import RunRecorder
from onika.desk.environment.run_state.membership import StepMembership
from onika.desk.environment.run_state.run import RunPart, begun
from onika.desk.run.run_review import Review
from onika.wire import event, reading, request
from onika.words.reason import NOTHING, Reason

TASK = """
from onika.module import Module, OutVar

class Task(Module):
    trigger = True
    X = OutVar("double", "m", "a place")
"""


class Environment:
    """What a recorder hears from; `run` goes on at two stations until it is None."""

    def __init__(self, run):
        self.run = run
        self.listening, self.measuring, self.followers, self.said = [], [], [], []
        self.model = SimpleNamespace(at=self.at, going=(run,))

    def at(self, station):
        return SimpleNamespace(station=station, going_here=(self.run,))

    def say(self, said):
        self.said.append(str(said.text))


@pytest.fixture
def recorded(tmp_path, monkeypatch):
    shop = PlanBuilder()
    shop.task("a", TASK, module="task")
    plan = shop.plan([action("a")], [action("a")])
    run = begun("doc", plan, 7, 0.0, StepMembership({}, {}))
    parts = (RunPart("cmu", (0,)), RunPart("sandia", (1,)))
    run = replace(run, parts=parts).shown(recording=str(tmp_path / "run.mcap"))
    environment, recorder = Environment(run), RunRecorder()
    monkeypatch.setattr(run_recorder, "meant", lambda _model, _message: environment.run)
    recorder.attend(environment)
    assert recorder.begin(run, request.Prepare(plan, ()), request.Begin()) == NOTHING
    yield environment, recorder, tmp_path / "run.mcap"
    recorder.close()


def result(completed=True):
    return event.Result(completed, NOTHING, 1, 1, 1.0, 1.0, {}, (), "", run="flow0")


def test_what_each_station_tells_stands_in_the_flow_of_the_whole(recorded):  # R-X05, R-E12
    environment, recorder, path = recorded
    recorder.hear("sandia", "", event.Began(0, 0, 1, "a", 0.25, "flow1"))
    recorder.hear("sandia", "Run", event.Began(0, 0, 1, "a", 0.25, "flow1"))  # a reply, which says it again
    recorder.read("sandia", {"flow1/X": reading.encode(reading.Variable(5, 1, 0.5)), "other/X": b""})
    recorder.hear("sandia", "", event.Done(0, 0, 0.5, "flow1"))
    recorder.hear("cmu", "", result())
    parts = (replace(environment.run.parts[0], result=result()), environment.run.parts[1])
    environment.run = replace(environment.run, parts=parts)
    recorder.hear("sandia", "", result())
    with Review(path) as review:
        assert review.is_whole and review.ending["completed"] == "yes"
        assert [len(flow.intervals) for flow in review.flows] == [0, 1]
        assert list(review.series) == ["flow1/X"]
    assert environment.said == []


def test_of_a_run_that_has_not_begun_nothing_is_left(recorded):
    environment, recorder, path = recorded
    recorder.forget(environment.run)
    recorder.forget(environment.run)
    assert not path.exists()


def test_a_run_that_goes_on_no_more_has_its_recording_whole(recorded):
    environment, recorder, path = recorded
    recorder.follow(None, environment.model)
    assert not _is_whole(path)
    lost = environment.run.shown(cause=Reason.plain("the cable"))
    recorder.follow(None, SimpleNamespace(going=(), every_run=(lost,)))
    assert _is_whole(path)
    with Review(path) as review:
        assert review.ending["cause"] == "the cable"


def test_so_has_one_that_goes_on_when_the_program_ends(recorded):
    _, recorder, path = recorded
    recorder.close()
    assert _is_whole(path)


def test_what_could_not_be_written_is_told(recorded):
    environment, recorder, _ = recorded
    recorder._recordings[7].reason = Reason.plain("no space left")
    recorder.close()
    assert "no space left" in environment.said[0]


def test_a_file_that_cannot_be_begun_is_told(recorded):
    environment, recorder, _ = recorded
    plan = environment.run.plan
    assert "exists" in str(recorder.begin(environment.run, request.Prepare(plan, ()), request.Begin()))


def _is_whole(path):
    try:
        with Review(path) as review:
            return review.is_whole
    except ValueError:
        return False
