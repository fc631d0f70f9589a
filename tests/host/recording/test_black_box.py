from pathlib import Path

import pytest
from msgspec.structs import replace

from kit.plans.plan_builder import action
from kit.runtime.direct_client import DirectClient
from kit.worlds.rail_world import rail_tasks
from onika.desk.run.run_review import Review
from onika.host.recording.black_box import MOST_FAULTS
from onika.host.recording.black_box_holder import InProcessHolder
from onika.record.black_box_folder import black_boxes
from onika.record.summary import summary
from onika.wire import event, live, request, steer
from onika.words.reason import Reason

PLAN = rail_tasks().plan([action("mass", "servo", arguments=goal) for goal in ("1.0", "2.0")])
MS = 1_000_000
MOST_INSTANTS = 100_000


class Boxed:
    """A runtime with a black box, at which a run has begun."""

    def __init__(self, folder, holder=InProcessHolder):
        self.folder = folder
        self.desk = DirectClient()
        self.holders = []
        self.desk.program.recordings.keep_last_seconds(folder, holder(), self.make)
        self.begin()

    def make(self):
        self.holders.append(InProcessHolder())
        return self.holders[-1]

    def begin(self, **how):
        self.desk.ask(request.Prepare(PLAN, ()))
        assert self.desk.ask(request.Begin(**how)) == request.Done()

    def go_to(self, at_ns):
        for _ in range(MOST_INSTANTS):
            if self.desk.driver.now >= at_ns:
                return
            self.desk.program.advance(0)
        raise AssertionError(f"the clock stands at {self.desk.driver.now} ns: nothing runs")

    def states(self):
        """The last state of each task."""
        return {f"{told.subsystem}/{told.task}": told.state for told in self.desk.of(event.TaskState)}

    def end(self):
        self.desk.to_the_end()
        return self.desk.of(event.Result)[-1]


@pytest.fixture
def boxed(tmp_path):
    return Boxed(tmp_path / "boxes")


def press(boxed):
    """The panic button is pressed and let go: the drive has tripped, and its task fails."""
    boxed.go_to(boxed.desk.driver.now + 300 * MS)
    for value in (1.0, 0.0):
        boxed.desk.ask(live.Touch("yard", "panic", value))


def test_a_run_that_completes_leaves_nothing(boxed):  # R-X05
    result = boxed.end()
    assert (result.completed, result.black_box) == (True, "")
    assert not boxed.folder.exists()


def test_a_run_that_fails_leaves_its_last_seconds_and_the_result_names_them(boxed):  # R-X05
    press(boxed)
    result = boxed.end()
    assert not result.completed
    assert [str(path) for path in black_boxes(boxed.folder)] == [result.black_box]
    with Review(Path(result.black_box)) as review:
        assert review.is_whole
        assert review.run.prepare.plan == PLAN
        assert review.ending["cause"] == str(result.cause)
        failed = [message for _, _, message in review.events if isinstance(message, event.Failed)]
        assert failed == boxed.desk.of(event.Failed)
        last = review.at(review.span_s[1])
        assert last.tasks == boxed.states()
        assert last.drives["yard:m0"] != "DRIVEN"
        assert 0.0 < last.variables["flow0/X"][0] < 1.0
        assert [type(asked) for _, asked in review.commands] == [live.Touch, live.Touch]


def test_a_black_box_changes_nothing_in_a_run(boxed):  # R-X05, law 14
    plain = DirectClient()
    plain.ask(request.Prepare(PLAN, ()))
    plain.ask(request.Begin())
    assert boxed.end().hash == plain.to_the_end().hash


def test_who_ends_a_run_as_he_wishes_leaves_nothing(boxed):  # R-X05
    boxed.go_to(300 * MS)
    boxed.desk.ask(request.Abort(Reason.plain("enough")))
    assert boxed.end().black_box == ""
    assert not boxed.folder.exists()


def test_who_ends_a_run_in_which_something_went_wrong_leaves_it(tmp_path):  # R-X05
    boxed = Boxed(tmp_path / "boxes")
    boxed.end()
    boxed.begin(on_error="wait")
    press(boxed)
    boxed.desk.to_the_end()
    boxed.desk.ask(request.Abort(Reason.plain("enough")))
    assert boxed.end().black_box


def test_a_stop_leaves_its_last_seconds(boxed):  # R-X05, law 27
    boxed.go_to(300 * MS)
    boxed.desk.ask(request.Stop(Reason.plain("red button")))
    assert boxed.end().black_box


def test_a_runtime_that_ends_before_the_run_leaves_its_last_seconds(boxed):  # R-X05
    boxed.go_to(300 * MS)
    boxed.desk.program.close()
    (path,) = black_boxes(boxed.folder)
    with Review(path) as review:
        assert review.ending["cause"] == "the runtime has ended before the run"


