from pathlib import Path

import pytest

from kit.plans.plan_builder import PlanBuilder, action
from onika.desk.joined.joint_recording import JointRecording
from onika.desk.run.run_review import Review
from onika.wire import event, reading, request
from onika.words.reason import NOTHING

TASK = """
from onika.module import Module, OutVar

class Task(Module):
    trigger = True
    X = OutVar("double", "m", "a place")
"""
STATIONS = {"flow0": "cmu", "flow1": "sandia"}
RESULT = event.Result(True, NOTHING, 2, 2, 1.0, 2.0, {}, (), "", run="flow0")


def recording(path: Path) -> JointRecording:
    shop = PlanBuilder()
    shop.task("a", TASK, module="task")
    plan = shop.plan([action("a")], [action("a")])
    return JointRecording(request.Prepare(plan, ()), request.Begin(record=str(path)), STATIONS)


def test_the_run_of_several_stations_is_one_recording_that_names_them(tmp_path):  # R-X05, R-F02
    made = recording(tmp_path / "run.mcap")
    made.hear(event.Began(1, 0, 1, "a", 0.25, "flow0"))
    made.read(
        {"flow1/X": reading.encode(reading.Variable(5, 1, 0.5)), "world:w": reading.encode(reading.Poses(1, b""))}
    )
    made.hear(event.Done(1, 0, 0.5, "flow0"))
    made.hear(RESULT)
    with Review(tmp_path / "run.mcap") as review:
        assert review.is_whole and review.ending["completed"] == "yes"
        assert review.run.stations == STATIONS
        assert [len(flow.intervals) for flow in review.flows] == [0, 1]
        assert review.flows[1].intervals[0].begin_s == 0.25
        assert [held for _, held in review.series["flow1/X"].values()] == [0.5]
        assert list(review.series) == ["flow1/X"]


def test_a_run_that_is_left_has_what_was_heard_of_it(tmp_path):  # R-X05
    made = recording(tmp_path / "run.mcap")
    made.hear(event.Began(0, 0, 1, "a", 0.25, "flow0"))
    made.close()
    made.close()
    with Review(tmp_path / "run.mcap") as review:
        assert review.ending["completed"] == "no"
        assert len(review.flows[0].intervals) == 1


def test_a_file_that_is_there_is_not_written_over(tmp_path):  # R-X05
    (tmp_path / "run.mcap").write_text("mine")
    with pytest.raises(FileExistsError):
        recording(tmp_path / "run.mcap")
    assert (tmp_path / "run.mcap").read_text() == "mine"


def test_a_variable_that_has_another_size_later_is_left_out_from_then_on(tmp_path):  # R-X05
    made = recording(tmp_path / "run.mcap")
    for held in ([1.0, 2.0], [1.0, 2.0, 3.0], [3.0, 4.0]):
        made.read({"flow0/X": reading.encode(reading.Variable(5, 1, held))})
    made.hear(RESULT)
    with Review(tmp_path / "run.mcap") as review:
        assert [held for _, held in review.series["flow0/X"].values()] == [[1.0, 2.0], [3.0, 4.0]]


def test_garbage_in_place_of_a_reading_is_left_out(tmp_path):  # R-X16
    made = recording(tmp_path / "run.mcap")
    made.read({"flow0/X": b"\xff\xff"})
    made.hear(RESULT)
    with Review(tmp_path / "run.mcap") as review:
        assert review.series == {} and review.is_whole


def test_a_full_disk_ends_the_recording_and_not_the_run(tmp_path):  # R-X05
    made = recording(tmp_path / "run.mcap")
    made._stream.close()
    made._stream = open("/dev/full", "wb")  # noqa: SIM115, PTH123 - closed by what is tested
    made._writer._stream = made._stream
    made.hear(event.Began(0, 0, 1, "a", 0.25, "flow0"))
    made.hear(RESULT)
    assert "space" in str(made.reason)
