"""The usual lines of a playbook in which tasks fail: `move` is the trigger, `puma` is what it moves.

started() >> Failed(0, "puma", "joint limit") << Off(0, "move") << stopped()
"""

from collections.abc import Iterable, Sequence

from kit.engine.play import Play
from kit.plans import build
from onika.engine.news import Finished, News, Run, Spawned, TurnedOn
from onika.engine.orders import Began, Launch, Moved, Order, Switch, Together
from onika.words.reason import Reason

REACH = build.job("move", "puma", trigger="move", arguments="1 2")
AGAIN = build.job("move", "puma", trigger="move", arguments="3 4")
MEET = build.job("move", "puma", trigger="move", arguments="5 6", synch_tag="meet")


def where(flow: int, index: int) -> str:
    """An action, as messages name it."""
    return f"test.appl flow {flow} action {index}"


def on(*tasks: str, arguments: str = "1 2") -> tuple[Launch, ...]:
    """The starts of tasks; `move` is told its target."""
    return tuple(Launch(task, arguments if task == "move" else "", 100.0) for task in tasks)


def started(
    *flows: Sequence[build.Job], passive: Iterable[tuple[int, str]] = (), others: Iterable[tuple[int, str]] = ()
) -> Play:
    """All flows in their first action, whose tasks are all ON; a flow in error waits for its user."""
    flows = flows or ([REACH, AGAIN],)
    engine = build.engine(*flows, stands_still=True, passive=passive, other_triggers=others)
    play = Play(engine) >> Run() << build.spawns(*flows)
    play = play >> [Spawned(spawn.flow, spawn.task) for spawn in build.spawns(*flows)]
    play = play << Together("", tuple(range(len(flows)))) if len(flows) > 1 else play
    for flow, jobs in enumerate(flows):
        play = play << Switch(flow, (), on(*jobs[0].tasks)) << Began(flow, 0)
    return play >> [TurnedOn(flow, task) for flow, jobs in enumerate(flows) for task in jobs[0].tasks]


def stopped(index: int = 0, task: str = "puma", text: str = "joint limit", flow: int = 0) -> Moved:
    """A task has failed."""
    place = Reason.of("engine.name_at", place=where(flow, index), name=task)
    return Moved(flow, "stopped", index, text=Reason.of("engine.in_error", where=place, why=text))


def clearing(index: int = 0, flow: int = 0) -> Moved:
    """The user wants the error cleared."""
    return Moved(flow, "clearing", index)


def running(index: int, flow: int = 0) -> list[Order]:
    """An action begins in a flow that has stood still."""
    return [Began(flow, index), Moved(flow, "running", index)]


def finish(flow: int = 0) -> list[News]:
    """The trigger comes on and finishes."""
    return [TurnedOn(flow, "move"), Finished(flow, "move")]


def paused(index: int = 0, flow: int = 0) -> Moved:
    """A flow rests."""
    return Moved(flow, "paused", index)
