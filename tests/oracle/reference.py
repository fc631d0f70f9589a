"""The law of the cycle as a small interpreter (laws 1 to 6 and 13): slow and plain, the measure of the executive.

A subsystem on one processing unit, with at most one world. Variables stand in a dict, time is an integer of
nanoseconds, what is due is looked for anew each time. Nothing here is shared with the executive but the words of its
commands and the table of lifecycles; `trace` and `told` of both must be the same.
"""

import math
from collections import deque
from collections.abc import Callable, Iterable
from functools import partial

from onika.model.lifecycle import LifecycleInput, State, after
from onika.model.signal import Signal, SignalKind
from onika.runtime.bus import World
from onika.runtime.command import Clear, Kill, Launch, Rank, Reinit, Switch
from oracle.law_lifecycles import EPOCH, LawBroken, LawLifecycles
from oracle.law_task import LawSwap, LawTask

Request = Switch | Clear | Kill | Rank | Reinit | LawSwap


class Reference(LawLifecycles):
    """Interprets tasks by the law; `world` steps in its own grid, `react` is what a runner answers to a signal."""

    def __init__(
        self,
        tasks: Iterable[LawTask],
        world: World | None = None,
        react: Callable[[str, Signal], list[Request]] = lambda _task, _signal: [],
    ) -> None:
        super().__init__(tasks, world)
        self._stepped_to = 0
        self._react = react
        self._requests: deque[tuple[int, Request]] = deque()
        if world is not None:
            self._step_world(world)
        for task in self._tasks.values():
            if self._try(task, "init", partial(self._init, task)):
                self._lives[task.name].state = after(State.WAITING, LifecycleInput.INITIALISED)

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
        due = [life for life in self._lives.items() if life[1].release is not None and life[1].release <= self.now]
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
                world.command(task.device, EPOCH, *hand.order)
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
        accepted = [signal for signal in signals if self._signal(task, signal)]
        if life.release is not None:
            life.release = life.deadline if task.is_periodic else None
        self.now = began + task.cost
        for signal in accepted:
            self._requests.extendleft((self.now, request) for request in reversed(self._react(task.name, signal)))

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
            raise LawBroken("NaN or infinity")
        else:
            signal = self._call(task, "cycle")
        self._copy_out(task, task.outvar)
        if signal is not None and signal.kind is SignalKind.FINISH and not task.trigger:
            raise TypeError("only a trigger finishes a job")
        return [] if signal is None else [signal]

    def _signal(self, task: LawTask, signal: Signal) -> bool:
        """FINISH and OFF turn the task off; whether the signal is told to others."""
        leaves = {SignalKind.FINISH: LifecycleInput.FINISH, SignalKind.OFF: LifecycleInput.OFF}
        if signal.kind in leaves and not self._leave(task, leaves[signal.kind]):
            return False
        self._tell(task, f"signal {signal.kind.value}")
        return True

    # Requests

    def _obey(self, request: Request) -> None:
        if isinstance(request, Switch):
            self._switch(request)
            return
        if isinstance(request, Rank):
            self._rank(request)
            return
        if isinstance(request, LawSwap):
            self._swap(request.task)
            return
        task, life = self._tasks[request.task], self._lives[request.task]
        if isinstance(request, Kill):
            self._kill(task, life)
        elif isinstance(request, Reinit):
            self._reinit(task, life)
        elif life.state is not State.ERROR:
            self._tell(task, "refused clear")
        elif self._try(task, "clear", lambda: self._clear(task, life)):
            life.state = after(life.state, LifecycleInput.CLEAR)
            self._tell(task, "OFF")

    def _switch(self, switch: Switch) -> None:
        """Law 3: off, then what is forgotten, then rates, then on; no cycle comes in between."""
        for name in switch.off:
            if self._lives[name].state is State.ON and self._leave(self._tasks[name], LifecycleInput.OFF):
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
            life.state, life.release = after(life.state, LifecycleInput.ON), self.now
            self._tell(task, "ON")
