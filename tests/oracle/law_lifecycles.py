"""The lives of tasks by the law, under the reference: entry points, constants, exchange of code (laws 3, 5, 12, 21)."""

import struct
from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

from onika.model.lifecycle import LifecycleInput, State, after
from onika.runtime.bus import World
from onika.runtime.command import Rank
from oracle.law_task import DeviceHandle, LawTask, Moment, Traced, Values

EPOCH = 1
"""Of every claim: there is one writer of each device."""


class LawBroken(Exception):
    """Law 5: no `error` entry may mend this."""


@dataclass(slots=True)
class Life:
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


class LawLifecycles:
    """Tasks on one unit with their table; time does not pass here."""

    def __init__(self, tasks: Iterable[LawTask], world: World | None) -> None:
        self.now = 0
        self.table: Values = {}
        self.trace: list[Traced] = []
        self.told: list[tuple[int, str, str]] = []
        self._tasks = {task.name: task for task in tasks}
        self._writes: dict[str, int] = {}
        self._forgotten: dict[str, int] = {}
        self._world = world
        self._published: dict[str, tuple[float, ...]] = {}
        self._lives = {task.name: self._born(task) for task in self._tasks.values()}

    # Entry points

    def _init(self, task: LawTask, entry: str = "init") -> None:
        """Law 3: constants in, `init`, constants out."""
        self._copy_in(task, task.inconst)
        self._call(task, entry)
        self._copy_out(task, task.outconst)
        self._lives[task.name].is_initialised = True

    def _reinit(self, task: LawTask, life: Life) -> None:
        """Law 3, once more: constants in, `reinit` (or `init`), constants out; only of a task that is OFF."""
        if life.state is not State.OFF:
            self._tell(task, "refused reinit")
            return
        life.is_initialised = False
        if self._try(task, "reinit", partial(self._init, task, "reinit" if "reinit" in task.code else "init")):
            self._tell(task, "reinit")

    def _clear(self, task: LawTask, life: Life) -> None:
        self._call(task, "clear")
        if not life.is_initialised:
            self._init(task)

    def _kill(self, task: LawTask, life: Life) -> None:
        if life.state is not State.KILLED:
            if life.state is State.ON:
                self._leave(task, LifecycleInput.OFF)
            self._try(task, "kill", lambda: self._call(task, "kill"))
            self._hold(life)
            life.state = after(life.state, LifecycleInput.KILL)
        self._tell(task, "KILLED")

    def _begin(self, task: LawTask) -> None:
        life = self._lives[task.name]
        self._look(task)
        life.marks = {svar: self._writes.get(svar, 0) for svar in task.invar} if task.hardware else {}
        if life.moment.device is not None:
            life.moment.device.is_holding = bool(life.marks)
        self._copy_out(task, self._changed(task, "on"))

    def _look(self, task: LawTask) -> None:
        """Law 3: all inputs in, own outputs preloaded, and what of them still steers something."""
        life = self._lives[task.name]
        self._copy_in(task, task.inconst + task.invar)
        life.moment.outputs.update({svar: self.table.get(svar, 0.0) for svar in task.outvar})
        names = {*task.inconst, *task.outconst, *task.invar, *task.outvar}
        life.moment.in_force = frozenset(n for n in names if self._writes.get(n, 0) > self._forgotten.get(n, 0))

    def _changed(self, task: LawTask, entry: str) -> tuple[str, ...]:
        """Call an entry point; the outputs that are not what they were before (decision 13)."""
        outputs = self._lives[task.name].moment.outputs
        before = {svar: _bits(outputs[svar]) for svar in task.outvar}
        self._call(task, entry)
        return tuple(svar for svar in task.outvar if _bits(outputs[svar]) != before[svar])

    def _leave(self, task: LawTask, step: LifecycleInput) -> bool:
        """Law 3: `off` publishes nothing; a device is left in hold."""
        life = self._lives[task.name]
        life.release = None
        if not self._try(task, "off", lambda: self._call(task, "off")):
            return False
        self._hold(life)
        life.state = after(life.state, step)
        return True

    # While it lives

    def _rank(self, request: Rank) -> None:
        """Law 1: other places at one instant, from now on."""
        for name, rank in request.ranks:
            if self._lives[name].state is State.KILLED:
                self._tell(self._tasks[name], "refused rank")
            else:
                self._tasks[name] = replace(self._tasks[name], rank=rank)

    def _swap(self, new: LawTask) -> None:
        """Law 21: the new code is made ready beside the old one, which stays as it was if anything fails."""
        old, life = self._tasks[new.name], self._lives[new.name]
        is_on, traced = life.state is State.ON, len(self.trace)
        if life.state is State.KILLED or (is_on and (new.hardware or old.hardware)):
            self._tell(old, "refused swap")
            return
        self._place(new, self._heir(new, life))
        try:
            first = self._take_place(new, is_on)
        except Exception:
            self._place(old, life)
            del self.trace[traced:]
            self._tell(old, "refused swap")
            return
        heir = self._lives[new.name]
        self._place(old, life)
        for entry in ("off", "kill") if is_on and "take" not in new.code else ("kill",):
            with suppress(Exception):
                self._call(old, entry)
        self._place(new, heir)
        self._copy_out(new, tuple(svar for svar in new.outconst if not is_on or svar not in new.outvar))
        self._copy_out(new, first)
        self._tell(new, "swapped")

    def _take_place(self, new: LawTask, is_on: bool) -> tuple[str, ...]:
        """All of a swap that can fail; what the new code's `on` has written."""
        self._copy_in(new, new.inconst)
        self._call(new, "init")
        if not is_on:
            return ()
        self._look(new)
        if "take" not in new.code:
            return self._changed(new, "on")
        self._call(new, "take")
        return ()

    def _place(self, task: LawTask, life: Life) -> None:
        self._tasks[task.name], self._lives[task.name] = task, life

    def _heir(self, new: LawTask, life: Life) -> Life:
        """A life that goes on where the other one stands, with a memory of its own."""
        inputs = dict.fromkeys(new.inconst + new.invar, 0.0)
        outputs = dict.fromkeys(new.outconst + new.outvar, 0.0)
        former = life.moment.memory
        moment = Moment(self.now, life.period, inputs, outputs, {}, device=life.moment.device, former=former)
        return Life(life.period, moment, life.state, True, life.release, life.missed)

    # Code

    def _try(self, task: LawTask, entry: str, call: Callable[[], Any]) -> bool:
        """What code raises in a cycle goes to its `error` first, but for law 5; else it is ERROR; hold either way."""
        life = self._lives[task.name]
        try:
            call()
        except Exception as wrong:
            self._hold(life)
            if entry == "cycle" and not isinstance(wrong, LawBroken) and self._mends(task):
                return True
            was_working = life.state is State.ON and entry != "off"
            self._fail(task)
            if was_working and not task.passive:
                self._starve(task)
            return False
        return True

    def _fail(self, task: LawTask) -> None:
        life = self._lives[task.name]
        self._hold(life)
        life.release, life.state = None, after(life.state, LifecycleInput.FAIL)
        self._tell(task, "ERROR")

    def _starve(self, failed: LawTask) -> None:
        """Law 4: hardware that reads what this task wrote, from task to task, is in ERROR, and what that starves."""
        for task in self._tasks.values():
            is_on = self._lives[task.name].state is State.ON
            if task.hardware and is_on and set(task.invar) & self._stale(set(failed.outvar), failed.name):
                self._fail(task)
                self._starve(task)

    def _stale(self, names: set[str], failed: str) -> set[str]:
        """Everything that tasks which are ON make, cycle by cycle, of these variables; hardware measures anew."""
        working = [task for task in self._tasks.values() if self._lives[task.name].state is State.ON]
        passing = [task for task in working if not task.hardware and task.name != failed]
        more = {svar for task in passing if names & set(task.invar) for svar in task.outvar} - names
        return self._stale(names | more, failed) if more else names

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

    def _hold(self, life: Life) -> None:
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

    def _born(self, task: LawTask) -> Life:
        inputs = dict.fromkeys(task.inconst + task.invar, 0.0)
        outputs = dict.fromkeys(task.outconst + task.outvar, 0.0)
        hand = None
        if task.device and self._world is not None:
            self._world.claim(task.device, EPOCH)
            hand = DeviceHandle(self._published, task.device)
        return Life(task.period, Moment(0, task.period, inputs, outputs, {}, device=hand))


def _bits(value: float) -> bytes:
    """A number as it lies in memory: NaN equals itself there, and 0.0 is not -0.0."""
    return struct.pack("d", value)
