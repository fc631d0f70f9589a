import pytest

from onika.host.recording.boxed_subject import Incident, incident_of, is_fault, standing_of
from onika.wire import event
from onika.words.reason import NOTHING, Reason

CAUSE = Reason.plain("why")


def explained(kind, *choices):
    return event.Explained("s0", "", "", 0, "", CAUSE, "", 0, (), (), choices, 1.5, kind)


@pytest.mark.parametrize(
    ("message", "is_bad"),
    [
        (event.Failed("s0", "a", CAUSE, "", 0, "", 0.0), True),
        (event.Lost("rt0", CAUSE, 0.0), True),
        (event.Stopped(True, CAUSE), True),
        (event.Stopped(False, NOTHING), False),
        (explained("error"), True),
        (explained("asking"), False),
        (explained("user"), False),
        (event.Drive("w:d", "TRIPPED", 0, 0, 0, CAUSE), True),
        (event.Drive("w:d", "PRESSED", 0, 0, 0, CAUSE), True),
        (event.Drive("w:d", "HELD", 0, 0, 0, CAUSE), False),
        (event.Warned("s0", "a", CAUSE, 0.0), False),
    ],
)
def test_what_makes_an_end_a_bad_one(message, is_bad):  # R-X05
    assert is_fault(message) is is_bad


def test_a_standstill_at_which_somebody_is_to_choose_is_an_incident():  # R-X05, R-E08
    choice = ("retry", CAUSE)
    assert incident_of(explained("error", choice)) == Incident("s0", CAUSE, 1.5)
    assert incident_of(explained("error")) is None
    assert incident_of(explained("asking", choice)) is None
    assert incident_of(event.Failed("s0", "a", CAUSE, "", 0, "", 0.0)) is None


def test_what_holds_until_another_says_otherwise_is_known_by_what_it_is_about():  # R-X05
    messages = [
        event.TaskState("s0", "a", "ON", 0.0),
        event.Moved("s0", "acting", 0, 0.0),
        event.Began(1, 0, 2, "go", 0.0),
        event.Done(1, 0, 0.0),
        event.Drive("w:d", "HELD", 0, 0, 0, CAUSE),
        event.Failed("s0", "a", CAUSE, "", 0, "", 0.0),
        event.Lost("rt0", CAUSE, 0.0),
        event.Warned("s0", "a", CAUSE, 0.0),
    ]
    assert [standing_of(message) for message in messages] == [
        "task s0/a",
        "flow s0",
        "action 1",
        "action 1",
        "drive w:d",
        "failure s0/a",
        "loss rt0",
        "",
    ]
