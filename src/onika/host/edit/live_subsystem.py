"""A live subsystem: its tasks are held by hand, one edit after another, each carried out whole or not at all.

An edit is a transaction (`transactions`): a generator that sends commands and yields what it waits for. News moves the
present one on; the next one begins when it is through. Nothing here waits.
"""

from collections import deque
from collections.abc import Callable, Collection, Generator, Mapping
from typing import Any

from onika.engine import orders
from onika.host.edit.reshape import Reshaping
from onika.host.edit.task_events import told
from onika.host.edit.task_spawner import Cradle
from onika.host.run.switch_dispatch import Switchboard
from onika.host.units.unit_registry import Units
from onika.model.lifecycle import State
from onika.model.rules.reconfiguration import PlacedTask
from onika.runtime import command, news
from onika.runtime.subsystem import Member, Subsystem
from onika.runtime.table import Table
from onika.runtime.wiring import WiredTask
from onika.wire import event

Wait = Callable[[], bool]
Transaction = Generator[Wait, None, str]
"""Yields what it waits for; returns why it came to nothing, or nothing."""

Tell = Callable[[event.Event], None]


class LiveSubsystem:
    """The tasks that share one table while no application runs in it."""

    def __init__(
        self,
        name: str,
        table: Table,
        units: Units,
        tell: Tell,
        clock: Callable[[], int],
        lost: Mapping[str, str] | None = None,
        end: Callable[[], None] = lambda: None,
    ) -> None:
        self.name = name
        self.table = table
        self.holder = ""
        self.known: dict[str, dict[str, int]] = {}
        """By task: the constants a robot module states before it lives."""
        self.wanted: dict[str, str] = {}
        """The tasks that are wanted ON, each with its last argument line."""
        self.reasons: dict[str, str] = {}
        """Why a task waits, asks or has failed."""
        self.asks: dict[str, event.Asked] = {}
        """What tasks wait to be told."""
        self.trouble: dict[str, str] = {}
        """What went wrong with a task since the present transaction began."""
        self.done: set[str] = set()
        """Who was initialised anew, bound anew or exchanged since the last command for it."""
        self.came: set[str] = set()
        """Who has come ON, or asked, since it was told to; a job may be done again before another has begun."""
        self.went: set[str] = set()
        """Who has been neither ON nor ASKING for a moment since it was told to go OFF."""
        self.stale: set[str] = set()
        """Who was in ERROR when constants that it reads have changed: it is initialised when it is cleared."""
        self.rates: dict[str, float] = {}
        self.subsystem = Subsystem(name, table, (), {})
        self.reshaping = Reshaping(table)
        self.is_closing = False
        """Whether the subsystem is to be no more as soon as nothing is left of it."""
        self._lost = lost if lost is not None else {}
        self._end = end
        self.cradle = Cradle(units, self.reshaping, self._lost)
        self._units = units
        self._tell = tell
        self._clock = clock
        self._switchboard = Switchboard({0: self.subsystem}, units)
        self._transactions: deque[tuple[int, Transaction]] = deque()
        self._waits: Wait | None = None

    # What there is

    @property
    def members(self) -> dict[str, Member]:
        """Every task that lives or waits to be born."""
        return self.subsystem.members

    @property
    def wired(self) -> list[WiredTask]:
        """The tasks with their ports."""
        return [member.wired for member in self.members.values()]

    @property
    def is_busy(self) -> bool:
        """Whether a transaction is under way."""
        return self._waits is not None

    @property
    def is_empty(self) -> bool:
        """Whether there is nothing here and nothing to come."""
        return not (self.members or self._transactions)

    def placed(self) -> list[PlacedTask]:
        """The tasks as the rule of reconfiguration sees them."""
        return [one.placed for one in self.wired]

    def state(self, task: str) -> State:
        """A task's state; KILLED where there is none."""
        member = self.members.get(task)
        return member.state if member is not None else State.KILLED

    def lacking(self, task: str) -> list[str]:
        """The constants a task waits for, because nobody supplies them or their supplier waits itself (law 10)."""
        wired = self.members[task].wired
        suppliers = {svar: one for one in self.members.values() for svar in one.wired.outconst}
        lacking = []
        for svar in wired.placed.ports.inconst:
            supplier = suppliers.get(svar)
            if supplier is None:
                lacking += [svar] if svar not in wired.first_values else []
            elif supplier.state is State.WAITING and supplier.wired.name != task:
                lacking.append(svar)
        return lacking

    # Transactions

    def begin(self, number: int, transaction: Transaction) -> None:
        """Carry this out, after those before it."""
        self._transactions.append((number, transaction))
        self._go_on()

    def _go_on(self) -> None:
        """Move the present transaction as far as it goes."""
        while self._transactions and (self._waits is None or self._waits()):
            number, transaction = self._transactions[0]
            if self._waits is None:
                self.trouble.clear()
            try:
                self._waits = next(transaction)
            except StopIteration as end:
                self._waits = None
                self._transactions.popleft()
                self.reshaping.end()
                self._bury()
                self._tell(event.Edited(self.name, number, end.value or "", self.seconds()))
        if self.is_closing and self.is_empty:
            self._end()

    def _bury(self) -> None:
        """Between two transactions: forget whom a lost unit took along, and code that nobody runs."""
        gone = [name for name, member in self.members.items() if member.is_sent and member.state is State.KILLED]
        if gone:
            self.remove(gone)
        if not self._transactions:
            self.cradle.forget(self.wired)

    def seconds(self, now: int | None = None) -> float:
        """The runtime's time in seconds."""
        return round((self._clock() if now is None else now) * 1e-9, 9)

    # What transactions do

    def send(self, task: str, order: command.Command) -> None:
        """Give a task's unit a command."""
        self._units.send(self.members[task].rtpu, order)

    def rewire(self, members: Collection[tuple[WiredTask, str]]) -> None:
        """From now on these are the tasks, each on its unit; who stays keeps its state, and learns its new rank."""
        before = self.subsystem
        tasks = [wired for wired, _ in members]
        known = {svar: value for wired in tasks for svar, value in self.known.get(wired.name, {}).items()}
        self.subsystem = Subsystem(self.name, self.table, tasks, {wired.name: rtpu for wired, rtpu in members}, known)
        for name, member in before.members.items():
            if name in self.members:
                self.members[name].state, self.members[name].is_sent = member.state, member.is_sent
        self._switchboard = Switchboard({0: self.subsystem}, self._units)
        self._rank(before.ranks)

    def _rank(self, before: Mapping[str, int]) -> None:
        changed: dict[str, list[tuple[str, int]]] = {}
        for name, rank in self.subsystem.ranks.items():
            if self.members[name].is_sent and before.get(name) != rank and self.members[name].rtpu not in self._lost:
                changed.setdefault(self.members[name].rtpu, []).append((name, rank))
        for rtpu, ranks in changed.items():
            self._units.send(rtpu, command.Rank(self.name, tuple(ranks)))

    def add(self, new: Collection[tuple[WiredTask, str]]) -> None:
        """These are to be born."""
        self.rewire([*((one.wired, one.rtpu) for one in self.members.values()), *new])

    def remove(self, tasks: Collection[str]) -> None:
        """These are gone: devices and memory are given back."""
        for name in tasks:
            self.cradle.release(name, self.members[name])
            self.stale.discard(name)
            for memory in (self.wanted, self.reasons, self.rates, self.known):
                memory.pop(name, None)
        self.rewire([(one.wired, one.rtpu) for name, one in self.members.items() if name not in tasks])
        used = {name for one in self.wired for port in one.ports for name in (port.svar, *port.shape.names)}
        for svar in [svar for svar in self.table.entries if svar not in used]:
            self.table.free(self.table.drop(svar))

    def spawn_ready(self) -> None:
        """Send every task to its unit whose constants are there; the others wait (law 10)."""
        for name, member in self.members.items():
            if not member.is_sent and name not in self.trouble:
                lacking = self.lacking(name)
                self.reasons[name] = f"waits for {', '.join(lacking)}" if lacking else ""
                if not lacking:
                    self._spawn(name, member)

    def _spawn(self, name: str, member: Member) -> None:
        wrong = self.cradle.bear(self.subsystem, name)
        member.is_sent = not wrong
        if wrong:
            self.trouble[name] = self.reasons[name] = wrong

    def warn(self, task: str, text: str) -> None:
        """Something worth knowing that changes nothing."""
        self._tell(event.Warned(self.name, task, text, self.seconds()))

    def switch(
        self, off: Collection[str], on: Collection[command.Launch], rates: tuple[tuple[str, float], ...]
    ) -> None:
        """Turn tasks off and on with no cycle in between; nothing happens to the others."""
        names = [launch.task for launch in on]
        off = tuple(name for name in off if self.state(name) is not State.WAITING)
        forget = self.subsystem.forgotten(off, names)
        self.subsystem.forget(forget)
        starts = tuple(orders.Start(one.task, one.arguments, one.frequency) for one in on)
        self._switchboard.put(orders.Switch(0, off, starts, rates), forget)

    # News

    def hear(self, rtpu: str, heard: news.News, now: int) -> None:
        """Take in one piece of news of a task."""
        del rtpu
        if isinstance(heard, news.Statuses | news.Loads | news.Unprepared) or heard.task not in self.members:
            return
        if self.members[heard.task].rtpu in self._lost:
            return  # the last words of a unit that is gone: its tasks are dead already
        self._hear(heard, heard.task, self.seconds(getattr(heard, "now_ns", now)))
        self._go_on()

    def _hear(self, heard: Any, task: str, at: float) -> None:
        words = told(heard, at)
        if not isinstance(heard, news.Asked):
            self._tell_all(words)
        match heard:
            case news.Initialised():
                self._turn(task, State.OFF, at)
                self.spawn_ready()
            case news.Reinitialised() | news.Rebound() | news.Swapped():
                self.done.add(task)
            case news.Changed():
                if heard.signal:
                    self.wanted.pop(task, None)
                self._turn(task, State(heard.state), at)
            case news.Finished():
                self.wanted.pop(task, None)
                self._turn(task, State.OFF, at)
            case news.Failed():
                self.reasons[task] = self.trouble[task] = f"{heard.entry}: {heard.text}"
                self._turn(task, State.ERROR, at)
            case news.Asked():
                self.reasons[task] = f"asks for {', '.join(item.name for item in heard.items)}"
                self._turn(task, State.ASKING, at)
                self.asks.update((task, one) for one in words if isinstance(one, event.Asked))
                self._tell_all(words)
            case news.Refused():
                self._refused(heard, task, at)

    def _tell_all(self, words: tuple[event.Event, ...]) -> None:
        for word in words:
            self._tell(word)

    def _refused(self, heard: news.Refused, task: str, at: float) -> None:
        self.trouble[task] = f"{heard.command}: {heard.reason}"
        if heard.command == "spawn":  # it may be tried again
            self.cradle.release(task, self.members[task])
            self.members[task].is_sent, self.reasons[task] = False, self.trouble[task]
        self._switchboard.settled(0, task)
        if not self.is_busy:
            self._tell(event.Warned(self.name, task, f"refused, {self.trouble[task]}", at))

    def _turn(self, task: str, state: State, at: float) -> None:
        self.members[task].state = state
        self.asks.pop(task, None)
        if state in (State.ON, State.OFF, State.KILLED):
            self.reasons[task] = ""
        (self.came if state in (State.ON, State.ASKING) else self.went).add(task)
        self._tell(event.TaskState(self.name, task, state.value, at))
        if state in (State.ON, State.ASKING, State.ERROR):
            self._switchboard.settled(0, task)

    def lost(self, rtpu: str, reason: str, now: int) -> None:
        """A unit is gone with its tasks."""
        gone = [name for name, member in self.members.items() if member.rtpu == rtpu and member.is_sent]
        for name in gone:
            self.trouble[name] = reason
            self._turn(name, State.KILLED, self.seconds(now))
            self._switchboard.settled(0, name)
        self._go_on()
        if not self.is_busy:
            self._bury()
