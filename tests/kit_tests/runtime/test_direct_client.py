import pytest

from kit.runtime.direct_client import DirectClient, OpenGate
from onika.wire import event, live, request
from onika.wire.runtime_standing import Standing
from onika.words.reason import Reason


def test_a_request_is_answered_once():
    gate = OpenGate()
    gate.reply(1, request.Done())
    with pytest.raises(KeyError, match="request 1 is answered already"):
        gate.reply(1, request.Done())


def test_who_asks_gets_the_answer_that_belongs_to_it():
    asker = DirectClient()
    first, second = asker.send(live.Advance(1.0)), asker.send(live.Survey())
    assert first not in asker.server.replies
    assert isinstance(asker.server.replies[second], Standing)


def test_the_outcome_of_a_request_is_its_reason_or_nothing():
    asker = DirectClient()
    assert asker.outcome(request.Refused(Reason.plain("no"))) == "no"
    assert "one of no task, found x" in asker.change(kill=("x",))
    with pytest.raises(TypeError, match="expected Accepted"):
        asker.outcome(request.Done())
    with pytest.raises(RuntimeError, match="expected one outcome of 7"):
        asker.outcome(live.Accepted(7))


def test_events_are_found_by_kind():
    asker = DirectClient()
    asker.ask(request.Stop(Reason.plain("enough")))
    assert asker.of(event.Stopped) == [event.Stopped(True, Reason.plain("enough"))]
    assert asker.result is None
