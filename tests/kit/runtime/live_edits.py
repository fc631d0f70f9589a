"""Live changes of a runtime's subsystems in virtual time, while any processing unit may be lost."""

from collections import deque
from collections.abc import Callable

from kit.plans.plan_builder import PlanBuilder
from kit.runtime.direct_client import DirectClient, OpenGate
from kit.worlds.mass_world import MassWorld
from kit.worlds.rail_world import YardLoading
from onika.host.program import RuntimeProgram
from onika.host.units.virtual import VirtualDriver
from onika.runtime import command, news
from onika.runtime.execution.running_task import RunningTask
from onika.wire import event, live
from onika.wire.plan import Code, PlannedTask
from onika.wire.request import Response
from onika.wire.runtime_standing import Standing, TaskStanding
from onika.words.reason import Reason

SOURCE = """
from onika.module import Local, Module, OutConst, OutVar

class Source(Module):
    N = OutConst("int", "-", "how many")
    LEVEL = OutVar("double", "m", "a level")
    SIZE = Local("int", "-", "how many", default=2)

    def init(self):
        self.N = self.SIZE

    def cycle(self):
        self.LEVEL = self.LEVEL + 1.0
"""
USER = """
from onika.module import InConst, InVar, Module, ModuleError, OutVar

class User(Module):
    N = InConst("int", "-", "how many")
    LEVEL = InVar("double", "m", "a level")
    ROW = OutVar("double[N]", "m", "the level, N times")

    def init(self):
        if self.N > 4:
            raise ModuleError(f"{self.N} is too many")

    def cycle(self):
        self.ROW = [self.LEVEL] * self.N
"""
READER = """
from onika.module import InConst, InVar, Module, OutVar

class Reader(Module):
    N = InConst("int", "-", "how many")
    ROW = InVar("double[N]", "m", "the level, N times")
    SUM = OutVar("double", "m", "all of it")

    def cycle(self):
        self.SUM = float(sum(self.ROW))
"""
COUNTER = """
from onika.module import Module, OutVar

class Counter(Module):
    COUNT = OutVar("double", "-", "cycles since it came on")

    def cycle(self):
        self.COUNT = self.COUNT + 1.0
"""
BROKEN = """
from onika.module import Module, ModuleError, OutVar

class Broken(Module):
    LEVEL = OutVar("double", "m", "a level")

    def init(self):
        raise ModuleError("no sensor")
"""
SULKY = """
from onika.module import Module, ModuleError, OutVar

class Sulky(Module):
    LEVEL = OutVar("double", "m", "a level")

    def on(self, inputs):
        raise ModuleError("not today")
"""


