from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.wire import live, request


def test_every_no_of_a_runtime_has_words():
    assert refusal(request.Refused("it is full")) == "it is full"
    assert str(refusal(request.Prepared((), ("a note",)))) == "a note"
    assert str(refusal(live.Value(1))) == "expected the runtime to do it, found Value"
