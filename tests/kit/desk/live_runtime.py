"""A small honest model of a runtime that is operated by hand: it answers every live request as the real one does.

    runtime = LiveRuntime(asks={"jtraj": (item,)})
    runtime.ask(live.Change("main", spawn=(task,)))      # Accepted(1)
    list(runtime.events(0.0))                            # TaskState OFF, Edited 1

Tasks only have states, as the table of a task's life allows; their modules do nothing. What the table does not allow is
the cause of the outcome, and then nothing has changed. An application is over as soon as its end is listened for.
"""

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, Protocol

from msgspec import structs

from onika.model.lifecycle import IllegalTransition, LifecycleInput, State, after
from onika.ring.displacement import Displacement
from onika.wire import event, holding, live, request, steer
from onika.wire.foresight import Foreseen, Foresight, WhatIf
from onika.wire.plan import PlannedTask
from onika.wire.rendezvous_link import Linked, LinkRuntimes, OfferPact, PactOffered, Way
from onika.wire.runtime_standing import RtpuStanding, Standing, SubsystemStanding, TaskStanding
from onika.wire.samples import Sample, Sampled
from onika.words.reason import NOTHING, Reason


@dataclass(slots=True)
class _Life:
    """A task as it lives here."""

    task: PlannedTask
    rtpu: str
    state: State = State.OFF
    frequency: float | None = None
    arguments: str = ""
    said: dict[str, str] = field(default_factory=dict)


class SamplingRuntime(Protocol):
    """Has values at every cycle."""

    def ask(self, message: Sample) -> Sampled:
        """Answer with them."""
        ...


