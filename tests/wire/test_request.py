import msgspec
import pytest

from kit.plan_builder import action
from kit.rail_world import rail_tasks
from onika.wire import holding, live, request, steer
from onika.words.reason import Reason

PLAN = rail_tasks().plan([action("mass", "servo", arguments="1")])
REQUESTS = [
    request.Prepare(PLAN, (request.TargetValues(0, 0, "joint object", (1.0, 2, "three")),)),
    request.Inspect(PLAN.flows[0].tasks, PLAN.code),
    request.Begin(("LAMP",), 0.25, 7, (("gauge", "level", '1 "two words"'),), True),
    request.Reply("flow0", "gauge", "1 2"),
    request.Abort("enough"),
    request.Stop("enough"),
    request.Snapshot(),
    request.Quit(),
]
RESPONSES = [
    request.Prepared(
        (request.FaultText("a.rmod", 3, Reason.plain("expected one, found two"), Reason.plain("left out")),),
        ("by the way",),
    ),
    request.Done(),
    request.Refused("not now"),
    request.Worlds({"boxes": b"\x00\xff"}),
]


@pytest.mark.parametrize("message", REQUESTS, ids=lambda message: type(message).__name__)
def test_a_request_travels_whole(message):  # R-F01
    assert request.decode_request(request.encode(message)) == message


@pytest.mark.parametrize("message", RESPONSES, ids=lambda message: type(message).__name__)
def test_a_response_travels_whole(message):  # R-F01, R-F07
    assert request.decode_response(request.encode(message)) == message


def test_every_request_and_every_response_is_tried():
    by_hand = (
        {*live.LiveRequest.__args__, *steer.SteerRequest.__args__, *holding.HoldingRequest.__args__},
        {*live.LiveResponse.__args__, steer.Positions, holding.Company},
    )
    # tried in files of their own
    assert {type(message) for message in REQUESTS} == set(request.Request.__args__) - by_hand[0]
    assert {type(message) for message in RESPONSES} == set(request.Response.__args__) - by_hand[1]


@pytest.mark.parametrize("body", [b"", b"\xc0", b"\x81\xa4type\xa4Jump", b"\x80", request.encode(request.Done())])
def test_what_is_no_request_is_a_value_error(body):
    with pytest.raises(ValueError):
        request.decode_request(body)


def test_a_request_cut_anywhere_is_a_value_error():
    whole = request.encode(REQUESTS[0])
    for end in range(len(whole)):
        with pytest.raises(msgspec.DecodeError):
            request.decode_request(whole[:end])


def test_a_run_begins_as_usual_unless_said_otherwise():
    assert request.Begin() == request.Begin((), 0.5, 0, (), False)
