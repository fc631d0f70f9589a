from msgspec.structs import replace

from kit.record.recording_builder import RecordingBuilder, run
from onika.desk.run.recording_digest import digest_lines
from onika.desk.run.run_review import Review
from onika.wire import event, request
from onika.wire.plan import Plan, PlannedFlow
from onika.words.reason import Reason


def taped(tmp_path):
    tape = RecordingBuilder(tmp_path / "run.mcap")
    tape.variable("X", "double", (0.0, 1.0))
    tape.tell(0.5, event.Began(0, 0, 2, "one", 0.5))
    tape.tell(1.0, event.Done(0, 0, 1.0))
    tape.tell(1.0, event.Began(0, 1, 2, "two", 1.0))
    tape.tell(2.0, event.Failed("flow0", "servo", Reason.plain("cycle: broken"), "servo.py", 3, "", 2.0))
    return tape


def lines(tape):
    with Review(tape.path) as review:
        return [str(line) for line in digest_lines(review)]


def test_it_tells_what_was_run_and_how_it_ended(tmp_path):  # R-X05
    tape = taped(tmp_path)
    tape.end(completed="no", cause="enough", hash="abc", missed="4")
    output = lines(tape)
    assert "virtual time, begun 2026-01-02T03:04:05+00:00, seed 3" in output[0]
    assert "2 s recorded, 1 variables, 4 events" in output
    assert "flow0: 1 of 2 actions done" in output
    assert any("not ended" in line and "2/2" in line for line in output)
    assert any("servo failed: cycle: broken" in line for line in output)
    assert output[-2:] == ["aborted: enough, hash abc", "4 values were written over before they were seen"]


def test_an_action_that_a_loop_repeats_is_counted_once_with_its_times(tmp_path):  # R-X05
    tape = taped(tmp_path)
    tape.tell(2.0, event.Done(0, 1, 2.0))
    for at in (2.0, 3.0):
        tape.tell(at, event.Began(0, 0, 2, "one", at))
        tape.tell(at + 0.5, event.Done(0, 0, at + 0.5))
    tape.end(completed="no", cause="enough")
    assert "flow0: 2 of 2 actions done, some more than once, 4 times in all" in lines(tape)


def test_an_action_that_was_left_when_the_run_was_aborted_is_not_done(tmp_path):  # R-X05
    tape = taped(tmp_path)
    tape.tell(2.5, event.Result(False, Reason.plain("enough"), 1, 2, 2.5, 0.1, {}, (), ""))
    tape.end(completed="no", cause="enough")
    output = lines(tape)
    assert "flow0: 1 of 2 actions done" in output
    assert any("2/2  two: left before its end" in line for line in output)


def test_it_says_that_a_file_was_cut_short(tmp_path):  # R-X05
    tape = taped(tmp_path)
    tape.cut()
    assert lines(tape)[-1].startswith("the file was cut short")


def test_the_last_seconds_of_a_subsystem_that_was_held_by_hand_say_so(tmp_path):  # R-X05
    plan = Plan("jog", (PlannedFlow("jog", (), ()),), ())
    by_hand = replace(run(), prepare=request.Prepare(plan, ()), is_by_hand=True)
    tape = RecordingBuilder(tmp_path / "run.mcap", by_hand, (0.5, 2.0))
    tape.tell(2.0, event.Failed("jog", "servo", Reason.plain("cycle: broken"), "servo.py", 3, "", 2.0), "jog")
    tape.end(completed="no", goes_on="yes", cause="servo: broken")
    output = lines(tape)
    assert output[0].startswith("subsystem jog, held by hand, in virtual time, from 2026-01-02T03:04:05+00:00 on")
    assert output[2] == "a black box: the last seconds before something went wrong by hand, from 0.5 s to 2 s"
    assert output[-1] == "went wrong: servo: broken"
    assert not any("actions" in line for line in output)
