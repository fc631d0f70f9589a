"""A rig: several tasks of one subsystem on one executive, beside at most one world; the test moves time.

    rig = ExecutiveRig(MassWorld())
    rig.spawn("push", SOURCE, frequency=100.0, device="m0").switch(on=["push"]).run(1_000_000_000)
    assert rig["X"] == …

Where a cycle's cost is declared, time passes by it; otherwise cycles take no time. With `steady`, what is due at one
instant is carried out together, as in virtual time, after so many instants by sweeps.
"""

import weakref
from collections import deque
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Self, TypeVar

from onika.ring.begin_words import BeginWords
from onika.ring.segment import Segment
from onika.runtime import command, news
from onika.runtime.bus import SEGMENT_SIZE, Bus, World
from onika.runtime.execution.executive import Executive
from onika.runtime.execution.rounds import STEADY
from onika.runtime.execution.running_task import RunningTask
from onika.runtime.modules.code import load
from onika.runtime.modules.module import Module
from onika.runtime.table import Table
from onika.words.fault import Fault

HOME = "rig"
_TABLE_BYTES = 1 << 20
_Kind = TypeVar("_Kind")


class ExecutiveRig:
    """`news` holds whatever was said with the time of its cause; `costs` are nanoseconds per cycle by task."""

    def __init__(
        self,
        world: World | None = None,
        *,
        costs: Mapping[str, int] | None = None,
        react: Callable[[news.News], list[command.Command]] = lambda _news: [],
        seed: int = 0,
        steady: int | None = None,
    ) -> None:
        if steady is not None and costs:
            raise ValueError("expected cycles without costs where they are carried out together")
        self.now = 0
        self.news: list[tuple[int, news.News]] = []
        segment = Segment.create("rig", _TABLE_BYTES)
        weakref.finalize(self, segment.close)
        self.table = Table(segment)
        self.views = {f"table:{HOME}": segment.view}
        self._costs, self._react, self._seed = costs or {}, react, seed
        self._watched = _Watched()
        self.begin_words = BeginWords()
        self._most = 1 if steady is None else 1000
        self.executive = Executive("unit", self.views, self._watched.watch, self.begin_words, steady or STEADY)
        self.bus = None if world is None else self._open(world)
        self._grants: dict[str, command.DeviceGrant] = {}
        self._stepped_to = 0
        self._requests: deque[tuple[int, command.Command]] = deque()

    def __getitem__(self, name: str) -> Any:
        return self.table.value(name)

    def spawn(self, task: str, source: str, **given: Any) -> Self:
        """Bring a task of this source to life; the words are those of `spawn_of`."""
        return self.do(self.spawn_of(task, source, **given))

    def spawn_of(
        self,
        task: str,
        source: str,
        *,
        frequency: float | None = 100.0,
        kind: str = "periodic",
        rank: int = 0,
        local: Iterable[tuple[str, tuple[str, ...]]] = (),
        aliases: Mapping[str, str] | None = None,
        constants: Mapping[str, int] | None = None,
        device: str = "",
        cost_ns: int = 0,
        init_ns: int = 0,
    ) -> command.Spawn:
        """The command for a task of this source; shapes are resolved by `constants`, ports bound by `aliases`."""
        path = f"{task}.py"
        cls = load(source, path, task)
        ports = () if isinstance(cls, Fault) else self._lay(cls, aliases or {}, constants or {})
        grant = self._grant(device) if device and self.bus is not None else None
        return command.Spawn(
            HOME, task, task, path, source, kind, frequency, tuple(local), ports, rank, self._seed, grant,
            cost_ns, init_ns,
        )  # fmt: skip

    def do(self, order: command.Command) -> Self:
        """Carry out a command now."""
        self._hear(self.executive.handle(order, self.now), self.now)
        return self

    def switch(
        self,
        *,
        on: Iterable[str | command.Launch] = (),
        off: Sequence[str] = (),
        forget: Sequence[str] = (),
        rates: Sequence[tuple[str, float]] = (),
    ) -> Self:
        """Switch tasks off and on."""
        launches = tuple(launch if isinstance(launch, command.Launch) else command.Launch(launch) for launch in on)
        return self.do(command.Switch(HOME, tuple(off), tuple(forget), launches, tuple(rates)))

    def run(self, until: int, requests: Iterable[tuple[int, command.Command]] = ()) -> Self:
        """Let time pass up to `until`; `requests` are carried out at their times, in order, between two cycles."""
        self._requests.extend(requests)
        while True:
            self._instant(until)
            later = [at for at, _ in self._requests]
            release = self.executive.next_release()
            later += [] if release is None else [release]
            if not later or max(self.now, min(later)) > until:
                return self
            self.now = max(self.now, min(later))

    # What came of it

    def task(self, name: str) -> RunningTask:
        """A live task; raises KeyError where there is none."""
        return self.executive.tasks[HOME, name]

    def news_of(self, kind: type[_Kind]) -> list[_Kind]:
        """The news of one kind, in English."""
        in_english = (news.in_english(entry) for _, entry in self.news)
        return [entry for entry in in_english if isinstance(entry, kind)]

    def last(self, kind: type[_Kind]) -> _Kind:
        """The last news of one kind."""
        return self.news_of(kind)[-1]

    # Inner

    def _instant(self, until: int) -> None:
        while self.now <= until:  # of a unit that never comes to rest, `until` is the end
            if self.bus is not None and self._stepped_to < self.now:
                self.bus.step(self.now)
                self._stepped_to = self.now
            while self._requests and self._requests[0][0] <= self.now:
                self.do(self._requests.popleft()[1])
            began = self.now
            self._watched.task = ""
            entries = self.executive.run_due(began, self._most)
            if entries is None:
                return
            self.now += self._costs.get(self._watched.task, 0)
            self._hear(entries, began)

    def _hear(self, entries: Sequence[news.News], at: int) -> None:
        self.news += [(at, entry) for entry in entries]
        reactions = [order for entry in entries for order in self._react(entry)]
        self._requests.extendleft((self.now, reaction) for reaction in reversed(reactions))

    def _open(self, world: World) -> Bus:
        segment = Segment.create("rig-bus", SEGMENT_SIZE)
        weakref.finalize(self, segment.close)
        self.views["bus:world"] = segment.view
        bus = Bus("world", world, segment)
        bus.step(0)
        return bus

    def _grant(self, device: str) -> command.DeviceGrant:
        """The device of a world; once granted, the same grant serves the module that takes the place of another."""
        if device not in self._grants and self.bus is not None:
            self._grants[device] = self.bus.grant(device, 1)
        return self._grants[device]

    def _lay(
        self, cls: type[Module], aliases: Mapping[str, str], constants: Mapping[str, int]
    ) -> tuple[command.BoundPort, ...]:
        ports = []
        for port in (declared.port(attribute) for attribute, declared in cls.declared_ports.items()):
            svar = aliases.get(port.name, port.name)
            entry = self.table.entry(svar, port.shape.resolve(constants))
            ports.append(command.BoundPort(port.name, svar, str(entry.shape), entry.offset))
        return tuple(ports)


def rig_of(source: str, **given: Any) -> ExecutiveRig:
    """A rig whose one task, called `one`, is of this source."""
    return ExecutiveRig().spawn("one", source, **given)


class _Watched:
    """Whose code ran last; apart from the rig, so that a rig ends, and gives its memory back, with its last use."""

    def __init__(self) -> None:
        self.task = ""

    def watch(self, task: str) -> None:
        self.task = task.partition("/")[2] or self.task
