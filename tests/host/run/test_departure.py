from onika.engine.news import Abort
from onika.host.run.departure import after_departure
from onika.wire.steer import Pause
from onika.words.reason import Reason

GONE = Reason.plain("gone")


def test_a_run_ends_pauses_or_goes_on_as_it_was_begun():  # R-X12, R-X24
    assert after_departure("stop", ("flow0", "flow1"), GONE) == (Abort(GONE),)
    assert after_departure("finish", ("flow0", "flow1"), GONE) == (Pause("flow0"), Pause("flow1"))
    assert after_departure("run", ("flow0", "flow1"), GONE) == ()
