"""What is asked of subsystems by hand travels as it is."""

import pytest

from kit.plan_builder import action
from kit.rail_world import rail_tasks
from onika.wire import live, request
from onika.wire.sheet import InputSheet, LocalSheet, ModuleSheet, PortSheet

PLAN = rail_tasks().plan([action("mass", "servo", arguments="1")])
TASK, CODE = PLAN.flows[0].tasks[0], PLAN.code[0]
REQUESTS = [
    live.Change("s0", ("a",), (TASK,), (CODE,), ("b",), (live.Turn("c", "1 2"),), (("b", 50.0),)),
    live.Clear("s0", "arm"),
    live.Reinit("s0", "arm", (("NDOF", ("5",)),)),
    live.Swap("s0", "arm", CODE),
    live.Get("s0", "arm", "gain"),
    live.Set("s0", "arm", "gain", "2"),
    live.Status(),
    live.Survey(),
    live.Read("s0", ("Q_MEZ",)),
    live.Describe((CODE,)),
    live.Check("s0"),
    live.Close("s0"),
    live.Take("s0"),
    live.Release("s0"),
    live.Attend(("*",), ("s0/Q_MEZ",), ("boxes",), 20.0),
    live.Scene("boxes"),
    live.Touch("boxes", "panic_left", 1.0),
    live.Reset(),
    live.Advance(1.5),
]
RESPONSES = [
    live.Accepted(3),
    live.Value([1.0, "two"]),
    live.Values({"Q_MEZ": [0.0, 1.0]}, 2.5),
    live.Standing(
        (live.SubsystemStanding("s0", "me", "", (live.TaskStanding(TASK, "ON", True, "rt0", 50.0, "why"),)),),
        (live.RtpuStanding("rt0", False, 0.5),),
        ("boxes",),
        True,
        False,
        1.5,
    ),
    live.Figures(
        (
            live.TaskFigure(
                *("s0", "arm", "puma", "rt0", 3, "P", 0, "ON"),
                *(10, 0, 50.0, 49.9, 0.2, 1.0, 1e-6, 0.1, 0.2, 0.15, 1.0, 2.0, 1.5, 0),
            ),
        ),
        {"rt0": 0.3},
        ("too much",),
    ),
    live.Findings(("Q_MEZ is torn",)),
    live.Described(
        {
            CODE.digest: ModuleSheet(
                (PortSheet("INVAR", "X", "double[6]", "rad", "where it is"),),
                (InputSheet("x", "double", "m", "where to go", 0.0, "XMAX", None),),
                (LocalSheet("GAIN", "double", "-", "how strong", 1.0),),
                *(True, False, True, 2, "moves"),
            )
        },
        {"0": "no module"},
    ),
    live.Scenery({"shapes": [{"name": "box"}]}),
]


@pytest.mark.parametrize("message", REQUESTS, ids=lambda message: type(message).__name__)
def test_a_request_by_hand_travels_whole(message):  # R-A19
    assert request.decode_request(request.encode(message)) == message


@pytest.mark.parametrize("message", RESPONSES, ids=lambda message: type(message).__name__)
def test_a_response_by_hand_travels_whole(message):  # R-A19
    assert request.decode_response(request.encode(message)) == message


def test_everything_that_is_asked_by_hand_is_tried():
    assert {type(message) for message in REQUESTS} == set(live.LiveRequest.__args__)
    assert {type(message) for message in RESPONSES} == set(live.LiveResponse.__args__)
