"""What is asked about who may change a subsystem travels as it is."""

import pytest

from onika.wire import event, holding, request

SESSION = holding.SessionStanding("ann#2", "operator", is_here=False, only_watches=True)


@pytest.mark.parametrize(
    "message",
    [holding.Hand("s0", "ann#2"), holding.Hand("s0"), holding.Decline("s0"), holding.OnlyWatch(), holding.Sessions()],
)
def test_a_request_about_holding_travels_whole(message):  # R-X12
    assert request.decode_request(request.encode(message)) == message


def test_who_is_there_travels_whole():  # R-X12
    answer = holding.Company("ann#2", (SESSION,))
    assert request.decode_response(request.encode(answer)) == answer
    for message in (
        event.Company((SESSION,)),
        event.Offered("s0", "ann#2", "bob#3", "accepted"),
        event.Held("s0", "", "why"),
    ):
        assert event.decode(event.encode(message)) == message