def test_what_was_asked_long_before_does_not_hold_a_run_up(boxed):  # R-X05
    boxed.go_to(200 * MS)
    boxed.desk.ask(steer.Pause())
    boxed.desk.to_the_end()
    boxed.desk.ask(steer.Resume())
    press(boxed)
    with Review(Path(boxed.end().black_box)) as review:
        assert [type(asked) for _, asked in review.commands] == [steer.Pause, steer.Resume, live.Touch, live.Touch]


def test_a_folder_that_cannot_be_written_is_told_and_the_run_ends_all_the_same(tmp_path):  # R-X05, R-E01
    in_the_way = tmp_path / "boxes"
    in_the_way.write_text("a file")
    boxed = Boxed(in_the_way)
    press(boxed)
    result = boxed.end()
    assert (result.completed, result.black_box) == (False, "")
    (warned,) = [message.text for message in boxed.desk.of(event.Warned) if not message.task]
    assert warned.key == "host.no_black_box"


def test_a_holder_that_dies_is_told_and_the_next_run_has_another(tmp_path):  # R-X05
    boxed = Boxed(tmp_path / "boxes")
    boxed.desk.program.recordings.black_box._holder.is_lost = True
    boxed.desk.ask(request.Stop(Reason.plain("red button")))
    assert boxed.end().black_box == ""
    assert [message.text.key for message in boxed.desk.of(event.Warned) if not message.task] == ["host.no_black_box"]
    boxed.desk.ask(live.Reset())
    boxed.begin()
    press(boxed)
    assert boxed.end().black_box
    assert len(boxed.holders) == 1


class _Refusing(InProcessHolder):
    """Has no memory to share."""

    def open(self, order, run):
        raise OSError(24, "Too many open files")


def test_a_run_goes_on_where_nothing_can_be_held(tmp_path):  # R-X05, R-E01
    boxed = Boxed(tmp_path / "boxes", _Refusing)
    assert boxed.end().completed
    assert [message.text.key for message in boxed.desk.of(event.Warned)] == ["host.no_black_box"]


def waits(tmp_path):
    """A run that waits at a fault, and stands at one now."""
    boxed = Boxed(tmp_path / "boxes")
    boxed.end()
    boxed.begin(on_error="wait")
    press(boxed)
    boxed.desk.to_the_end()
    return boxed


def test_a_run_that_waits_at_a_fault_leaves_the_seconds_before_it_at_once(tmp_path):  # R-X05, R-E08
    boxed = waits(tmp_path)
    (kept,) = boxed.desk.of(event.LastSecondsKept)
    explained = boxed.desk.of(event.Explained)[-1]
    assert (kept.subsystem, kept.at_s) == (explained.subsystem, explained.at_s)
    assert [str(path) for path in black_boxes(boxed.folder)] == [kept.path]
    with Review(Path(kept.path)) as review:
        assert review.black_box.goes_on
        assert review.ending["cause"] == str(explained.text)
        assert boxed.desk.of(event.Failed)[-1] in [message for _, _, message in review.events]
        assert not [message for _, _, message in review.events if isinstance(message, event.LastSecondsKept)]
        assert 0.0 < review.at(review.span_s[1]).variables["flow0/X"][0] < 2.0


def test_who_ends_it_long_after_finds_the_fault_and_the_end(tmp_path):  # R-X05
    boxed = waits(tmp_path)
    boxed.desk.ask(live.Advance(40.0))
    boxed.desk.ask(request.Abort(Reason.plain("enough")))
    result = boxed.end()
    (kept,) = boxed.desk.of(event.LastSecondsKept)
    assert {str(path) for path in black_boxes(boxed.folder)} == {kept.path, result.black_box}
    with Review(Path(kept.path)) as fault, Review(Path(result.black_box)) as end:
        assert fault.black_box.end_ns < end.black_box.begin_ns
        about = summary(end.path)
        assert about.is_black_box
        assert 29.0 < about.lasted_s < 32.0 < about.took_s
        assert (fault.black_box.goes_on, end.black_box.goes_on) == (True, False)


def test_of_many_faults_only_the_first_are_written(tmp_path):  # R-X05
    boxed = waits(tmp_path)
    explained = boxed.desk.of(event.Explained)[-1]
    for number in range(1, MOST_FAULTS + 3):
        boxed.desk.server.tell(replace(explained, at_s=explained.at_s + number), "flow0")
        boxed.desk.program.advance(0)
    assert len(boxed.desk.of(event.LastSecondsKept)) == len(black_boxes(boxed.folder)) == MOST_FAULTS


def test_a_fault_whose_seconds_cannot_be_written_is_told_and_the_run_stands_all_the_same(tmp_path):  # R-X05, R-E01
    (tmp_path / "boxes").write_text("a file")
    boxed = waits(tmp_path)
    assert boxed.desk.of(event.LastSecondsKept) == []
    assert "host.no_black_box" in [message.text.key for message in boxed.desk.of(event.Warned)]
    assert boxed.desk.of(event.Moved)[-1].state == "stopped"
