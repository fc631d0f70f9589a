import pytest

from kit.record.recording_builder import RecordingBuilder, run
from onika.desk.run.recorded_run import RecordedRun, events_of, inputs_of, recorded_run
from onika.desk.run.settings import RecordingSource
from onika.wire import event, request, steer
from onika.wire.request import decode_request

ASKED = ((0.5, steer.Pause("flow0")), (2.0, request.Reply("flow0", "servo", "1")), (1.0, steer.Resume("flow0")))


@pytest.fixture
def path(tmp_path):
    return tmp_path / "run.mcap"


def taped(path, **other):
    tape = RecordingBuilder(path, run(**other))
    for at_s, message in ASKED:
        tape.ask(at_s, message)
    tape.tell(3.0, event.Done(0, 0, 3.0))
    return tape


def test_inputs_are_in_the_order_in_which_they_were_asked(path):  # law 29
    inputs = inputs_of(taped(path).end())
    assert [decode_request(item.body) for item in inputs] == [
        message for _, message in sorted(ASKED, key=lambda pair: pair[0])
    ]
    assert [item.at_ns for item in inputs_of(taped(path).end(), 1_000_000_000)] == [500_000_000, 1_000_000_000]


def test_events_are_told_with_their_times(path):
    assert events_of(taped(path).end()) == [(3_000_000_000, "flow0", event.Done(0, 0, 3.0))]


def test_a_run_is_begun_as_it_was_with_what_is_wanted_beside(path):  # R-X05
    taped(path, seed=9).end(hash="abc")
    record = recorded_run(RecordingSource(path, 1.5))
    assert isinstance(record, RecordedRun)
    begin = record.begin(request.Begin(watch=("X",), is_held=True, record="b.mcap", seed=1))
    assert (begin.seed, begin.watch, begin.is_held, begin.record) == (9, ("X",), True, "b.mcap")
    assert (len(begin.repeat), begin.repeat_until_ns, record.hash) == (2, 1_500_000_000, "abc")
    assert (record.is_before(1.4), record.is_before(1.5)) == (True, False)
    assert record.notes == ()


def test_one_that_was_cut_short_is_repeated_as_far_as_it_goes(path):  # R-X05
    taped(path).cut()
    cut = recorded_run(RecordingSource(path))
    assert cut.until_ns == 3_000_000_000
    assert str(cut.notes[0]).startswith("the recording was cut short: it is repeated up to 3 s, and from there")
    assert recorded_run(RecordingSource(path, 1.0)).notes == ()
    taped(path).end()
    record = recorded_run(RecordingSource(path))
    assert (record.until_ns, record.is_before(1e9), record.notes) == (-1, True, ())


def test_a_wall_run_is_approximate_and_says_so(path):  # law 29
    taped(path, is_virtual=False).end()
    record = recorded_run(RecordingSource(path, 1.0))
    assert not record.is_exact
    assert str(record.notes[0]).startswith("approximate:")


@pytest.mark.parametrize(
    ("other", "words", "at_s", "expected"),
    [
        ({"is_fresh": False}, {}, 1.0, "first on its runtime"),
        ({}, {"outside": "flow0/planner"}, 1.0, "law 15"),
        ({}, {}, 9.0, "an instant from 0 to 3 s"),
    ],
)
def test_what_cannot_be_repeated_is_refused_with_the_reason(path, other, words, at_s, expected):  # R-E01
    taped(path, **other).end(**words)
    (fault,) = recorded_run(RecordingSource(path, at_s))
    assert expected in str(fault)


def test_a_file_that_is_no_recording_is_refused(tmp_path, path):  # R-E01
    path.write_text("no recording")
    assert "found something else" in str(recorded_run(RecordingSource(path))[0])
    assert "no such file" in str(recorded_run(RecordingSource(tmp_path / "nothing"))[0])


def test_what_was_held_by_hand_is_not_repeated(path):  # R-X05
    taped(path, is_by_hand=True, is_fresh=False).end()
    (fault,) = recorded_run(RecordingSource(path))
    assert fault.reason.args["given"].key == "desk.held_by_hand"
