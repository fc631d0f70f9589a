"""An outlook: the tables that act when a fault comes, acting on a copy of a situation (requirement X24).

The lifecycle of tasks, the table of drives, the engine of each run and what it answers with are those of the runtime;
here their orders are carried out on states alone. Every change is written down with the time by which it has come.
"""

from collections import deque
from collections.abc import Iterable, Iterator
from copy import deepcopy
from dataclasses import replace

from onika.engine import news as engine_news, orders
from onika.engine.flow import FlowState
from onika.host.foresight.situation import Address, Situation
from onika.host.recording.recorder import END_NS
from onika.host.run.application_run import REST_NS
from onika.host.run.engine_news import of_task
from onika.model.lifecycle import LifecycleInput, State, after
from onika.model.rules.starvation import starved, writer_failed
from onika.ring.device import DriveState
from onika.ring.drive import NEVER_NS, DriveInput, DriveMode, DriveUnit
from onika.runtime import news
from onika.wire.foresight import Effect
from onika.wire.steer import Position
from onika.words.reason import NOTHING, Reason

STEP_MS = 10.0
"""A world makes its next step within this time: then commands act, and a drive has looked how long it heard nothing."""
LOOP_MS = 50.0
"""The runtime's program, and every unit of it, takes in what it is told within this time."""

PAUSING = "pausing"
"""What is said of a flow that pauses after its current action."""

_MS = 1e-6
_ALIVE = (State.ON, State.ASKING)


