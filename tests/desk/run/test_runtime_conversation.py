from itertools import islice
from types import SimpleNamespace

import pytest

from kit.plans.bell_plan import bell
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.desk.run.runtime_conversation import NumberedResponse, RuntimeConversation, in_short
from onika.link.lost import LinkLost, LossCause
from onika.link.state import LinkState
from onika.wire import event, live, request
from onika.wire.runtime_standing import Standing
from onika.words.reason import NOTHING, Reason


@pytest.mark.site
def test_whoever_stops_listening_hears_the_rest_next_time():  # R-F01
    with LaunchedRuntime(("rt0",), is_virtual=True) as runtime:
        runtime.ask(request.Prepare(bell(), ()))
        runtime.ask(request.Begin())
        messages = []
        while not (messages and isinstance(messages[-1], event.Result)):
            messages += islice(runtime.events(1.0), 1)
    kinds = [type(message) for message in messages]
    assert kinds.count(event.Began) == kinds.count(event.Done) == kinds.count(event.Result) == 1


@pytest.mark.site
def test_what_is_sent_is_not_waited_for_and_answered_under_its_number():
    with LaunchedRuntime(("rt0",), is_virtual=True) as runtime:
        numbers = [runtime.send(message) for message in (live.Survey(), live.Take("main"), live.Scene("moon"))]
        messages = []
        while sum(isinstance(message, NumberedResponse) for message in messages) < len(numbers):
            assert runtime.readers() and runtime.due_s() is not None and runtime.writers() == []
            messages += runtime.messages(1.0)
        replies = {message.number: message.response for message in messages if isinstance(message, NumberedResponse)}
    assert isinstance(replies[numbers[0]], Standing)
    assert replies[numbers[1]] == request.Done()
    assert str(replies[numbers[2]].reason) == "no world moon is open"


@pytest.mark.parametrize("lost", [LinkLost(LossCause.OVER, Reason.plain("the session has ended")), None])
def test_a_line_that_cannot_come_back_is_told_at_once_and_once(lost):  # R-A15, R-B07
    connection = SimpleNamespace(state=LinkState.APART, is_gone=False, lost=lost, poll=lambda _timeout_s: [])
    conversation = RuntimeConversation(connection)
    assert list(conversation.events(0.0)) == []
    connection.is_gone = True
    with pytest.raises(LinkLost, match="the runtime is gone"):
        list(conversation.events(0.0))
    assert list(conversation.events(0.0)) == []


def test_what_a_runtime_printed_last_is_left_out_in_short_and_all_else_is_kept():  # R-E10
    why, how = Reason.of("link.it_does_not_answer"), Reason.of("link.ended_with_code", code=4, during=NOTHING)
    kept, printed = Reason.of("link.black_box", path="last.mcap"), Reason.of("link.printed_last", output="ding")
    gone = Reason.of("link.runtime_gone", why=why, how=how, kept=kept, printed=printed)
    assert in_short(gone) == Reason.of("link.runtime_gone", why=why, how=how, kept=kept, printed=NOTHING)
    assert in_short(why) == why
