"""Recordings of subsystems that are held by hand, in virtual time (requirement X05)."""

from itertools import pairwise

import pytest
from tests.host.recording.test_hand_held import MASS, PUSH, ROW

from kit.runtime.live_edits import LiveEdits
from onika.desk.run.run_review import Review
from onika.host.recording.hand_recordings import MOST
from onika.record import topics
from onika.record.reader import Reader
from onika.wire import event, live, request
from onika.words.reason import NOTHING, Reason


class Recorded:
    """A mass that is pushed by hand, to be recorded into a file."""

    def __init__(self, folder):
        self.path = folder / "push.mcap"
        self.edits = LiveEdits()
        self.edits.task("mass", MASS, frequency=500.0, local={"DEVICE": "yard:m0"})
        self.edits.task("push", PUSH, frequency=500.0)
        self.edits.task("row", ROW, frequency=50.0)
        assert self.edits.change(spawn=("mass", "push"), on=("mass", "push")) == ""
        self.edits.let_pass(1.0)

    def record(self, path=None, subsystem="s0"):
        return self.edits.asker.ask(live.Record(subsystem, str(path or self.path)))

    def end(self):
        return self.edits.asker.ask(live.Record("s0"))

    @property
    def told(self):
        return self.edits.asker.of(event.Recording)

    @property
    def file(self):
        """What the runtime says of it."""
        standing = self.edits.asker.ask(live.Survey())
        return {subsystem.name: subsystem.recording for subsystem in standing.subsystems}.get("s0")


@pytest.fixture
def hand(tmp_path):
    hand = Recorded(tmp_path)
    yield hand
    hand.edits.asker.program.close()


def test_what_is_held_by_hand_is_recorded_at_full_rate_until_that_is_ended(hand):  # R-X05, law 29
    assert hand.record() == request.Done()
    assert hand.file == str(hand.path)
    hand.edits.let_pass(2.0)
    assert hand.end() == request.Done()
    hand.edits.let_pass(1.0)
    assert hand.file == ""
    with Review(hand.path) as review:
        assert review.is_whole and review.run.is_by_hand and review.black_box is None
        assert review.run.prepare.plan.application == "s0"
        assert {code.digest for code in review.run.prepare.plan.code}
        assert review.series["s0/FORCE"].unit == "N"
        forces = [number for _, number in review.series["s0/FORCE"].values()]
        assert [later - before for before, later in pairwise(forces)] == [1.0] * (len(forces) - 1)
        assert 999 <= len(forces) <= 1002  # 2 s at 500 Hz, and what was there at the begin
        assert forces[0] >= 500.0  # nothing of before
        assert review.ending["missed"] == "0" and float(review.ending["seconds"]) == pytest.approx(2.0)
        assert review.at(0.0).tasks == {"s0/mass": "ON", "s0/push": "ON"}
        assert review.poses("yard", 1.0)


def test_its_begin_and_its_end_are_told_to_everybody(hand):  # R-X05
    hand.record()
    hand.edits.let_pass(0.5)
    hand.end()
    begun, ended = hand.told
    assert (begun.subsystem, begun.path, begun.is_on, begun.cause) == ("s0", str(hand.path), True, NOTHING)
    assert (ended.is_on, ended.cause, ended.lasted_s) == (False, NOTHING, pytest.approx(0.5))


def test_what_changes_meanwhile_is_in_it(hand):  # R-X05, law 29
    hand.record()
    hand.edits.let_pass(0.2)
    assert hand.edits.change(spawn=("row",), on=("row",)) == ""
    hand.edits.let_pass(0.2)
    assert hand.edits.change(kill=("push",)) == ""
    hand.edits.let_pass(0.2)
    hand.end()
    with Review(hand.path) as review:
        assert {task.name for task in review.run.prepare.plan.flows[0].tasks} == {"mass", "row"}
        assert review.at(0.3).tasks["s0/row"] == "ON" and "s0/row" not in review.at(0.1).tasks
        assert review.at(review.span_s[1]).tasks["s0/push"] == "KILLED"
        assert list(review.at(0.3).variables["s0/ROW"]) == [1.0, 2.0, 3.0]
        assert [type(command) for _, command in review.commands] == [live.Change, live.Change]


