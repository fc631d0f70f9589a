from onika.desk.run.steering_fault import objection
from onika.words.fault import Fault, Place

HERE = Place("s", 1)


def test_a_text_that_says_what_was_expected_and_found_is_a_fault():  # R-E07
    assert objection(HERE, "expected a flow, found 'x'", "no") == Fault(HERE, "a flow", "'x'", "no")


def test_what_was_found_may_go_without_saying():  # R-E07
    assert objection(HERE, "expected flow 0 in a loop", "no") == Fault(HERE, "flow 0 in a loop", "it is not so", "no")


def test_any_other_reason_is_what_was_found():  # R-E07
    fault = objection(HERE, "the run is over", "no")
    assert fault == Fault(HERE, "a line that can be carried out", "the run is over", "no")
