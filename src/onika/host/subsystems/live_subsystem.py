"""A live subsystem: its tasks are held by hand, one edit after another, each carried out whole or not at all.

An edit is a transaction (`host.edit.transactions`): a generator that sends commands and yields what it waits for. News
moves the present one on; the next one begins when it is through. Nothing here waits.
"""

from collections import deque
from collections.abc import Callable, Collection, Generator, Mapping

from onika.host.execution import task_events
from onika.host.execution.reshape import Reshaping
from onika.host.execution.spawner import Spawner
from onika.host.execution.subsystem_executor import SubsystemExecutor, state_after
from onika.host.subsystems.desired_state import DesiredState
from onika.host.subsystems.outcomes import Outcomes
from onika.host.units.unit_registry import Units
from onika.model.lifecycle import State
from onika.model.rules.reconfiguration import PlacedTask
from onika.runtime import command, news
from onika.runtime.subsystem import Member, RunningSubsystem
from onika.runtime.table import Table
from onika.runtime.wiring import WiredTask
from onika.wire import event
from onika.words.reason import NOTHING, Reason

Wait = Callable[[], bool]
Transaction = Generator[Wait, None, Reason]
"""Yields what it waits for; returns why it came to nothing, or nothing."""

Tell = Callable[[event.Event], None]


