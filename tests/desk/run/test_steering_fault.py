from onika.desk.run.steering_fault import GOES_ON, objection
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

HERE = Place("s", 1)


def test_a_reason_is_the_fault():  # R-E07
    reason = Reason.of("words.nothing_run")
    assert objection(HERE, reason, GOES_ON) == Fault(HERE, reason, GOES_ON)


def test_a_bare_text_is_what_was_found():  # R-E07
    fault = objection(HERE, "the run is over", GOES_ON)
    assert fault == Fault(HERE, Reason.of("desk.line_refused", text="the run is over"), GOES_ON)
