from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.wire import live, request
from onika.words.reason import Reason


def test_every_no_of_a_runtime_has_words():
    assert str(refusal(request.Refused(Reason.plain("it is full")))) == "it is full"
    assert str(refusal(request.Prepared((), (Reason.plain("a note"),)))) == "a note"
    assert str(refusal(live.Value(1))) == "expected the runtime to do it, found Value"
