"""The replay of drives: it passes what a world does with good commands and bad, and complains of anything else."""

from contextlib import nullcontext
from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from msgspec import structs

from kit.record.drive_replay import complaints, complaints_of_recordings
from kit.record.recording_builder import RecordingBuilder
from kit.worlds.box_cells import boxes_world
from onika.ring.device import DeviceOrder, DriveState
from onika.ring.drive import DriveInput, DriveMode
from onika.wire import event

MS = 1_000_000
ARM = "arm_left"
HELD = frozenset({DriveMode.HELD})
GOOD = np.zeros(6)


class Course:
    """A world with one arm, and all that its drive has told."""

    def __init__(self):
        self.world = boxes_world()
        self.count = len(self.world.claim(ARM, 1).command)
        self.events = []

    def drive(self, epoch=1, **given):
        self.world.command(ARM, epoch, given.get("order", DeviceOrder.DRIVE), given.get("values", GOOD))
        return self.mode

    def step(self, ms):
        self.world.step(self.world.now_ns + ms * MS)
        return self.mode

    @property
    def mode(self):
        for told in self.world.take_events():
            cause = told.cause
            state = DriveState(told.state).name
            instants = told.at_ns, told.previous_step_ns, told.last_command_ns
            self.events.append(event.Drive(f"boxes:{told.device}", state, *instants, cause))
        return self.world.modes()[ARM]


@dataclass(frozen=True)
class Bad:
    """A command that must never move the arm, and the mode in which it leaves a drive that was driven."""

    given: dict
    mode: DriveMode
    error: type[Exception] | None = None


BAD = {
    "no number": Bad({"values": np.full(6, np.nan)}, DriveMode.TRIPPED),
    "one infinity": Bad({"values": np.array([0, 0, np.inf, 0, 0, 0.0])}, DriveMode.TRIPPED),
    "too few values": Bad({"values": np.zeros(5)}, DriveMode.HELD, ValueError),
    "no such order": Bad({"order": 7}, DriveMode.HELD, ValueError),
    "a stranger": Bad({"epoch": 2}, DriveMode.HELD),
    "nobody": Bad({"epoch": 0}, DriveMode.HELD),
}


def test_every_good_command_is_followed_and_the_table_makes_all_that_was_told():  # R-X24
    course = Course()
    assert [course.drive() for _ in range(20) if course.step(10)] == [DriveMode.DRIVEN] * 20
    assert course.drive(order=DeviceOrder.HOLD) is DriveMode.HELD
    assert course.drive() is DriveMode.DRIVEN
    assert [event.state for event in course.events] == ["DRIVEN", "HELD", "DRIVEN"]
    assert list(complaints(course.events, HELD)) == []


@pytest.mark.parametrize("bad", BAD.values(), ids=BAD)
def test_no_bad_command_sets_a_held_drive_in_motion(bad):  # R-X24
    course = Course()
    if bad.error:
        with pytest.raises(bad.error):
            course.drive(**bad.given)
    else:
        course.drive(**bad.given)
    assert course.step(2) is bad.mode
    assert "DRIVEN" not in {told.state for told in course.events}
    assert list(complaints(course.events, HELD)) == []


def test_a_command_that_comes_too_late_finds_a_drive_that_holds_or_has_tripped():  # law 17
    course = Course()
    course.drive()
    assert (course.step(50), course.step(4)) == (DriveMode.DRIVEN, DriveMode.SILENT)
    course.drive()
    assert (course.step(250), course.step(6)) == (DriveMode.SILENT, DriveMode.TRIPPED)
    assert course.drive() is DriveMode.TRIPPED
    assert list(complaints(course.events, HELD)) == []


ACTS = st.sampled_from(
    ["drive", "hold", "clear", "wait", "long", "press", "let go", "stop", "go on", "writer", "release", *BAD]
)


@settings(max_examples=25)
@given(st.lists(ACTS, max_size=25))
def test_whatever_happens_the_table_makes_it_and_only_a_good_command_moves(acts):  # R-X24
    course, epoch = Course(), 1
    for act in acts:
        before = course.mode
        match act:
            case "drive" | "hold" | "clear":
                course.drive(epoch, order=DeviceOrder[act.upper()])
            case "wait" | "long":
                course.step(30 if act == "wait" else 260)
            case "press" | "let go":
                course.world.touch("panic_left", float(act == "press"))
            case "stop":
                course.world.stop()
            case "go on":
                course.world.go_on()
            case "writer" | "release":
                course.world.fence(epoch) if act == "writer" else course.world.release(ARM, epoch)
                epoch += 10
                course.world.claim(ARM, epoch)
            case _:
                bad = BAD[act]
                with pytest.raises(bad.error) if bad.error else nullcontext():
                    course.drive(**{"epoch": epoch, **bad.given})
        if act != "drive" and before is not DriveMode.DRIVEN:
            assert course.mode is not DriveMode.DRIVEN
    assert list(complaints(course.events, HELD)) == []


def told(state, drive_input, at_ns=100 * MS, last_ns=0):
    return event.Drive("boxes:arm", state, at_ns, at_ns - 2 * MS, last_ns, drive_input.value)


DRIVEN = told("DRIVEN", DriveInput.DRIVE)


@pytest.mark.parametrize(
    ("events", "complaint"),
    [
        ([told("TRIPPED", DriveInput.DRIVE)], "TRIPPED by DRIVE is not in the table"),
        ([DRIVEN, told("TRIPPED", DriveInput.SILENCE, 52 * MS)], "TRIPPED by SILENCE is not in the table"),
        ([told("PRESSED", DriveInput.PRESS), DRIVEN], "DRIVEN by DRIVE is not in the table"),
        ([told("TRIPPED", DriveInput.FENCE), DRIVEN], "DRIVEN by DRIVE is not in the table"),
        ([DRIVEN, DRIVEN], "DRIVEN by DRIVE is not in the table"),
        ([DRIVEN, told("HELD", DriveInput.LET_GO)], "HELD by LET_GO is not in the table"),
        ([told("PRESSED", DriveInput.PRESS), told("HELD", DriveInput.CLEAR)], "HELD by CLEAR is not in the table"),
        ([DRIVEN, told("HELD", DriveInput.SILENCE, 50 * MS)], "SILENCE after 50000000 ns only"),
        ([DRIVEN, told("HELD", DriveInput.SILENCE, 54 * MS)], "SILENCE a step late"),
    ],
)
def test_what_the_table_does_not_make_is_complained_of(events, complaint):  # R-X24
    assert complaint in " ".join(complaints(events, HELD))


def test_a_drive_of_another_world_is_not_judged():
    strange = structs.replace(DRIVEN, state="TRIPPED", cause="by hand")
    assert list(complaints([strange])) == []


def test_recordings_are_replayed_and_one_that_cannot_be_read_is_not_judged(tmp_path):  # R-X24
    (tmp_path / "spoilt.mcap").write_bytes(b"no recording")
    for name, events in {"good": [DRIVEN], "bad": [DRIVEN, DRIVEN]}.items():
        builder = RecordingBuilder(tmp_path / f"{name}.mcap")
        for message in events:
            builder.tell(0.1, message)
        builder.end()
    (complaint,) = complaints_of_recordings(tmp_path)
    (tmp_path / "bad.mcap").unlink()  # as every recording is replayed when all tests have ended
    assert complaint.startswith("bad.mcap: boxes:arm at 100000000 ns: DRIVEN by DRIVE")
