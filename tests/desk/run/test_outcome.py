from onika.desk.run.outcome import Outcome
from onika.wire import event
from onika.words.condition import Condition
from onika.words.fault import Fault, Place
from onika.words.reason import NOTHING, Reason

GOOD = event.Result(True, NOTHING, 1, 1, 2.0, 0.1, {"LAMP": 1}, (), "abc")


def test_an_outcome_says_how_it_ended():  # R-E14
    assert (Outcome("x").state, Outcome("x").exit_code) == ("refused", 2)
    held = Condition.parse("LAMP == 1")
    assert Outcome("x", result=GOOD, expectations=[(held, 1, True)]).exit_code == 0
    assert Outcome("x", result=GOOD, expectations=[(held, 0, False)]).exit_code == 1
    assert (
        Outcome(
            "x", result=GOOD, failed=(Fault(Place("s", 1), Reason.plain("expected a, found b"), Reason.plain("c")),)
        ).exit_code
        == 1
    )
