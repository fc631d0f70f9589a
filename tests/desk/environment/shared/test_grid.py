from onika.desk.environment.shared.grid import grid
from onika.wire.view import MarkView, PassageView, RecordedFlowView, RecordingView
from onika.words.reason import Reason


def recording(**more):
    passages = (PassageView(0, "a", 0.0, 0.513), PassageView(1, "b", 0.513))
    return RecordingView("", "", begin_s=0.0, end_s=1.0, flows={"flow0": RecordedFlowView(0, passages)}, **more)


def test_instants_lie_evenly_and_none_that_has_a_name_is_left_out():  # R-X21: scrubbing to where an action begins
    mark = MarkView(0.7, "error", Reason.plain("bad"))
    assert grid(recording(marks=(mark,)), 0.25).tolist() == [
        0, 250_000_000, 500_000_000, 513_000_000, 700_000_000, 750_000_000, 1_000_000_000,
    ]  # fmt: skip


def test_what_lies_beside_the_recording_is_no_instant_of_it():  # R-X21: bad input
    mark = MarkView(7.0, "error", Reason.plain("bad"))
    assert grid(recording(marks=(mark,)), 2.0).tolist() == [0, 513_000_000, 1_000_000_000]


def test_a_recording_of_nothing_has_one_instant():  # R-X21: bad input
    assert grid(RecordingView("", ""), 0.01).tolist() == [0]
