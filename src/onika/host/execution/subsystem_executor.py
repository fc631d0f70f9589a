"""A subsystem executor spawns, switches and kills the tasks of one subsystem, and follows what becomes of them.

It decides nothing; its client does: the engine for an application (`host.run.runner`), a transaction for a change by
hand (`host.subsystems.live_subsystem`). Of every piece of news the state is noted first, then sessions are told, then
the client hears it. A task that is ON or asks lets the rest of its switch go on at once; one that failed or was refused
does so when the client has decided what follows, for it may give the rest up (laws 3, 6, 10). Nothing here waits.
"""

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from itertools import count
from typing import cast

from onika.engine import orders
from onika.host.execution.spawner import Spawner
from onika.host.execution.switch_dispatch import Group, SwitchDispatch
from onika.host.execution.task_events import TaskEvent, question_of
from onika.host.units.unit_registry import Units
from onika.model.lifecycle import State
from onika.model.rules.starvation import writer_failed
from onika.runtime import command, news
from onika.runtime.subsystem import Member, RunningSubsystem
from onika.runtime.wiring import WiredTask
from onika.wire import event
from onika.words.reason import Reason

Client = Callable[[news.TaskNews, State], None]
"""Decides what follows a piece of news; the state is that of the task before it."""

Tell = Callable[[event.Event], None]

_ENDS_A_LAUNCH = ("on", "spawn", "clear")
"""A task that refuses one of these does not come on."""