class Outlook:
    """What becomes of tasks, drives, flows and runs; `effects` is what has changed so far."""

    def __init__(self, situation: Situation) -> None:
        self.situation = situation
        self.states = {address: facts.state for address, facts in situation.tasks.items()}
        self.drives = {device: _drive(mode) for device, mode in situation.modes.items()}
        self.claims = {
            facts.device: address
            for address, facts in situation.tasks.items()
            if facts.device in situation.modes and facts.state is not State.KILLED
        }
        self.effects: list[Effect] = []
        self._engines = [deepcopy(run.engine) for run in situation.runs]
        self._before = [_states(engine.positions()) for engine in self._engines]
        self._over: set[int] = set()
        self._news: deque[tuple[int, engine_news.News, float]] = deque()

    def reached(self, records: str = "") -> Situation:
        """The situation as it is by now, from which another outlook may begin."""
        before = self.situation
        tasks = {address: replace(facts, state=self.states[address]) for address, facts in before.tasks.items()}
        runs = tuple(replace(run, engine=engine) for run, engine in zip(before.runs, self._engines, strict=True))
        modes = {device: unit.mode for device, unit in self.drives.items()}
        return replace(before, tasks=tasks, modes=modes, runs=runs, records=records)

    # What happens to tasks

    def fail(self, address: Address, cause: Reason, at_ms: float, is_heard: bool = True) -> None:
        """It goes to ERROR and its device into hold, as `EntryPoints.fail` does, and whom it starves with it.

        Their run is told, if it still hears.
        """
        failures = list(self._failures(address, cause, at_ms))
        for failed, before, message, failed_ms in failures:
            if is_heard:
                self._hear(failed, message, before, failed_ms)

    def starve(self, fed: Iterable[tuple[Address, Reason]], at_ms: float) -> None:
        """Tasks are gone that fed this hardware: what of it is still ON goes to ERROR."""
        for address, cause in fed:
            if self.states[address] is State.ON:
                self.fail(address, cause, at_ms)

    def fed_by(self, address: Address, state: State) -> list[tuple[Address, Reason]]:
        """The hardware that a task feeds while it is ON, each with what it says when the task comes into this state."""
        tasks = self.situation.tasks
        if self.states[address] is not State.ON or tasks[address].wired.sheet.passive:
            return []
        subsystem, name = address
        home = [facts for facts in tasks.values() if facts.subsystem == subsystem]
        working = [facts.wired for facts in home if self.states[facts.address] is State.ON]
        hardware = [wired.name for wired in working if wired.sheet.hardware]
        fed = starved(tasks[address].wired.meeting, [wired.meeting for wired in working], hardware)
        return [((subsystem, other), writer_failed(name, variable, state)) for other, variable in fed.items()]

    def turn_off(self, address: Address, at_ms: float, signal: str = "") -> None:
        """It goes off, by itself (`signal`) or as it was told; its device holds."""
        before = self.states[address]
        if before in _ALIVE:
            self._hold(address, at_ms)
            self._turn(address, LifecycleInput.OFF, at_ms, "TaskState")
            self._hear(address, news.Changed(*address, State.OFF.value, 0, signal), before, at_ms)

    def kill(self, address: Address, at_ms: float, is_heard: bool = True) -> None:
        """It is gone, and has given its device back; a task whose unit is gone has not held it before."""
        before = self.states[address]
        if before is State.KILLED:
            return
        if before in _ALIVE and is_heard:
            self._hold(address, at_ms)
        self._turn(address, LifecycleInput.KILL, at_ms, "TaskState")
        for device in [device for device, claimed_by in self.claims.items() if claimed_by == address]:
            self.drive(device, DriveInput.RELEASE, at_ms)
            del self.claims[device]
        self._hear(address, news.Changed(*address, State.KILLED.value, 0), before, at_ms)

    def on_in(self, subsystems: Iterable[str]) -> list[Address]:
        """Their tasks that are ON, or ask."""
        names = set(subsystems)
        return [address for address, state in self.states.items() if address[0] in names and state in _ALIVE]

    # What happens to drives

    def drive(self, device: str, drive_input: DriveInput, at_ms: float) -> None:
        """Something happens to a drive: it moves as its table says, within a step of its world."""
        unit = self.drives.get(device)
        if unit is None:
            return
        before = unit.shown
        unit.feed(drive_input)
        if unit.shown is not before:
            self._drive_changed(device, before.name, unit.shown.name, at_ms + STEP_MS)

    def silence(self, devices: Iterable[str], until_ms: float) -> None:
        """Nobody commands these from now on: each drive counts by itself, up to a time."""
        for device in devices:
            unit = self.drives[device]
            unit.last_ns = 0
            while unit.due_ns < NEVER_NS and unit.due_ns * _MS <= until_ms:
                at_ns, heard = unit.due_ns, unit.silence(unit.due_ns + 1)
                if heard is None:
                    break
                self.drive(device, heard, at_ns * _MS)

    def vanish(self, devices: Iterable[str], at_ms: float) -> None:
        """What steps these is gone, and they with it."""
        for device in devices:
            before = self.drives[device].shown.name
            text = Reason.of("foresight.drives_gone", devices=(device,))
            self.effects.append(Effect(at_ms, "drive", device, before, "GONE", text))

    # What happens to runs and subsystems

    def tell_engine(self, run: int, message: engine_news.News, at_ms: float) -> None:
        """Tell the engine of a run something, and carry out what it orders, and what comes of that."""
        self._news.append((run, message, at_ms))
        self._go_on()

    def abort(self, run: int, cause: Reason, at_ms: float) -> None:
        """End a run."""
        self.tell_engine(run, engine_news.Abort(cause), at_ms)

    def note(self, effect: Effect) -> None:
        """Something changes that stands in no table here."""
        self.effects.append(effect)

    def positions(self, run: int) -> list[Position]:
        """Where the flows of a run are by now."""
        return self._engines[run].positions()

    def is_over(self, run: int) -> bool:
        """Whether a run has ended."""
        return run in self._over

    # Inner

    def _failures(
        self, address: Address, cause: Reason, at_ms: float
    ) -> Iterator[tuple[Address, State, news.Failed, float]]:
        """Each task that fails by this, its state before, its news and the time."""
        before = self.states[address]
        if before is State.KILLED:
            return
        fed = self.fed_by(address, State.ERROR)
        self._hold(address, at_ms)
        self._turn(address, LifecycleInput.FAIL, at_ms, "Failed")
        yield address, before, news.Failed(*address, "cycle", cause, "", 0, "", 0), at_ms
        tasks = self.situation.tasks
        for other, reason in fed:
            if self.states[other] is State.ON:
                is_elsewhere = tasks[other].unit != tasks[address].unit
                yield from self._failures(other, reason, at_ms + LOOP_MS * is_elsewhere)

    def _hold(self, address: Address, at_ms: float) -> None:
        device = self.situation.tasks[address].device
        if self.claims.get(device) == address:
            self.drive(device, DriveInput.HOLD, at_ms)

    def _turn(self, address: Address, step: LifecycleInput, at_ms: float, told: str) -> None:
        before = self.states[address]
        self.states[address] = now = after(before, step)
        if now is before:
            return
        text = Reason.of("foresight.task_turns", task="/".join(address), state=now.value, ms=at_ms)
        self.effects.append(Effect(at_ms, "task", "/".join(address), before.value, now.value, text, told))

    def _drive_changed(self, device: str, before: str, now: str, at_ms: float) -> None:
        text = _drive_text(device, now, at_ms)
        self.effects.append(Effect(at_ms, "drive", device, before, now, text, "Drive"))

    def _hear(self, address: Address, message: news.TaskNews, before: State, at_ms: float) -> None:
        """What a task says reaches the engine of its run, if it has one."""
        run = self.situation.run_of(address[0])
        if run is None:
            return
        flow = self.situation.runs[run].subsystems.index(address[0])
        meaning = of_task(flow, message, before)
        if meaning is not None:
            self._news.append((run, meaning, at_ms + LOOP_MS))
            self._go_on()

    def _go_on(self) -> None:
        """One piece of news after the other, as a runner takes them in; orders lead to news that wait their turn."""
        if len(self._news) > 1:
            return  # it is under way
        while self._news:
            run, message, at_ms = self._news[0]
            for order in self._engines[run].feed(message):
                self._carry_out(run, order, at_ms)
            self._news.popleft()

    def _carry_out(self, run: int, order: orders.Order, at_ms: float) -> None:
        names = self.situation.runs[run].subsystems
        match order:
            case orders.Spawn():
                self._spawn((names[order.flow], order.task), at_ms)
            case orders.Switch():
                for task in order.off:
                    self.turn_off((names[order.flow], task), at_ms)
                for launch in order.on:
                    self._turn_on((names[order.flow], launch.task), at_ms)
            case orders.Off():
                self.turn_off((names[order.flow], order.task), at_ms)
            case orders.Kill():
                self.kill((names[order.flow], order.task), at_ms + LOOP_MS)
            case orders.Moved():
                self._flow_moved(run, order, at_ms)
            case orders.End():
                self._end(run, order, at_ms)

    def _spawn(self, address: Address, at_ms: float) -> None:
        before = self.states[address]
        self._turn(address, LifecycleInput.INITIALISED, at_ms, "TaskState")
        self._hear(address, news.Initialised(*address), before, at_ms)

    def _turn_on(self, address: Address, at_ms: float) -> None:
        before = self.states[address]
        self._turn(address, LifecycleInput.ON, at_ms, "TaskState")
        device = self.situation.tasks[address].device
        if self.claims.get(device) == address:
            self.drive(device, DriveInput.DRIVE, at_ms)
        self._hear(address, news.Changed(*address, State.ON.value, 0), before, at_ms)

    def _flow_moved(self, run: int, moved: orders.Moved, at_ms: float) -> None:
        name = self.situation.runs[run].subsystems[moved.flow]
        before = self._before[run][name]
        position = self._engines[run].positions()[moved.flow]
        now = PAUSING if position.is_pausing and moved.state == before else moved.state
        if now == before:
            return
        self._before[run][name] = now
        text = _flow_text(name, now, at_ms)
        if text:
            self.effects.append(Effect(at_ms, "flow", name, before, now, text, "Moved"))

    def _end(self, run: int, end: orders.End, at_ms: float) -> None:
        self._over.add(run)
        run_facts = self.situation.runs[run]
        told_ms = at_ms + REST_NS * _MS + (END_NS * _MS if self.situation.records == run_facts.application else 0.0)
        text = Reason.of("foresight.run_ends", application=run_facts.application, ms=told_ms)
        state = "completed" if end.completed else "aborted"
        self.effects.append(Effect(told_ms, "run", run_facts.application, "running", state, text, "Result"))


def _drive(mode: DriveMode) -> DriveUnit:
    unit = DriveUnit()
    unit.mode = mode
    return unit


def _drive_text(device: str, state: str, ms: float) -> Reason:
    if state == DriveState.HELD.name:
        return Reason.of("foresight.drives_hold", devices=(device,), ms=ms)
    if state == DriveState.TRIPPED.name:
        return Reason.of("foresight.drives_trip", devices=(device,), ms=ms)
    if state == DriveState.PRESSED.name:
        return Reason.of("foresight.drives_pressed", devices=(device,), ms=ms)
    return Reason.of("foresight.drives_follow", devices=(device,), ms=ms)


def _flow_text(flow: str, state: str, ms: float) -> Reason:
    """What it means that a flow has come into a state; nothing of the states in which a run ends."""
    if state == FlowState.STOPPED.value:
        return Reason.of("foresight.flow_stands", flow=flow, ms=ms)
    if state in (PAUSING, FlowState.PAUSED.value):
        return Reason.of("foresight.flow_pauses", flow=flow)
    return NOTHING


def _states(positions: list[Position]) -> dict[str, str]:
    return {position.subsystem: position.state for position in positions}
