import pytest

from kit.labs.laboratory import job
from onika.wire import event, live, request, steer
from onika.words.reason import Reason

STOP = event.Explained(
    "flow0",
    "b",
    "bC",
    1,
    "",
    Reason.plain("b failed"),
    "",
    0,
    (),
    (),
    (("retry", Reason.plain("again")),),
    1.5,
    "error",
)


def marks(cinema, *, messages=(), requests=()):
    doc = cinema.open([job("aC"), job("bC")])
    tape = cinema.tape(doc)
    for at_s, message in messages:
        tape.tell(at_s, message)
    for at_s, wish in requests:
        tape.ask(at_s, wish)
    tape.end()
    return [(mark.at_s, mark.kind, str(mark.text)) for mark in cinema.look(tape.path).marks]


def test_errors_standstills_meetings_and_ends_are_marked(cinema):  # R-X05
    messages = [
        (2.0, event.Met("0 meet", ("flow0", "flow1"), 12.0, 2.0)),
        (1.0, event.Failed("flow0", "b", Reason.plain("ValueError: no"), "b.py", 1, "", 1.0)),
        (1.5, STOP),
        (2.5, event.Stopped(True, Reason.plain("ann pressed stop"))),
        (3.0, event.Result(False, Reason.plain("aborted by the user"), 0, 2, 3.0, 0.0, {}, (), "")),
        (0.5, event.Warned("flow0", "b", Reason.plain("hot"), 0.5)),
    ]
    assert marks(cinema, messages=messages) == [
        (1.0, "error", "b: ValueError: no"),
        (1.5, "stop", "flow0: b failed"),
        (2.0, "meet", "flow0 and flow1 met at meet"),
        (2.5, "stop", "everything was stopped: ann pressed stop"),
        (3.0, "stop", "the run ended: aborted by the user"),
    ]


@pytest.mark.parametrize(
    ("wish", "kind", "text"),
    [
        (steer.Pause(), "command", "pause"),
        (steer.Resume("flow0"), "command", "go on: flow0"),
        (steer.Skip("flow0", 1), "command", "skip to a job: flow0"),
        (steer.Skip("flow0"), "command", "skip to the next action: flow0"),
        (steer.Mark("flow0", 1), "command", "set a breakpoint after a job"),
        (request.Stop(Reason.plain("ann")), "stop", "stop: ann"),
        (request.Abort(Reason.plain("enough")), "command", "end the run: enough"),
        (request.Reply("flow0", "b", "1 2"), "command", "answer to b: 1 2"),
        (live.Touch("yard", "button", 1.0), "command", "button is pressed"),
        (live.Set("flow0", "b", "GAIN", "3"), "command", "set GAIN of b to 3"),
        (live.Write("main", "Q", (0.5, -1.0)), "command", "wrote 0.5 -1 to Q"),
        (live.Clear("flow0", "b"), "command", "bring out of its error: b"),
        (live.Reset(), "command", "allow motion again"),
    ],
)
def test_what_was_asked_is_marked(cinema, wish, kind, text):  # R-X05
    assert marks(cinema, requests=[(0.5, wish)]) == [(0.5, kind, text)]