class LossyDriver(VirtualDriver):
    """Can lose processing units: their tasks are gone, they hear and say nothing more.

    Lost at `fatal`, which is a number of news, counted from when it is set; the unit's last words arrive before.
    """

    def __init__(self, rtpus: tuple[str, ...], server: OpenGate) -> None:
        super().__init__(rtpus, server.tell, worlds=lambda _name: MassWorld())
        self.gone: set[str] = set()
        self.news: list[news.News] = []
        self.fatal: tuple[int, str] | None = None
        self._watched: RuntimeProgram | None = None
        self.commands: list[tuple[str, command.Command]] = []
        self.tight: set[str] = set()
        """Units that have no gap between their cycles, while something cycles, in which a task could be born."""
        self._refusals: list[tuple[str, news.News]] = []

    def watch(self, program: RuntimeProgram) -> None:
        """Stand between the units and this program."""
        self._watched = program
        self.listen(self)

    def send(self, rtpu: str, order: command.Command) -> None:
        """Give an RTPU a command, if it is there."""
        if rtpu in self.gone:
            return
        self.commands.append((rtpu, order))
        spawn = order.spawn if isinstance(order, command.Swap) else order
        if isinstance(spawn, command.Spawn) and self._has_no_gap(rtpu, spawn):
            no_gap = Reason.of("runtime.no_gap", needs_ms=3.0, largest_ms=1.0)
            entry = "spawn" if order is spawn else "swap"
            self._refusals.append((rtpu, news.Refused(spawn.subsystem, spawn.task, entry, no_gap)))
            return
        super().send(rtpu, order)

    def _has_no_gap(self, rtpu: str, spawn: command.Spawn) -> bool:
        if rtpu not in self.tight or not spawn.cost_ns:
            return False
        return any(task.is_on and self._units.homes[address] == rtpu for address, task in self.living().items())

    def advance(self, wall_ns: int) -> bool:
        """Run on; what tight units have refused is told in between."""
        goes_on = super().advance(wall_ns)
        while self._refusals:
            self.hear(*self._refusals.pop(0), self.now)
            goes_on = super().advance(wall_ns)
        return goes_on

    def living(self) -> dict[tuple[str, str], RunningTask]:
        """What really lives, by subsystem and task."""
        return self._executive.tasks

    def add_unit(self, name: str, answer: Callable[[Reason], None]) -> None:
        """A unit that was gone is there again, empty."""
        self.gone.discard(name)
        super().add_unit(name, answer)

    def lose(self, rtpu: str) -> None:
        """From now on this unit is gone."""
        self.gone.add(rtpu)
        units = self._units
        units._commands = deque(waiting for waiting in units._commands if waiting[0] != rtpu)
        for (subsystem, task), home in list(units.homes.items()):
            if home == rtpu:
                super().send(rtpu, command.Kill(subsystem, task))
        self.lost(rtpu, Reason.plain(f"processing unit {rtpu} was lost"), self.now)

    # As the listener

    @property
    def _program(self) -> RuntimeProgram:
        if self._watched is None:
            raise TypeError("expected a program that is watched, found none")
        return self._watched

    @property
    def is_moving(self) -> bool:
        """As the stage says."""
        return self._program.subsystems.is_moving

    @property
    def is_still(self) -> bool:
        """As the stage says."""
        return self._program.subsystems.is_still

    @property
    def is_hurried(self) -> bool:
        """As the stage says."""
        return self._program.subsystems.is_hurried

    def hear(self, rtpu: str, message: news.News, now: int) -> None:
        """Pass on what a unit that is there says."""
        if rtpu in self.gone:
            return
        self.news.append(message)
        self._program.subsystems.hear(rtpu, message, now)
        if self.fatal is not None:
            left, unit = self.fatal
            self.fatal = (left - 1, unit) if left > 1 else None
            if self.fatal is None:
                self.lose(unit)

    def lost(self, rtpu: str, reason: Reason, now: int) -> None:
        """Pass it on."""
        self._program.subsystems.lost(rtpu, reason, now)

    def run_began(self, device: str) -> int:
        """As the stage says."""
        return self._program.subsystems.run_began(device)

    def wake_at(self) -> int | None:
        """As the stage says."""
        return self._program.subsystems.wake_at()

    def tick(self, now: int) -> None:
        """As the stage does."""
        self._program.subsystems.tick(now)


class LossyClient(DirectClient):
    """A client of a runtime that can lose units."""

    def __init__(self, rtpus: tuple[str, ...] = ("rt0",)) -> None:
        super().__init__(rtpus)
        self.driver: LossyDriver = LossyDriver(rtpus, self.server)
        self.program = RuntimeProgram(self.server, self.driver, YardLoading(), rtpus)  # type: ignore[arg-type]
        self.driver.watch(self.program)