class LiveRuntime:
    """Answers requests; tells events when it is listened to. `asks` are tasks that ask when their line is empty."""

    def __init__(
        self,
        rtpus: tuple[str, ...] = ("rt0", "rt1"),
        *,
        is_virtual: bool = True,
        asks: Mapping[str, tuple[event.Item, ...]] | None = None,
        as_time_passes: Callable[["LiveRuntime"], None] = lambda runtime: None,
        addresses: tuple[str, ...] = (),
    ) -> None:
        self._rtpus = rtpus
        self._is_virtual = is_virtual
        self._asks = dict(asks or {})
        self._as_time_passes = as_time_passes
        self._told: deque[event.Event] = deque()
        self._numbers = 0
        self._prepared = ""
        self._holders: dict[str, str] = {}
        self._applications: dict[str, str] = {}
        self.asked: list[request.Request] = []
        self.addresses = addresses
        self.now_s = 0.0
        self.is_stopped = False
        self.is_over = False
        self.running = ""
        self.lives: dict[str, dict[str, _Life]] = {}
        self.variables: dict[str, dict[str, Any]] = {}
        self.scenes: dict[str, dict[str, Any]] = {}
        self.sampling: SamplingRuntime | None = None
        """What answers for values at every cycle."""
        self.foresights: tuple[Foresight, ...] = ()
        """What it foresees, whatever the plan."""
        self.findings: dict[str, tuple[str, ...]] = {}
        self.refusals: dict[str, Reason] = {}
        """Kinds of requests that are refused, by their class's name, with the reason."""
        self.positions: tuple[steer.Position, ...] = ()
        """Where flows are said to be; an application runs in them."""
        self.sessions: tuple[holding.SessionStanding, ...] = (holding.SessionStanding("you", "owner"),)
        self.faults: tuple[request.FaultText, ...] = ()
        """What the next code or plan is found to be wrong with."""
        self.worlds: dict[str, bool] = {}
        """The worlds that are installed: whether they are simulated."""
        self.tight: set[str] = set()
        """Units on which there is no gap between cycles."""
        self.displaced: dict[str, tuple[Displacement, ...]] = {}
        """What does not stand where it stood at their start."""

    def events(self, timeout_s: float) -> Iterator[event.Event]:
        """What happened since the last call; it never waits."""
        if not self._is_virtual:
            self._pass(timeout_s)
        while self._told:
            yield self._told.popleft()
        if self.running:
            self._told.append(event.Result(True, NOTHING, 1, 1, self.now_s, 0.0, {}, (), ""))
            self.running = ""

    def tell(self, message: event.Event) -> None:
        """Let something happen."""
        self._told.append(message)

    def perform(self, application: str, subsystem: str, tasks: Iterable[PlannedTask], holder: str = "you") -> None:
        """Let an application run in a subsystem: its tasks are OFF, and nobody turns them ON but `turn`."""
        self._applications[subsystem], self._holders[subsystem] = application, holder
        self.lives[subsystem] = {task.name: _Life(task, self._rtpus[0], frequency=task.frequency) for task in tasks}

    def turn(self, subsystem: str, task: str, state: State) -> None:
        """Let a task of an application come into a state, and tell it."""
        self.lives[subsystem][task].state = state
        self._tell_state(subsystem, self.lives[subsystem][task])

    def finish(self, application: str) -> None:
        """Let an application be gone with all its tasks; nothing is told."""
        gone = [home for home, name in self._applications.items() if name == application]
        for home in gone:
            del self.lives[home], self._applications[home], self._holders[home]

    def ask(self, message: request.Request) -> request.Response:
        """Answer a request."""
        self.asked.append(message)
        reason = self.refusals.get(type(message).__name__)
        if reason is not None:
            return request.Refused(reason)
        match message:
            case Sample() if self.sampling is not None:
                return self.sampling.ask(message)
            case WhatIf():
                return self._foresee(message)
            case live.Change() | live.Clear() | live.Reinit() | live.Swap() | live.Close():
                return self._edit(message)
            case live.Get() | live.Set():
                return self._parameter(message)
            case live.Survey() | live.Status() | live.Read() | live.Check():
                return self._look(message)
            case steer.Who():
                return steer.Positions(self.positions)
            case request.Prepare():
                self._prepared = message.plan.application
                return request.Prepared(self.faults, worlds=self.worlds)
            case OfferPact() | LinkRuntimes():
                return _linked(message)
            case live.ListWorlds():
                return live.WorldList(self.worlds)
            case live.PutBack():
                return self._put_back(message)
            case holding.Listen():
                self.addresses = (f"ws://{message.place}",)
                return holding.Listening(self.addresses, "/state/token", "tell-me-once", message.role)
            case holding.StopListening():
                self.addresses = ()
        return self._command(message)

    def _put_back(self, message: live.PutBack) -> live.WorldsPutBack:
        """Simulated worlds are as at their start; of the others a person is told what to do."""
        worlds = message.worlds or tuple(self.worlds)
        by_hand = {world: Reason.plain(f"put {world} back by hand") for world in worlds if not self.worlds[world]}
        self.displaced = {world: reasons for world, reasons in self.displaced.items() if world in by_hand}
        return live.WorldsPutBack(tuple(world for world in worlds if world not in by_hand), by_hand)

    def _foresee(self, message: WhatIf) -> request.Response:
        chosen = (message.fault, message.subject)
        asked = tuple(each for each in self.foresights if not message.fault or (each.fault, each.subject) == chosen)
        if asked:
            return Foreseen(asked)
        return request.Refused(Reason.of("foresight.cannot_come", fault=message.fault))

    # -- looking

    def _look(self, message: live.Survey | live.Status | live.Read | live.Check) -> request.Response:
        match message:
            case live.Survey():
                return self._survey()
            case live.Status():
                figures = tuple(
                    self._figure(home, life) for home, lives in self.lives.items() for life in lives.values()
                )
                return live.Figures(figures, dict.fromkeys(self._rtpus, 0.25))
            case live.Read():
                values = self.variables.get(message.subsystem)
                if values is None:
                    return request.Refused(Reason.plain(f"there is no subsystem {message.subsystem}"))
                names = message.names or tuple(values)
                return live.Values({name: values[name] for name in names if name in values}, self.now_s)
            case live.Check():
                return live.Findings(tuple(map(Reason.plain, self.findings.get(message.subsystem, ()))))

    def _survey(self) -> Standing:
        subsystems = tuple(
            SubsystemStanding(
                home,
                self._holders.get(home, ""),
                self._applications.get(home, ""),
                tuple(self._task(life) for life in lives.values()),
            )
            for home, lives in self.lives.items()
        )
        subsystems += tuple(SubsystemStanding(position.subsystem, "", "played", ()) for position in self.positions)
        rtpus = tuple(RtpuStanding(name, False, 0.25) for name in self._rtpus)
        worlds = tuple(self.worlds)
        simulated = tuple(world for world in worlds if self.worlds[world])
        stands = self._is_virtual, self.is_stopped, self.now_s
        return Standing(subsystems, rtpus, worlds, *stands, self.addresses, simulated, self.displaced)

    def _task(self, life: _Life) -> TaskStanding:
        claims = next((words[0] for key, words in life.task.local if key == "DEVICE"), "")
        is_on = life.state is State.ON
        return TaskStanding(life.task, life.state.value, is_on, life.rtpu, life.frequency, claims=claims)

    def _figure(self, home: str, life: _Life) -> live.TaskFigure:
        hz = life.frequency or 0.0
        return live.TaskFigure(
            home, life.task.name, life.task.module, life.rtpu, 1, life.task.type[0].upper(), 0,
            life.state.value.lower(),
            10, 0, hz, hz, 1.0, 5.0, 1e-6, 0.1, 0.3, 0.2, 0.1, 0.3, 0.2, 0,
        )  # fmt: skip

    # -- changing

    def _edit(self, message: live.Change | live.Clear | live.Reinit | live.Swap | live.Close) -> request.Response:
        if isinstance(message, live.Swap) and self.faults:
            return request.Prepared(self.faults)
        self._numbers += 1
        number, cause = self._numbers, self._lack_of_room(message)
        if self.is_stopped and isinstance(message, live.Change) and message.on:
            cause = Reason.plain("everything is stopped")
        elif not cause:
            try:
                self._carry_out(message)
            except (IllegalTransition, KeyError, ValueError) as wrong:
                cause = Reason.plain(str(wrong))
        self._told.append(event.Edited(message.subsystem, number, cause, self.now_s))
        return live.Accepted(number)

    def _lack_of_room(self, message: live.LiveRequest) -> Reason:
        """That newcomers, or new code, find no gap on a tight unit, unless there may be a moment of hold."""
        match message:
            case live.Change(holds=False):
                tight = [task.name for task in message.spawn if self._home(task.rtpu) in self.tight]
            case live.Swap(holds=False):
                life = self.lives.get(message.subsystem, {}).get(message.task)
                tight = [message.task] if life is not None and life.rtpu in self.tight else []
            case _:
                tight = []
        if not tight:
            return NOTHING
        no_gap = Reason.of("runtime.no_gap", needs_ms=2.74, largest_ms=1.89)
        why = Reason.of("host.entry_failed", entry="spawn", why=no_gap)
        return Reason.of("host.several", reasons=tuple(Reason.of("host.of_task", task=task, why=why) for task in tight))

    def _home(self, wanted: str) -> str:
        return wanted if wanted in self._rtpus else self._rtpus[0]

    def _carry_out(self, message: live.Change | live.Clear | live.Reinit | live.Swap | live.Close) -> None:
        lives = self.lives.setdefault(message.subsystem, {})
        match message:
            case live.Change():
                self._change(message, lives)
            case live.Clear():
                self._step(message.subsystem, lives[message.task], LifecycleInput.CLEAR)
            case live.Reinit():
                self._step(message.subsystem, lives[message.task], LifecycleInput.REINIT)
            case live.Swap():
                life = lives[message.task]
                life.said.clear()
                life.task = structs.replace(life.task, digest=message.code.digest, module=message.code.module)
            case live.Close():
                self._change(live.Change(message.subsystem, kill=tuple(lives)), lives)
                del self.lives[message.subsystem]
                self.variables.pop(message.subsystem, None)

    def _change(self, message: live.Change, lives: dict[str, _Life]) -> None:
        self._judge(message, lives)
        for name in message.off:
            self._step(message.subsystem, lives[name], LifecycleInput.OFF)
        for name in message.kill:
            self._step(message.subsystem, lives.pop(name), LifecycleInput.KILL)
        self.variables.setdefault(message.subsystem, {})
        for task in message.spawn:
            rtpu = task.rtpu if task.rtpu in self._rtpus else self._rtpus[0]
            lives[task.name] = _Life(task, rtpu, frequency=task.frequency)
            self._tell_state(message.subsystem, lives[task.name])
        for name, hz in message.rates:
            lives[name].frequency = hz
        for turn in message.on:
            self._turn_on(message.subsystem, lives[turn.task], turn.arguments)

    def _judge(self, message: live.Change, lives: dict[str, _Life]) -> None:
        """All or nothing: raises before anything is done."""
        after_kill = {name: life.state for name, life in lives.items() if name not in message.kill}
        for task in message.spawn:
            if task.name in after_kill:
                raise ValueError(f"there is a task {task.name} already")
            after_kill[task.name] = State.OFF
        for name in (*message.off, *message.kill, *(name for name, _ in message.rates)):
            if name not in lives:
                raise ValueError(f"there is no task {name}")
        for turn in message.on:
            after(after_kill[turn.task], LifecycleInput.ON)

    def _turn_on(self, home: str, life: _Life, arguments: str) -> None:
        life.arguments = arguments
        items = self._asks.get(life.task.name)
        if items and not arguments:
            self._step(home, life, LifecycleInput.ASK)
            self._told.append(event.Asked(home, life.task.name, NOTHING, items, self.now_s))
        else:
            self._step(home, life, LifecycleInput.ON if life.state is State.OFF else LifecycleInput.ANSWERED)

    def _step(self, home: str, life: _Life, step: LifecycleInput) -> None:
        former, life.state = life.state, after(life.state, step)
        if life.state is not former:
            self._tell_state(home, life)

    def _tell_state(self, home: str, life: _Life) -> None:
        self._told.append(event.TaskState(home, life.task.name, life.state.value, self.now_s))

    def _parameter(self, message: live.Get | live.Set) -> request.Response:
        parameters = self.lives[message.subsystem][message.task].said
        if isinstance(message, live.Set):
            parameters[message.name] = message.value
            return live.Value(None)
        if message.name not in parameters:
            return request.Refused(Reason.plain(f"there is nothing called {message.name!r} to get"))
        return live.Value(parameters[message.name])

    # -- the whole

    def _command(self, message: request.Request) -> request.Response:
        match message:
            case request.Begin():
                if not self._prepared:
                    return request.Refused(Reason.plain("no plan is prepared"))
                self.running = self._prepared
                self._told.append(event.Began(0, 0, 1, self.running, self.now_s))
            case request.Reply():
                self._turn_on(message.subsystem, self.lives[message.subsystem][message.task], message.line)
            case request.Abort():
                self.running = ""
                result = event.Result(False, message.cause, 0, 1, self.now_s, 0.0, {}, (), "", run=message.subsystem)
                self._told.append(result)
            case request.Stop() | live.Reset():
                self.is_stopped = isinstance(message, request.Stop)
                self._told.append(event.Stopped(self.is_stopped, getattr(message, "cause", NOTHING)))
            case live.Take() | live.Release():
                self._hand(message)
                holder = "you" if isinstance(message, live.Take) else ""
                self._told.append(event.Held(message.subsystem, holder))
            case holding.Sessions():
                return holding.Company("you", self.sessions)
            case holding.Hand():
                self._told.append(
                    event.Offered(message.subsystem, "you", message.to, Reason.plain("" if message.to else "withdrawn"))
                )
            case holding.Decline():
                self._told.append(event.Offered(message.subsystem, "anna#2", "you", Reason.plain("you declines")))
            case live.Scene():
                scene = self.scenes.get(message.world)
                return (
                    request.Refused(Reason.plain(f"no world {message.world} is open"))
                    if scene is None
                    else live.Scenery(scene)
                )
            case live.Advance():
                self._pass(message.seconds)
            case request.Quit():
                self.is_over = True
        return request.Done()

    def _hand(self, message: live.Take | live.Release) -> None:
        """A subsystem that is taken is there; one that is left with nothing in it is no more."""
        if isinstance(message, live.Take):
            self._holders[message.subsystem] = "you"
            self.lives.setdefault(message.subsystem, {})
            return
        self._holders.pop(message.subsystem, None)
        if not self.lives.get(message.subsystem):
            self.lives.pop(message.subsystem, None)

    def _pass(self, seconds: float) -> None:
        self.now_s += seconds
        self._as_time_passes(self)


def _linked(message: OfferPact | LinkRuntimes) -> PactOffered | Linked:
    """As near as another machine of the room: a round trip of 2 ms."""
    if isinstance(message, OfferPact):
        return PactOffered(4711, b"n" * 8, b"k" * 16, 1)
    return Linked(tuple(Way(other.site, 2_000_000, 1_000_000) for other in message.partners))