class SubsystemExecutor:
    """Serves one client. `task_event` says what sessions are told of news, `lost` which units are gone and why."""

    def __init__(
        self,
        subsystem: RunningSubsystem,
        units: Units,
        spawner: Spawner,
        client: Client,
        tell: Tell,
        task_event: TaskEvent,
        lost: Mapping[str, Reason],
        activations: Iterator[int] | None = None,
    ) -> None:
        self.subsystem = subsystem
        self.spawner = spawner
        self._units = units
        self._client = client
        self._tell = tell
        self._task_event = task_event
        self._lost = lost
        self._dispatch = SwitchDispatch(subsystem, units, activations if activations is not None else count(1))
        self._expected: list[str] = []
        self.open_questions: dict[str, event.Asked | None] = {}
        """Every task that waits for user input, with its question where it is known already."""
        self.failed_at_work: set[str] = set()
        """The tasks in ERROR that were ON when they failed, and on which others depend (law 4)."""
        self._began = 0

    # What there is

    @property
    def name(self) -> str:
        """The subsystem's name."""
        return self.subsystem.name

    @property
    def members(self) -> dict[str, Member]:
        """Every task that lives or waits to be spawned."""
        return self.subsystem.members

    @property
    def questions(self) -> tuple[event.Asked, ...]:
        """What tasks have asked users and were not answered yet."""
        return tuple(question for question in self.open_questions.values() if question is not None)

    def state(self, task: str) -> State:
        """A task's state; KILLED where there is none."""
        member = self.members.get(task)
        return member.state if member is not None else State.KILLED

    def is_alive(self, task: str) -> bool:
        """Whether a unit has the task, or is about to."""
        member = self.members.get(task)
        return member is not None and member.is_sent and member.state is not State.KILLED

    def is_late(self, message: news.TaskNews) -> bool:
        """Whether news is about an activation before the task's last one (decision 4)."""
        return self._dispatch.is_late(message)

    def source(self, digest: str) -> str:
        """The code behind a task."""
        return self.spawner.code(digest).source

    # Time

    def begin(self, now: int) -> None:
        """From now on events count their seconds from this time."""
        self._began = now

    def seconds(self, now: int) -> float:
        """A time of the runtime in the seconds that events have."""
        return round((now - self._began) * 1e-9, 9)

    # Spawning

    def expect(self, task: str) -> None:
        """Spawn this task as soon as its constants are there (law 10)."""
        if task not in self._expected:
            self._expected.append(task)

    def spawn_ready(self) -> None:
        """Spawn, in order, every expected task whose constants are there."""
        for task in list(self._expected):
            if task in self._expected and not self.subsystem.lacking(task):
                self._expected.remove(task)
                self._spawn(task)

    def _spawn(self, task: str) -> None:
        reason = self.spawner.spawn(self.subsystem, task)
        if reason:
            self._refuse(task, "spawn", reason)
        else:
            self.members[task].is_sent = True

    def rewire(self, members: Collection[tuple[WiredTask, str]], constants: Mapping[str, int]) -> None:
        """From now on these are the tasks, each on its unit; who stays keeps its state, and learns its new rank."""
        before = self.subsystem
        tasks = [wired for wired, _ in members]
        homes = {wired.name: rtpu for wired, rtpu in members}
        self.subsystem = RunningSubsystem(self.name, before.table, tasks, homes, constants)
        for task, member in before.members.items():
            if task in self.members:
                self.members[task].state, self.members[task].is_sent = member.state, member.is_sent
        self._expected = [task for task in self._expected if task in self.members]
        self._dispatch.replace(self.subsystem)
        self._send_ranks(before.ranks)

    def _send_ranks(self, before: Mapping[str, int]) -> None:
        changed: dict[str, list[tuple[str, int]]] = {}
        for task, rank in self.subsystem.ranks.items():
            member = self.members[task]
            if member.is_sent and before.get(task) != rank and member.rtpu not in self._lost:
                changed.setdefault(member.rtpu, []).append((task, rank))
        for rtpu, ranks in changed.items():
            self._units.send(rtpu, command.Rank(self.name, tuple(ranks)))

    # Switching

    def admits(self, switch: orders.Switch) -> bool:
        """Whether no variable gets a second writer; else the client hears who is refused and why (law 9)."""
        clashes = self.subsystem.clashes(switch.off, [start.task for start in switch.on])
        if clashes:
            task, reason = clashes[0]
            self._refuse(task, "on", reason)
        return not clashes

    def switch(self, switch: orders.Switch) -> None:
        """Turn tasks off and on with no cycle in between, as soon as the switch before it is through."""
        self._dispatch.put(switch, self._forget(switch))

    def launch_alone(self, switch: orders.Switch) -> Group | None:
        """As `switch`, but a switch that is one command for one unit is left to the caller to send."""
        return self._dispatch.launch_alone(switch, self._forget(switch))

    def appoint(self, switch: orders.Switch) -> Group | None:
        """The switch for a unit to carry out by itself at an agreed time; None where that is not one command for one.

        Nothing is written down before `adopt`.
        """
        off, on = switch.off, [start.task for start in switch.on]
        if self.subsystem.clashes(off, on):
            return None
        return self._dispatch.appoint(switch, self.subsystem.forgotten(off, on))

    def turn_off(self, task: str) -> None:
        """Turn a task off outside a switch."""
        self._dispatch.turn_off(task)

    def drop_switches(self) -> None:
        """Nothing more comes on."""
        self._dispatch.drop()

    def _forget(self, switch: orders.Switch) -> tuple[str, ...]:
        forgotten = self.subsystem.forgotten(switch.off, [start.task for start in switch.on])
        self.subsystem.forget(forgotten)
        return forgotten

    # Prepared switches

    def prepare(self, task: str, cases: Sequence[orders.Case]) -> Mapping[int, command.Switch] | None:
        """Have the switches ready that follow a task's finish, by number; None where one would be refused by then."""
        ready = []
        for case in cases:
            off, on = case.switch.off, [start.task for start in case.switch.on]
            if self.subsystem.clashes((task, *off), on):
                return None
            ready.append((case, self.subsystem.forgotten(off, on, finished=task)))
        return self._dispatch.prepare(task, ready)

    def unprepare(self, task: str) -> None:
        """Have the unit forget what was prepared for a task; it says when that is so."""
        self._dispatch.unprepare(task)

    def adopt(self, switch: command.Switch) -> None:
        """A unit has carried out a prepared switch by itself."""
        self._dispatch.adopt(switch)

    # Commands

    def send(self, task: str, order: command.Command) -> None:
        """Give a task's unit a command."""
        self._units.send(self.members[task].rtpu, order)

    def kill(self, task: str) -> bool:
        """Have a task's unit end it; False where it was never spawned, or is gone already."""
        if task in self._expected:
            self._expected.remove(task)
        if not self.is_alive(task):
            return False
        self.send(task, command.Kill(self.name, task))
        return True

    # News

    def hear(self, message: news.TaskNews, now: int) -> None:
        """Take in one piece of news of a task."""
        member = self.members.get(message.task)
        if member is None or member.rtpu in self._lost:
            return  # the last words of a unit that is gone: its tasks are dead already
        kind, before = type(message), member.state
        if kind is news.Cycled:
            self._client(message, before)  # it changes no state, and no session is told
            return
        at_s = self.seconds(happened_at(message, now))
        self._tell_of(message, at_s)
        state = state_after(message)
        if state is not None:
            self._turn(message.task, state, at_s)
        if kind is news.Failed and before is State.ON and cast("news.Failed", message).entry != "off":
            self._has_failed_at_work(message.task)
        if state in (State.ON, State.ASKING):
            self._dispatch.settled(message.task)
        if kind is news.Refused and cast("news.Refused", message).command == "spawn":
            self.spawner.release(message.task, member)
            member.is_sent = False
        self._client(message, before)
        if state in (State.ERROR, State.KILLED) or _ends_a_launch(message):
            self._dispatch.settled(message.task)
        if kind is news.Initialised:
            self.spawn_ready()

    def lost(self, rtpu: str, now: int) -> None:
        """A unit is gone, and its tasks with it."""
        for task in [task for task, member in self.members.items() if member.rtpu == rtpu]:
            if self.is_alive(task):
                self.end(task, now)
                self._dispatch.settled(task)

    def end(self, task: str, now: int) -> None:
        """A task is gone without a word of its unit."""
        before = self.state(task)
        self._turn(task, State.KILLED, self.seconds(now))
        if before is State.ON:
            self._starve(task)
        self._client(news.Changed(self.name, task, State.KILLED.value, now), before)

    def _has_failed_at_work(self, task: str) -> None:
        if not self.members[task].wired.sheet.passive:
            self.failed_at_work.add(task)
        self._starve(task)

    def _starve(self, failed: str) -> None:
        """No device on another unit is driven on with what this task wrote; its own unit has seen to that (law 4)."""
        if self.members[failed].wired.sheet.passive:
            return
        for task, variable in self.subsystem.starved(failed).items():
            if self.members[task].rtpu not in self._lost:
                cause = writer_failed(failed, variable, self.state(failed))
                self.send(task, command.Starve(self.name, task, cause))

    def _refuse(self, task: str, entry: str, reason: Reason) -> None:
        self._client(news.Refused(self.name, task, entry, reason), self.state(task))

    def _turn(self, task: str, state: State, at_s: float) -> None:
        member = self.members[task]
        member.state = state
        if state is not State.ERROR:
            self.failed_at_work.discard(task)
        if state is State.ASKING:
            self.open_questions[task] = None
        else:
            self.open_questions.pop(task, None)
        if state is State.KILLED:
            self.spawner.release(task, member)
        self._tell(event.TaskState(self.name, task, state.value, at_s))

    # Events

    def ask_user(self, message: news.Asked) -> None:
        """Tell sessions what a task asks; whoever comes later can see it, too."""
        question = self.open_questions[message.task] = question_of(message, self.seconds(message.now_ns))
        self._tell(question)

    def warn(self, task: str, text: Reason, now: int) -> None:
        """Tell sessions something worth knowing that changes nothing."""
        self._tell(event.Warned(self.name, task, text, self.seconds(now)))

    def _tell_of(self, message: news.TaskNews, at_s: float) -> None:
        task_event = self._task_event(message, at_s)
        if task_event is not None:
            self._tell(task_event)


def happened_at(message: news.TaskNews, now: int) -> int:
    """When it happened, where the unit says so, else when it was heard."""
    if type(message) is news.Cycled or type(message) is news.Stepped:
        return message.at_ns
    return getattr(message, "now_ns", now)


def _ends_a_launch(message: news.TaskNews) -> bool:
    return type(message) is news.Refused and message.command in _ENDS_A_LAUNCH


def state_after(message: news.TaskNews) -> State | None:
    """The state in which a task is after this news; None: the same as before."""
    if type(message) is news.Changed:
        return _STATES[message.state]
    return _AFTER.get(type(message))


_STATES = {state.value: state for state in State}
_AFTER: dict[type, State] = {
    news.Initialised: State.OFF, news.Finished: State.OFF, news.Failed: State.ERROR, news.Asked: State.ASKING,
}  # fmt: skip
