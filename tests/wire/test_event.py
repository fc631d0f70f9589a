import msgspec
import pytest

from onika.wire import event, holding
from onika.wire.figures import TaskFigures, VariableSteps

ITEM = event.Item("level", "double", 2, "m", "how high", (0.5, 0.5), (0.0, 0.0), None)
STEPS = VariableSteps("flow0", "puma", "TAU_REF", "N m", 19, 1, 40.0, 9.0, 9.76, 1.5, 2, 6, 0)
FIGURES = TaskFigures("flow0", "pd", "rt0", 500.0, 1000, 2, 4.5, 20.0)
EVENTS = [
    event.Began(0, 1, 3, "jmoveC home", 1.5),
    event.Done(0, 1, 2.5),
    event.TaskState("flow0", "pd", "ON", 0.0),
    event.Warned("flow0", "", "by the way", 0.1),
    event.Failed("flow0", "pd", "cycle: no", "pd.py", 7, "trace", 0.2, "cycle", {"Q_MEZ": [0.0]}),
    event.Edited("s0", 4, "no such task", 0.2),
    event.Signalled("s0", "pd", "USER", 3, "three", 0.2),
    event.Lost("rt0", "was killed by signal 9", 0.2),
    event.Held("s0", "me"),
    event.Offered("s0", "me", "you", "declined"),
    event.Company((holding.SessionStanding("me", "owner", False, True),)),
    event.Stopped(True, "enough"),
    event.Asked("flow0", "gauge", "", (ITEM,), 0.3),
    event.Drive("boxes:arm_left", "HELD", 4, 2, -1, "stop"),
    event.Moved("flow0", "WAITING", 3, 1.5, "tag1", ("flow1",), "waits"),
    event.Met("tag1", ("flow0", "flow1"), 250.0, 1.5),
    event.Stepped("flow0", "puma", "TAU_REF", "N m", 1, 40.0, 9.0, 9.76, 6, 1.5),
    event.Stood(1.5),
    event.Explained(
        "flow0",
        "pd",
        "grip arm",
        3,
        "assemble.appl:7",
        "cycle: no",
        "pd.py",
        7,
        (("flow1", "tag1"),),
        (event.Course("Q_MEZ", "rad", (0.1, 0.2), ([0.0], 1.0)),),
        (("recover", "again"),),
        1.5,
        "error",
        "pd",
    ),
    event.Result(
        True, "", 1, 1, 2.0, 0.1, {"LAMP": 1, "Q": [0.5], "NAME": "x"}, (FIGURES,), "abc", (3.5,), steps=(STEPS,)
    ),
]


@pytest.mark.parametrize("message", EVENTS, ids=lambda message: type(message).__name__)
def test_an_event_travels_whole(message):  # R-F01, R-E11
    assert event.decode(event.encode(message)) == message


def test_every_event_is_tried():
    assert {type(message) for message in EVENTS} == set(event.Event.__args__)


def test_what_is_no_event_is_a_value_error():
    for body in (b"", b"\x80", b"\x81\xa4type\xa4Jump"):
        with pytest.raises(msgspec.DecodeError):
            event.decode(body)
