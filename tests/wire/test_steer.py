from typing import get_args

import pytest

from onika.wire import request, steer

ASKED = (
    steer.Pause("flow0"),
    steer.Resume(),
    steer.Step("flow0.1"),
    steer.Skip("flow0"),
    steer.Skip("flow0", 3),
    steer.Pass("flow0"),
    steer.Leave("flow0"),
    steer.Mark("flow0", 2, True, "LAMP == 1"),
    steer.Recover(),
    steer.Onward(),
    steer.Onward(1.5),
    steer.Who(),
)
POSITION = steer.Position("flow0", "waiting", 2, "t a", ("flow1",), True, ("outer",), ("pd",), (1, 4))


@pytest.mark.parametrize("message", ASKED, ids=lambda message: type(message).__name__)
def test_every_request_travels(message):  # R-E07, R-E08, R-E13
    assert request.decode_request(request.encode(message)) == message


def test_no_request_is_left_out():
    assert {type(message) for message in ASKED} == set(get_args(steer.SteerRequest))


def test_positions_travel_back():  # R-X03
    positions = steer.Positions((POSITION,))
    assert request.decode_response(request.encode(positions)) == positions