class LiveSubsystem:
    """The tasks that share one table while no application runs in it.

    `desired` is what users want of them, `outcomes` what has become of the last commands for them.
    """

    def __init__(
        self,
        name: str,
        table: Table,
        units: Units,
        tell: Tell,
        clock: Callable[[], int],
        lost: Mapping[str, Reason] | None = None,
        end: Callable[[], None] = lambda: None,
    ) -> None:
        self.name = name
        self.table = table
        self.holder = ""
        self.recording = ""
        """The file into which it is being recorded; empty: it is not."""
        self.desired = DesiredState()
        self.outcomes = Outcomes()
        self.reshaping = Reshaping(table)
        units_lost = lost if lost is not None else {}
        self.executor = SubsystemExecutor(
            RunningSubsystem(name, table, (), {}),
            units,
            Spawner(units, units_lost, reshaping=self.reshaping),
            self._follow,
            tell,
            task_events.by_hand,
            units_lost,
        )
        self._reasons: dict[str, Reason] = {}
        self._is_closing = False
        self._end = end
        self._tell = tell
        self._clock = clock
        self._transactions: deque[tuple[int, Transaction]] = deque()
        self._waits: Wait | None = None
        self._now = 0

    # What there is

    @property
    def members(self) -> dict[str, Member]:
        """Every task that lives or waits to be spawned."""
        return self.executor.members

    @property
    def wired(self) -> list[WiredTask]:
        """The tasks with their ports."""
        return [member.wired for member in self.members.values()]

    @property
    def placements(self) -> list[tuple[WiredTask, str]]:
        """The tasks, each with its unit."""
        return [(member.wired, member.rtpu) for member in self.members.values()]

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
        return [wired.placed for wired in self.wired]

    def state(self, task: str) -> State:
        """A task's state; KILLED where there is none."""
        return self.executor.state(task)

    def is_on(self, task: str) -> bool:
        """Whether it is ON, or would be if somebody answered it."""
        return self.state(task) in (State.ON, State.ASKING)

    def drives(self, unit: str, is_settled: bool) -> bool:
        """Whether what lives on a unit may have a part in driving a device; what may come ON counts if not settled."""
        lives = [member for task, member in self.members.items() if self.is_on(task) or not is_settled]
        return any(member.rtpu == unit for member in lives) and any(member.wired.sheet.hardware for member in lives)

    def is_being_spawned(self, task: str) -> bool:
        """Whether its unit has not said yet what became of it."""
        is_initialising = self.members[task].is_sent and self.state(task) is State.WAITING
        return is_initialising and not self.outcomes.has_trouble(task)

    def reason(self, task: str) -> Reason:
        """Why a task waits, asks or has failed."""
        reason = self._reasons.get(task, NOTHING)
        if reason or self.members[task].is_sent:
            return reason
        lacking = self.executor.subsystem.lacking(task)
        return Reason.of("host.waits_for_constants", names=tuple(lacking)) if lacking else NOTHING

    # Transactions

    def begin(self, number: int, transaction: Transaction) -> None:
        """Carry this out, after those before it."""
        self._transactions.append((number, transaction))
        self._go_on()

    def close(self) -> None:
        """The subsystem is to be no more as soon as nothing is left of it."""
        self._is_closing = True

    def _go_on(self) -> None:
        """Move the present transaction as far as it goes."""
        while self._transactions and (self._waits is None or self._waits()):
            number, transaction = self._transactions[0]
            if self._waits is None:
                self._start_anew()
            try:
                self._waits = next(transaction)
            except StopIteration as end:
                self._waits = None
                self._transactions.popleft()
                self.reshaping.end()
                self._clear_away()
                self._tell(event.Edited(self.name, number, end.value or NOTHING, self.executor.seconds(self._clock())))
        if self._is_closing and self.is_empty:
            self._end()

    def _start_anew(self) -> None:
        """No trouble of before counts, and whoever could not be spawned may be."""
        self.outcomes.begin()
        for task, member in self.members.items():
            if not member.is_sent:
                self.executor.expect(task)

    def _clear_away(self) -> None:
        """Between two transactions: forget whom a lost unit took along, and code that nobody runs."""
        dead = [task for task, member in self.members.items() if member.is_sent and member.state is State.KILLED]
        if dead:
            self.remove(dead)
        if not self._transactions:
            self.executor.spawner.drop_unused_code(self.wired)

    # What transactions do

    def add(self, tasks: Collection[tuple[WiredTask, str]]) -> None:
        """These are to be spawned, each on its unit."""
        self.rewire([*self.placements, *tasks])
        for wired, _ in tasks:
            self.executor.expect(wired.name)

    def remove(self, tasks: Collection[str]) -> None:
        """These are gone: devices and memory are given back."""
        for task in tasks:
            self.executor.spawner.release(task, self.members[task])
            self.desired.forget(task)
            self._reasons.pop(task, None)
        self.rewire([(wired, rtpu) for wired, rtpu in self.placements if wired.name not in tasks])
        used = {name for wired in self.wired for port in wired.ports for name in (port.svar, *port.shape.names)}
        for svar in [svar for svar in self.table.entries if svar not in used]:
            self.table.free(self.table.drop(svar))

    def rewire(self, tasks: Collection[tuple[WiredTask, str]]) -> None:
        """From now on these are the tasks, each on its unit."""
        constants = self.desired.constants([wired.name for wired, _ in tasks])
        self.executor.rewire(tasks, constants)

    def answer(self, task: str, line: str) -> None:
        """The user's answer to an asking task is what it is to be ON with."""
        self.desired.turn_on(task, line)
        self.executor.send(task, command.Answer(self.name, task, line))

    def warn(self, task: str, text: Reason) -> None:
        """Something worth knowing that changes nothing."""
        self.executor.warn(task, text, self._clock())

    # News

    def hear(self, rtpu: str, message: news.News, now: int) -> None:
        """Take in one piece of news of a task."""
        del rtpu
        self._now = now
        if isinstance(message, news.TaskNews):
            self.executor.hear(message, now)
            self._go_on()

    def lost(self, rtpu: str, reason: Reason, now: int) -> None:
        """A unit is gone with its tasks."""
        for task, member in self.members.items():
            if member.rtpu == rtpu and member.is_sent:
                self.outcomes.fail(task, reason)
        self.executor.lost(rtpu, now)
        self._go_on()
        if not self.is_busy:
            self._clear_away()

    def _follow(self, message: news.TaskNews, before: State) -> None:
        """As the executor's client: remember what transactions wait for."""
        del before
        task = message.task
        match message:
            case news.Reinitialised() | news.Rebound() | news.Swapped():
                self.outcomes.answer(task)
            case news.Failed():
                self._reasons[task] = Reason.of("host.entry_failed", entry=message.entry, why=message.text)
                self.outcomes.fail(task, self._reasons[task])
            case news.Asked():
                self._reasons[task] = Reason.of("host.asks_for", names=tuple(item.name for item in message.items))
                self.executor.ask_user(message)
            case news.Refused():
                self._refused(message)
            case news.Finished():
                self.desired.turn_off(task)
            case news.Changed() if message.signal:
                self.desired.turn_off(task)
        state = state_after(message)
        if state is not None:
            self._turned(task, state)

    def _turned(self, task: str, state: State) -> None:
        if state in (State.ON, State.OFF, State.KILLED):
            self._reasons[task] = NOTHING
        self.outcomes.turn(task, state)

    def _refused(self, message: news.Refused) -> None:
        reason = Reason.of("host.entry_failed", entry=message.command, why=message.reason)
        self.outcomes.fail(message.task, reason)
        if message.command == "spawn":  # it may be tried again
            self._reasons[message.task] = reason
        if not self.is_busy:
            self.executor.warn(message.task, Reason.of("host.refused", reason=reason), self._now)
