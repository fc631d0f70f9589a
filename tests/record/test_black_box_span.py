import pytest

from onika.record.black_box_span import BlackBoxSpan


def test_a_recording_without_the_note_is_none():  # R-X05
    assert BlackBoxSpan.of({"onika": {}}) is None


def test_it_says_from_when_to_when_and_whether_the_run_went_on():  # R-X05
    held = {"version": "1", "from_ns": "2000", "to_ns": "5000"}
    assert BlackBoxSpan.of({"black box": held}) == BlackBoxSpan(2000, 5000, False)
    assert BlackBoxSpan.of({"black box": held, "end": {"goes_on": "yes"}}) == BlackBoxSpan(2000, 5000, True)


@pytest.mark.parametrize("text", ["", "-5", "1e9", "soon", "9" * 19, "\u0663"])
def test_what_is_no_time_in_a_file_somebody_else_wrote_counts_as_the_begin(text):  # R-X05
    assert BlackBoxSpan.of({"black box": {"from_ns": text, "to_ns": text}}) == BlackBoxSpan(0, 0, False)
