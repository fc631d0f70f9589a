"""The law of the cycle as a small interpreter (laws 1 to 6 and 13): slow and plain, the measure of the executive.

A subsystem on one processing unit, with at most one world. Variables stand in a dict, time is an integer of
nanoseconds, what is due is looked for anew each time. Nothing here is shared with the executive but the words of its
commands and the table of lifecycles; `trace` and `told` of both must be the same.
"""

import math
import struct
from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from functools import partial
from typing import Any

from onika.model.lifecycle import State, Step, after
from onika.model.signal import Signal, SignalKind
from onika.runtime.bus import World
from onika.runtime.command import Clear, Kill, Launch, Switch
from onika.runtime.law_task import Hand, LawTask, Moment, Traced, Values

Request = Switch | Clear | Kill
_EPOCH = 1


class _LawBroken(Exception):
    """Law 5: no `error` entry may mend this."""


@dataclass(slots=True)
class _Life:
    """What changes about a task."""

    period: int
    moment: Moment
    state: State = State.WAITING
    is_initialised: bool = False
    release: int | None = None
    missed: int = 0
    marks: dict[str, int] = field(default_factory=dict)

    @property
    def deadline(self) -> int:
        """Law 2: the next release, on a grid of whole periods since the start (law 13)."""
        return ((self.release or 0) // self.period + 1) * self.period


class Reference:
    """Interprets tasks by the law; `world` steps in its own grid, `react` is what a runner answers to a signal."""

    def __init__(
        self,
        tasks: Iterable[LawTask],
        world: World | None = None,
        react: Callable[[str, Signal], list[Request]] = lambda _task, _signal: [],
    ) -> None:
        self.now = 0
        self.table: Values = {}
        self.trace: list[Traced] = []
        self.told: list[tuple[int, str, str]] = []
        self._tasks = {task.name: task for task in tasks}
        self._writes: dict[str, int] = {}
        self._forgotten: dict[str, int] = {}
        self._world = world
        self._stepped_to = 0
        self._published: dict[str, tuple[float, ...]] = {}
        self._react = react
        self._requests: deque[tuple[int, Request]] = deque()
        self._lives = {task.name: self._born(task) for task in self._tasks.values()}
        if world is not None:
            self._step_world(world)
        for task in self._tasks.values():
            if self._try(task, "init", partial(self._init, task)):
                self._lives[task.name].state = after(State.WAITING, Step.INITIALISED)

    @property
    def missed(self) -> dict[str, int]:
        """How many periods each task was late by."""
        return {name: life.missed for name, life in self._lives.items()}

    @property
    def states(self) -> dict[str, State]:
        """Where each task is in its life."""
        return {name: life.state for name, life in self._lives.items()}

    def run(self, until: int, requests: Iterable[tuple[int, Request]] = ()) -> None:
        """Let time pass up to `until`; `requests` come at their times, in order."""
        self._requests.extend(requests)
        while True:
            self._instant(until)
            later = [at for at, _ in self._requests]
            later += [life.release for life in self._lives.values() if life.release is not None]
            if not later or max(self.now, min(later)) > until:
                return
            self.now = max(self.now, min(later))

    def _instant(self, until: int) -> None:
        """Law 1: worlds step to t, hardware state is published, due tasks run. Law 2: requests between two cycles.

        Costs let time pass here; of a unit that never comes to rest, `until` is the end.
        """
        while self.now <= until:
            if self._world is not None and self._stepped_to < self.now:
                self._step_world(self._world)
            while self._requests and self._requests[0][0] <= self.now:
                self._obey(self._requests.popleft()[1])
            task = self._first_due()
            if task is None:
                return
            self._cycle(task)

    def _first_due(self) -> LawTask | None:
        """Law 1: by deadline, criticality, rank, name. Law 2: missed periods are counted and skipped first."""
        due = [one for one in self._lives.items() if one[1].release is not None and one[1].release <= self.now]
        for _, life in due:
            if life.deadline <= self.now:
                life.missed += (self.now - (life.release or 0)) // life.period
                life.release = self.now // life.period * life.period
        tasks = [self._tasks[name] for name, _ in due]
        return min(tasks, key=lambda t: (self._lives[t.name].deadline, -t.crit, t.rank, t.name), default=None)

    def _step_world(self, world: World) -> None:
        """Commands written before act from now on; then the world moves and its state is published."""
        for task in self._tasks.values():
            hand = self._lives[task.name].moment.device
            if hand is not None and hand.order is not None:
                world.command(task.device, _EPOCH, *hand.order)
                hand.order = None
        world.step(self.now)
        self._stepped_to = self.now
        for sheet in world.devices():
            self._published[sheet.name] = tuple(map(float, world.state(sheet.name)))

    # One cycle

    def _cycle(self, task: LawTask) -> None:
        """Law 2: copy in, cycle, copy out, times, then the signals; its next release is its deadline."""
        life, began = self._lives[task.name], self.now
        signals: list[Signal] = []
        self._try(task, "cycle", lambda: signals.extend(self._work(task)))
        heard = [signal for signal in signals if self._signal(task, signal)]
        if life.release is not None:
            life.release = life.deadline if task.is_periodic else None
        self.now = began + task.cost
        for signal in heard:
            self._requests.extendleft((self.now, one) for one in reversed(self._react(task.name, signal)))

    def _work(self, task: LawTask) -> list[Signal]:
        """Copy in, cycle, copy out; the signal that the cycle returned, if any."""
        life = self._lives[task.name]
        hand, inputs = life.moment.device, life.moment.inputs
        is_stale = any(self._writes.get(svar, 0) == mark for svar, mark in life.marks.items())
        self._copy_in(task, task.invar)
        if task.hardware and hand is not None:
            hand.is_holding = is_stale
        if task.hardware and is_stale:  # law 4
            self._call(task, "hold")
            signal = None
        elif task.hardware and not all(math.isfinite(inputs[svar]) for svar in task.invar):  # law 5
            raise _LawBroken("NaN or infinity")
        else:
            signal = self._call(task, "cycle")
        self._copy_out(task, task.outvar)
        if signal is not None and signal.kind is SignalKind.FINISH and not task.trigger:
            raise TypeError("only a trigger finishes a job")
        return [] if signal is None else [signal]

    def _signal(self, task: LawTask, signal: Signal) -> bool:
        """FINISH and OFF turn the task off; whether the signal is told to others."""
        leaves = {SignalKind.FINISH: Step.FINISH, SignalKind.OFF: Step.OFF}
        if signal.kind in leaves and not self._leave(task, leaves[signal.kind]):
            return False
        self._tell(task, f"signal {signal.kind.value}")
        return True

    # Requests

    def _obey(self, request: Request) -> None:
        if isinstance(request, Switch):
            self._switch(request)
            return
        task, life = self._tasks[request.task], self._lives[request.task]
        if isinstance(request, Kill):
            self._kill(task, life)
        elif life.state is not State.ERROR:
            self._tell(task, "refused clear")
        elif self._try(task, "clear", lambda: self._clear(task, life)):
            life.state = after(life.state, Step.CLEAR)
            self._tell(task, "OFF")

    def _switch(self, switch: Switch) -> None:
        """Law 3: off, then what is forgotten, then rates, then on; no cycle comes in between."""
        for name in switch.off:
            if self._lives[name].state is State.ON and self._leave(self._tasks[name], Step.OFF):
                self._tell(self._tasks[name], "OFF")
        for svar in switch.forget:
            self._forgotten[svar] = self._writes.get(svar, 0)
        for name, frequency in switch.rates:
            self._rate(self._tasks[name], frequency)
        for launch in switch.on:
            self._on(self._tasks[launch.task], launch)

    def _rate(self, task: LawTask, frequency: float) -> None:
        """Law 13: what is due stays due, the rest comes on the grid of the new period."""
        life = self._lives[task.name]
        if life.state is State.KILLED:
            self._tell(task, "refused rate")
            return
        life.period = life.moment.period = round(1e9 / frequency)
        if life.release is not None and life.release > self.now:
            life.release = (self.now // life.period + 1) * life.period

    def _on(self, task: LawTask, launch: Launch) -> None:
        """Law 3: all inputs in, own outputs preloaded, `on`, what it changed out. Law 13: the first cycle at once."""
        life = self._lives[task.name]
        if life.state is not State.OFF:
            self._tell(task, "refused on")
            return
        if launch.frequency is not None:
            self._rate(task, launch.frequency)
        if self._try(task, "on", lambda: self._begin(task)):
            life.state, life.release = after(life.state, Step.ON), self.now
            self._tell(task, "ON")

    def _begin(self, task: LawTask) -> None:
        life = self._lives[task.name]
        self._copy_in(task, task.inconst + task.invar)
        life.moment.outputs.update({svar: self.table.get(svar, 0.0) for svar in task.outvar})
        names = {*task.inconst, *task.outconst, *task.invar, *task.outvar}
        life.moment.in_force = frozenset(n for n in names if self._writes.get(n, 0) > self._forgotten.get(n, 0))
        life.marks = {svar: self._writes.get(svar, 0) for svar in task.invar} if task.hardware else {}
        if life.moment.device is not None:
            life.moment.device.is_holding = bool(life.marks)
        preloaded = {svar: _bits(life.moment.outputs[svar]) for svar in task.outvar}
        self._call(task, "on")
        self._copy_out(task, tuple(n for n in task.outvar if _bits(life.moment.outputs[n]) != preloaded[n]))

    def _init(self, task: LawTask) -> None:
        """Law 3: constants in, `init`, constants out."""
        self._copy_in(task, task.inconst)
        self._call(task, "init")
        self._copy_out(task, task.outconst)
        self._lives[task.name].is_initialised = True

    def _clear(self, task: LawTask, life: _Life) -> None:
        self._call(task, "clear")
        if not life.is_initialised:
            self._init(task)

    def _kill(self, task: LawTask, life: _Life) -> None:
        if life.state is not State.KILLED:
            if life.state is State.ON:
                self._leave(task, Step.OFF)
            self._try(task, "kill", lambda: self._call(task, "kill"))
            self._hold(life)
            life.state = after(life.state, Step.KILL)
        self._tell(task, "KILLED")

    def _leave(self, task: LawTask, step: Step) -> bool:
        """Law 3: `off` publishes nothing; a device is left in hold."""
        life = self._lives[task.name]
        life.release = None
        if not self._try(task, "off", lambda: self._call(task, "off")):
            return False
        self._hold(life)
        life.state = after(life.state, step)
        return True

    # Code

    def _try(self, task: LawTask, entry: str, call: Callable[[], Any]) -> bool:
        """What code raises in a cycle goes to its `error` first, but for law 5; else it is ERROR; hold either way."""
        life = self._lives[task.name]
        try:
            call()
        except Exception as wrong:
            self._hold(life)
            if entry == "cycle" and not isinstance(wrong, _LawBroken) and self._mends(task):
                return True
            life.release, life.state = None, after(life.state, Step.FAIL)
            self._tell(task, "ERROR")
            return False
        return True

    def _mends(self, task: LawTask) -> bool:
        try:
            return bool(self._call(task, "error"))
        except Exception:
            return False

    def _call(self, task: LawTask, entry: str) -> Any:
        moment = self._lives[task.name].moment
        moment.now = self.now
        try:
            return task.code[entry](moment) if entry in task.code else None
        finally:
            self.trace.append(Traced(self.now, task.name, entry, dict(moment.inputs), dict(moment.outputs)))

    def _hold(self, life: _Life) -> None:
        if life.moment.device is not None:
            life.moment.device.hold()

    def _copy_in(self, task: LawTask, names: tuple[str, ...]) -> None:
        self._lives[task.name].moment.inputs.update({svar: self.table.get(svar, 0.0) for svar in names})

    def _copy_out(self, task: LawTask, names: tuple[str, ...]) -> None:
        """Law 4: each variable counts its writes."""
        for svar in names:
            self.table[svar] = self._lives[task.name].moment.outputs[svar]
            self._writes[svar] = self._writes.get(svar, 0) + 1

    def _tell(self, task: LawTask, word: str) -> None:
        self.told.append((self.now, task.name, word))

    def _born(self, task: LawTask) -> _Life:
        inputs = dict.fromkeys(task.inconst + task.invar, 0.0)
        outputs = dict.fromkeys(task.outconst + task.outvar, 0.0)
        hand = None
        if task.device and self._world is not None:
            self._world.claim(task.device, _EPOCH)
            hand = Hand(self._published, task.device)
        return _Life(task.period, Moment(0, task.period, inputs, outputs, {}, device=hand))


def _bits(value: float) -> bytes:
    """A number as it lies in memory: NaN equals itself there, and 0.0 is not -0.0."""
    return struct.pack("d", value)
