"""One subsystem that is held by hand as it is recorded: what comes and goes meanwhile (requirement X05)."""

import pytest

from kit.runtime.live_edits import live_edits_with_tasks
from onika.host.recording.subsystem_recording import SubsystemRecording
from onika.record.reader import Reader
from onika.record.series import Series
from onika.wire import event, live, request
from onika.words.reason import NOTHING


@pytest.fixture
def edits():
    edits = live_edits_with_tasks()
    assert edits.change(spawn=("source", "user"), on=("source", "user")) == ""
    edits.let_pass(0.5)
    return edits


def recording(edits, path):
    program = edits.asker.program
    about = program.recordings.descriptions.describe_by_hand(program.subsystems.live["s0"])
    return SubsystemRecording(program.subsystems.live["s0"], str(path), about, edits.driver)


def test_a_variable_that_comes_back_with_another_shape_is_left_out_and_that_is_told(edits, tmp_path):  # law 12
    path = tmp_path / "row.mcap"
    edits.asker.ask(live.Record("s0", str(path)))
    edits.let_pass(0.2)
    assert edits.reinit("source", SIZE="3") == ""
    edits.let_pass(0.2)
    edits.asker.ask(live.Record("s0"))
    warned = [message.text for message in edits.asker.of(event.Warned)]
    assert [text.args["name"] for text in warned if text.key == "host.recorded_otherwise"] == ["ROW"]
    series = Series.all_of(Reader(path))
    assert str(series["s0/ROW"].shape) == "double[2]"
    assert all(len(row) == 2 for _, row in series["s0/ROW"].flat())
    last = max(at for at, _ in series["s0/LEVEL"].values())
    assert last > 380_000_000 > max(at for at, _ in series["s0/ROW"].values())


def test_nothing_comes_to_it_before_it_begins_nor_after_its_end(edits, tmp_path):  # R-X05
    path = tmp_path / "a.mcap"
    made = recording(edits, path)
    made.hear(event.TaskState("s0", "early", "ON", 0.0), "s0")
    made.begin()
    edits.let_pass(0.1)
    made.end(NOTHING)
    made.hear(event.TaskState("s0", "late", "ON", 0.0), "s0")
    edits.let_pass(0.1)
    assert made.is_over and made.lasted_s == pytest.approx(0.1)
    assert made.close() == []
    reader = Reader(path)
    assert reader.span[1] <= 100_000_000
    bodies = [body for _, body in reader.messages("/events")]
    assert bodies and not any(b"early" in body or b"late" in body for body in bodies)


def test_what_is_asked_of_another_subsystem_does_not_belong_to_it(edits, tmp_path):  # law 29
    path = tmp_path / "a.mcap"
    made = recording(edits, path)
    made.begin()
    made.command("me", live.Close("s1"))
    made.command("me", live.Clear("s0", "user"))
    made.command("me", request.Stop(NOTHING))
    made.end(NOTHING)
    made.close()
    assert Reader(path).count("/commands") == 2