class LiveEdits:
    """Changes a subsystem by hand, with the tasks of its plan builder."""

    def __init__(self, rtpus: tuple[str, ...] = ("rt0",)) -> None:
        self.asker = LossyClient(rtpus)
        self.shop = PlanBuilder()

    @property
    def driver(self) -> LossyDriver:
        """The units."""
        return self.asker.driver

    def task(self, name: str, source: str, **settings: object) -> PlannedTask:
        """A task of the plan builder."""
        return self.shop.task(name, source, **settings)  # type: ignore[arg-type]

    def code(self, *names: str) -> tuple[Code, ...]:
        """The code behind tasks."""
        return tuple(self.shop.code(name) for name in names)

    def order(
        self, spawn: tuple[str, ...] = (), on: tuple[str | live.Turn, ...] = (), subsystem: str = "s0", **what: object
    ) -> live.Change:
        """A change of tasks by their names."""
        tasks = tuple(self.shop.planned(name) for name in spawn)
        turns = tuple(turn if isinstance(turn, live.Turn) else live.Turn(turn) for turn in on)
        return live.Change(subsystem, spawn=tasks, code=self.code(*spawn), on=turns, **what)  # type: ignore[arg-type]

    def change(
        self, spawn: tuple[str, ...] = (), on: tuple[str | live.Turn, ...] = (), session: str = "me", **what: object
    ) -> str:
        """Change tasks and wait for the outcome; why it came to nothing, or nothing."""
        return self.outcome(self.asker.ask(self.order(spawn, on, **what), session))  # type: ignore[arg-type]

    def reinit(self, task: str, subsystem: str = "s0", **local: str) -> str:
        """Initialise a task anew, with these LOCAL lines where there are any."""
        lines = tuple((key, tuple(words.split())) for key, words in local.items())
        return self.outcome(self.asker.ask(live.Reinit(subsystem, task, lines or None)))

    def swap(self, task: str, subsystem: str = "s0") -> str:
        """Exchange a task's code for what the plan builder has under its name."""
        return self.outcome(self.asker.ask(live.Swap(subsystem, task, self.shop.code(task))))

    def clear(self, task: str, subsystem: str = "s0") -> str:
        """Bring a task out of ERROR."""
        return self.outcome(self.asker.ask(live.Clear(subsystem, task)))

    def outcome(self, answer: Response) -> str:
        """What became of it."""
        return self.asker.outcome(answer)

    def edited(self, number: int) -> list[str]:
        """The outcomes of an accepted request: one, if all is well."""
        return [
            str(message.cause)
            for message in self.asker.server.events
            if isinstance(message, event.Edited) and message.number == number
        ]

    def work(self) -> None:
        """Let everything happen that is to happen at this instant."""
        self.asker.program.advance(1_000_000_000)

    def let_pass(self, seconds: float) -> None:
        """Let virtual time pass."""
        self.asker.ask(live.Advance(seconds))

    @property
    def states(self) -> dict[str, str]:
        """The tasks of subsystem `s0` and their states."""
        return self.asker.states()

    def standing(self, subsystem: str = "s0") -> dict[str, TaskStanding]:
        """The tasks of a subsystem as they stand."""
        answer = self.asker.ask(live.Survey())
        if not isinstance(answer, Standing):
            raise TypeError(str(answer))
        return {
            task.task.name: task
            for standing in answer.subsystems
            if standing.name == subsystem
            for task in standing.tasks
        }

    def values(self, *names: str, subsystem: str = "s0") -> dict[str, object]:
        """Variables as they stand."""
        return self.asker.values(*names, subsystem=subsystem)

    def figures(self) -> dict[str, live.TaskFigure]:
        """The figures of all tasks by name."""
        answer = self.asker.ask(live.Status())
        if not isinstance(answer, live.Figures):
            raise TypeError(str(answer))
        return {task.task: task for task in answer.tasks}

    def cycles(self, task: str) -> int:
        """How often a task cycled since the last time somebody asked."""
        return self.figures()[task].cycle


def live_edits_with_tasks(rtpus: tuple[str, ...] = ("rt0",), **places: str) -> LiveEdits:
    """Live edits of `source`, `user` and `reader`, which hang on its N, and a `counter` at 50 Hz; units by task."""
    hand = LiveEdits(rtpus)
    for name, source in (("source", SOURCE), ("user", USER), ("reader", READER)):
        hand.task(name, source, rtpu=places.get(name, "unknown"))
    hand.task("counter", COUNTER, frequency=50.0, rtpu=places.get("counter", "unknown"))
    return hand
