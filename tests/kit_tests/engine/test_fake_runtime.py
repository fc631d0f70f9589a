import pytest

from kit.engine.fake_runtime import Activation, FakeRuntime, Fault
from kit.plans import build
from onika.engine.news import Run
from onika.engine.orders import Began, Done, End, Kill, Launch, Moved, RunNote, Settle, Spawn, Switch

REACH = build.job("move", "puma", trigger="move", arguments="1 2")
MOVE = frozenset({(0, "move")})


class Scripted:
    """An engine that answers every news with the next of its lines."""

    def __init__(self, *lines):
        self._lines = list(lines)

    def feed(self, news):
        return self._lines.pop(0) if self._lines else []


def kinds(runtime):
    return [type(order) for order in runtime.orders]


def test_a_fake_runtime_runs_a_plan_to_its_end():
    runtime = FakeRuntime(build.engine([REACH]), MOVE)
    runtime.run()
    assert kinds(runtime) == [Spawn, Spawn, Switch, Began, Done, Moved, Settle, Kill, Kill, End]
    assert runtime.on_during == {(0, 0): {"move": 100.0, "puma": 100.0}}
    assert runtime.activations == {(0, 0): (Activation(0, "move", "1 2"), Activation(0, "puma", ""))}


def test_a_fake_runtime_can_abort():
    runtime = FakeRuntime(build.engine([REACH]), MOVE)
    runtime.run(abort_after=1)
    assert kinds(runtime) == [Spawn, Spawn, Kill, Kill, End]


@pytest.mark.parametrize(
    ("fault", "expected"),
    [
        (Fault.ASK, [RunNote, Done, Moved, Settle, Kill, Kill, End]),
        (Fault.FINISH_TWICE, [Done, Moved, RunNote, Settle, Kill, Kill, End]),
        (Fault.SWITCH_OFF, [RunNote]),
        (Fault.FAIL, [Kill, Kill, End]),
        (Fault.REFUSE, [Kill, Kill, End]),
    ],
)
def test_a_trigger_can_misbehave(fault, expected):
    runtime = FakeRuntime(build.engine([REACH]), MOVE, faults=lambda a: fault if a[1] == "move" else None)
    runtime.run()
    assert sorted(map(str, kinds(runtime)[4:])) == sorted(map(str, expected))


def test_the_order_of_news_can_be_chosen():
    first, last = [], []
    for choose, message in ((lambda n: 0, first), (lambda n: n - 1, last)):
        engine = build.engine([REACH])
        runtime = FakeRuntime(Listener(engine, message), MOVE, choose)
        runtime.run()
    assert sorted(map(str, first)) == sorted(map(str, last))
    assert first != last


class Listener:
    def __init__(self, engine, messages):
        self._engine = engine
        self._heard = messages

    def feed(self, news):
        self._heard.append(news)
        return self._engine.feed(news)


ON = Switch(0, (), (Launch("move"),))


@pytest.mark.parametrize(
    ("lines", "complaint"),
    [
        ([[ON]], "does not live"),
        ([[Spawn(0, "move"), ON, ON]], "is ON"),
        ([[Kill(0, "move")]], "does not live"),
        ([[Spawn(0, "move"), Kill(0, "move"), Kill(0, "move")]], "does not live"),
        ([[End(True), End(True)]], "after the end"),
        ([[Spawn(0, "move"), End(True)]], "live"),
    ],
)
def test_orders_that_no_engine_may_give_are_complained_of(lines, complaint):
    with pytest.raises(AssertionError, match=complaint):
        FakeRuntime(Scripted(*lines), MOVE).run()


def test_what_a_fake_is_told_first_is_to_run():
    messages = []
    FakeRuntime(Listener(Scripted(), messages), MOVE).run()
    assert messages == [Run()]