def test_it_ends_where_its_subsystem_does(hand):  # R-X05
    hand.record()
    hand.edits.let_pass(0.2)
    assert hand.edits.outcome(hand.edits.asker.ask(live.Close("s0"))) == ""
    hand.edits.work()
    assert [(told.is_on, told.cause.key) for told in hand.told] == [
        (True, ""),
        (False, "host.recorded_is_gone"),
    ]
    with Review(hand.path) as review:
        assert review.is_whole
        assert {task.name for task in review.run.prepare.plan.flows[0].tasks} == {"mass", "push"}


def test_it_ends_where_the_runtime_does(hand):  # R-X05
    hand.record()
    hand.edits.let_pass(0.2)
    hand.edits.asker.program.close()
    with Review(hand.path) as review:
        assert review.is_whole and "runtime" in review.ending["cause"]


def test_a_full_disk_ends_the_recording_and_nothing_else(hand):  # R-X05
    hand.record()
    recording = hand.edits.asker.program.recordings.by_hand._recordings["s0"]
    recording._writer.reason = Reason.plain("no space is left")
    hand.edits.let_pass(3.0)
    assert [told.is_on for told in hand.told] == [True, False]
    assert "no space is left" in str(hand.told[-1].cause)
    assert hand.edits.states == {"mass": "ON", "push": "ON"}
    assert hand.record() == request.Done()


def test_a_file_that_is_taken_away_ends_the_recording_and_nothing_else(hand):  # R-X05
    hand.record()
    hand.path.unlink()
    hand.edits.let_pass(3.0)
    hand.edits.work()
    assert hand.told[-1].cause.key == "host.recording_not_whole"
    assert hand.edits.states == {"mass": "ON", "push": "ON"}


@pytest.mark.parametrize(
    ("subsystem", "path", "key"),
    [
        ("s0", "/nowhere/a.mcap", "host.no_recording"),
        ("s0", "/dev/full", "host.no_recording"),
        ("other", "/tmp/never.mcap", "host.nothing_to_record"),
        ("s0", "", "host.not_recorded"),
    ],
)
def test_what_cannot_be_recorded_is_refused_with_its_reason(hand, subsystem, path, key):  # R-X05
    answer = hand.edits.asker.ask(live.Record(subsystem, path))
    assert answer.reason.key == key
    assert hand.told == []


def test_a_subsystem_is_recorded_into_one_file_and_a_file_takes_one_subsystem(hand, tmp_path):  # R-X05
    hand.record()
    assert hand.record(tmp_path / "other.mcap").reason.key == "host.recorded_already"
    assert hand.edits.change(spawn=("row",), on=("row",), subsystem="s1") == ""
    assert hand.record(subsystem="s1").reason.key == "host.file_recorded_into"
    assert hand.record(tmp_path / "other.mcap", "s1") == request.Done()


def test_so_many_are_made_at_a_time(hand, tmp_path):  # R-X05
    for number in range(MOST + 1):
        assert hand.edits.change(spawn=("row",), subsystem=f"t{number}") == ""
    answers = [hand.record(tmp_path / f"{number}.mcap", f"t{number}") for number in range(MOST + 1)]
    assert answers[:-1] == [request.Done()] * MOST
    assert answers[-1].reason.key == "host.too_many_recordings"


def test_a_recording_changes_nothing_in_what_it_records(tmp_path):  # R-X05
    def course(is_recorded):
        hand = Recorded(tmp_path)
        if is_recorded:
            hand.record()
        hand.edits.let_pass(1.0)
        hand.edits.asker.program.close()
        return hand.edits.values("X", "FORCE"), hand.edits.driver.now

    assert course(is_recorded=True) == course(is_recorded=False)


def test_news_of_other_subsystems_are_not_in_it(hand):  # law 29
    hand.record()
    assert hand.edits.change(spawn=("row",), on=("row",), subsystem="s1") == ""
    hand.edits.let_pass(0.1)
    hand.end()
    happened = [topics.decode_happened(body) for _, body in Reader(hand.path).messages(topics.EVENTS)]
    assert {record.subsystem for record in happened} <= {"s0", ""}
    assert Review(hand.path).commands == []
