"""The usual lines of a playbook in which every job has one task, its trigger `move`.

started([JOB, JOB]) >> ends(0) << Done(0, 0) << begins(0, 1)
"""

from collections.abc import Callable, Sequence

from kit.engine.play import Play
from kit.plans import build
from onika.engine.news import Finished, News, Run, Spawned, TurnedOn
from onika.engine.orders import Began, Done, Launch, Moved, Order, Switch

JOB = build.job("move", trigger="move")
NOOP = build.noop()


def opened(
    *flows: build.Jobs,
    judge: Callable[[int, str], bool] = lambda _flow, _condition: False,
    stands_still: bool = True,
) -> Play:
    """A run of which every task lives but the one of the last flow that has one."""
    spawns = build.spawns(*flows)
    play = Play(build.engine(*flows, judge=judge, stands_still=stands_still)) >> Run() << spawns
    return play >> [Spawned(spawn.flow, spawn.task) for spawn in spawns[:-1]]


def started(
    *flows: build.Jobs,
    judge: Callable[[int, str], bool] = lambda _flow, _condition: False,
    stands_still: bool = True,
    first: Sequence[Order] | None = None,
) -> Play:
    """A run that has begun; `first` are its orders, unless flow 0 alone begins its action 0."""
    last = build.spawns(*flows)[-1]
    play = opened(*flows, judge=judge, stands_still=stands_still)
    return play >> Spawned(last.flow, last.task) << (begins(0, 0) if first is None else first)


def begins(flow: int, index: int, off: Sequence[str] = (), number: int = 0) -> list[Order]:
    """An action follows another: one switch, and it is told."""
    return [Switch(flow, tuple(off), (Launch("move", "", 100.0),), number=number), Began(flow, index)]


def goes_on(flow: int, index: int) -> list[Order]:
    """An action begins in a flow that has waited, rested or stood still."""
    return [*begins(flow, index), Moved(flow, "running", index)]


def passes(flow: int, index: int) -> list[Order]:
    """A no-op."""
    return [Began(flow, index), Done(flow, index)]


def ends(flow: int, choice: int = 0, loop: bool = False, switched: int = 0) -> list[News]:
    """The trigger comes on and finishes."""
    return [TurnedOn(flow, "move"), Finished(flow, "move", choice, loop, switched)]
