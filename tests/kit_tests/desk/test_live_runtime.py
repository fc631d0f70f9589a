import pytest

from kit.desk.live_runtime import LiveRuntime
from kit.plans.build import task
from onika.wire import event, live, request
from onika.wire.plan import Code
from onika.words.reason import NOTHING, Reason

CODE = Code("0" * 64, "a", "a.py", "")


def test_a_change_is_accepted_and_its_outcome_an_event():
    runtime = LiveRuntime()
    assert runtime.ask(live.Change("main", spawn=(task("a"),))) == live.Accepted(1)
    assert list(runtime.events(0.0)) == [
        event.TaskState("main", "a", "OFF", 0.0),
        event.Edited("main", 1, NOTHING, 0.0),
    ]


@pytest.mark.parametrize(
    "change",
    [
        live.Change("main", kill=("a",), on=(live.Turn("b"),)),
        live.Change("main", off=("b",), kill=("a",)),
        live.Change("main", kill=("a",), spawn=(task("c"), task("c"))),
    ],
)
def test_a_change_is_carried_out_whole_or_not_at_all(change):  # R-X10
    runtime = LiveRuntime()
    runtime.ask(live.Change("main", spawn=(task("a"),)))
    list(runtime.events(0.0))
    runtime.ask(change)
    (outcome,) = runtime.events(0.0)
    assert outcome.cause
    assert list(runtime.lives["main"]) == ["a"]


def test_a_task_lives_as_the_table_allows():  # R-A05
    runtime = LiveRuntime()
    runtime.ask(live.Change("main", spawn=(task("a"),), on=(live.Turn("a"),)))
    runtime.ask(live.Reinit("main", "a"))
    assert [message.cause for message in runtime.events(0.0) if isinstance(message, event.Edited)][1]


def test_everything_that_can_be_asked_is_answered():
    runtime = LiveRuntime()
    runtime.ask(live.Change("main", spawn=(task("a"),)))
    requests = (
        live.Survey(),
        live.Status(),
        live.Read("main"),
        live.Check("main"),
        live.Attend(),
        live.Take("main"),
        live.Release("main"),
        live.Reset(),
        live.Advance(1.0),
        live.Set("main", "a", "x", "1"),
        live.Get("main", "a", "x"),
        live.Clear("main", "a"),
        live.Swap("main", "a", CODE),
        live.Close("main"),
        request.Stop(Reason.plain("x")),
        request.Snapshot(),
    )
    for order in requests:
        assert isinstance(runtime.ask(order), request.Response), order
    assert runtime.now_s == 1.0


def test_a_run_is_over_when_its_end_is_listened_for():
    runtime = LiveRuntime()
    assert isinstance(runtime.ask(request.Begin()), request.Refused)
    runtime.tell(event.Held("main", "x"))
    assert len(list(runtime.events(0.0))) == 1
