"""A small honest model of a runtime that is operated by hand: it answers every live request as the real one does.

    runtime = LiveRuntime(asks={"jtraj": (item,)})
    runtime.ask(live.Change("main", spawn=(task,)))      # Accepted(1)
    list(runtime.events(0.0))                            # TaskState OFF, Edited 1

Tasks only have states, as the table of a task's life allows; their modules do nothing. What the table does not allow is
the cause of the outcome, and then nothing has changed. An application is over as soon as its end is listened for.
"""

from collections import deque
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from onika.model.lifecycle import IllegalTransition, LifecycleInput, State, after
from onika.wire import event, holding, live, request, steer
from onika.wire.plan import PlannedTask
from onika.words.reason import Text


@dataclass(slots=True)
class _Life:
    """A task as it lives here."""

    task: PlannedTask
    rtpu: str
    state: State = State.OFF
    frequency: float | None = None
    arguments: str = ""
    said: dict[str, str] = field(default_factory=dict)


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
        self.asked: list[request.Request] = []
        self.addresses = addresses
        self.now_s = 0.0
        self.is_stopped = False
        self.is_over = False
        self.running = ""
        self.lives: dict[str, dict[str, _Life]] = {}
        self.variables: dict[str, dict[str, Any]] = {}
        self.scenes: dict[str, dict[str, Any]] = {}
        self.findings: dict[str, tuple[str, ...]] = {}
        self.refusals: dict[str, Text] = {}
        """Kinds of requests that are refused, by their class's name, with the reason."""
        self.positions: tuple[steer.Position, ...] = ()
        """Where flows are said to be; an application runs in them."""
        self.sessions: tuple[holding.SessionStanding, ...] = (holding.SessionStanding("you", "owner"),)
        self.faults: tuple[request.FaultText, ...] = ()
        """What the next code or plan is found to be wrong with."""

    def events(self, timeout_s: float) -> Iterator[event.Event]:
        """What happened since the last call; it never waits."""
        if not self._is_virtual:
            self._pass(timeout_s)
        while self._told:
            yield self._told.popleft()
        if self.running:
            self._told.append(event.Result(True, "", 1, 1, self.now_s, 0.0, {}, (), ""))
            self.running = ""

    def tell(self, one: event.Event) -> None:
        """Let something happen."""
        self._told.append(one)

    def ask(self, asked: request.Request) -> request.Response:
        """Answer a request."""
        self.asked.append(asked)
        reason = self.refusals.get(type(asked).__name__)
        if reason is not None:
            return request.Refused(reason)
        match asked:
            case live.Change() | live.Clear() | live.Reinit() | live.Swap() | live.Close():
                return self._edit(asked)
            case live.Get() | live.Set():
                return self._parameter(asked)
            case live.Survey() | live.Status() | live.Read() | live.Check():
                return self._look(asked)
            case steer.Who():
                return steer.Positions(self.positions)
            case request.Prepare():
                self._prepared = asked.plan.application
                return request.Prepared(self.faults)
        return self._command(asked)

    # -- looking

    def _look(self, asked: live.Survey | live.Status | live.Read | live.Check) -> request.Response:
        match asked:
            case live.Survey():
                return self._survey()
            case live.Status():
                figures = tuple(self._figure(home, one) for home, lives in self.lives.items() for one in lives.values())
                return live.Figures(figures, dict.fromkeys(self._rtpus, 0.25))
            case live.Read():
                known = self.variables.get(asked.subsystem)
                if known is None:
                    return request.Refused(f"there is no subsystem {asked.subsystem}")
                names = asked.names or tuple(known)
                return live.Values({name: known[name] for name in names if name in known}, self.now_s)
            case live.Check():
                return live.Findings(self.findings.get(asked.subsystem, ()))

    def _survey(self) -> live.Standing:
        subsystems = tuple(
            live.SubsystemStanding(
                home, self._holders.get(home, ""), "", tuple(self._task(one) for one in lives.values())
            )
            for home, lives in self.lives.items()
        )
        subsystems += tuple(live.SubsystemStanding(one.subsystem, "", "played", ()) for one in self.positions)
        rtpus = tuple(live.RtpuStanding(name, False, 0.25) for name in self._rtpus)
        return live.Standing(subsystems, rtpus, (), self._is_virtual, self.is_stopped, self.now_s, self.addresses)

    def _task(self, one: _Life) -> live.TaskStanding:
        return live.TaskStanding(one.task, one.state.value, one.state is State.ON, one.rtpu, one.frequency)

    def _figure(self, home: str, one: _Life) -> live.TaskFigure:
        hz = one.frequency or 0.0
        return live.TaskFigure(
            home, one.task.name, one.task.module, one.rtpu, 1, one.task.type[0].upper(), 0, one.state.value.lower(),
            10, 0, hz, hz, 1.0, 5.0, 1e-6, 0.1, 0.3, 0.2, 0.1, 0.3, 0.2, 0,
        )  # fmt: skip

    # -- changing

    def _edit(self, asked: live.Change | live.Clear | live.Reinit | live.Swap | live.Close) -> request.Response:
        if isinstance(asked, live.Swap) and self.faults:
            return request.Prepared(self.faults)
        self._numbers += 1
        number, cause = self._numbers, ""
        if self.is_stopped and isinstance(asked, live.Change) and asked.on:
            cause = "everything is stopped"
        else:
            try:
                self._carry_out(asked)
            except (IllegalTransition, KeyError, ValueError) as wrong:
                cause = str(wrong)
        self._told.append(event.Edited(asked.subsystem, number, cause, self.now_s))
        return live.Accepted(number)

    def _carry_out(self, asked: live.Change | live.Clear | live.Reinit | live.Swap | live.Close) -> None:
        lives = self.lives.setdefault(asked.subsystem, {})
        match asked:
            case live.Change():
                self._change(asked, lives)
            case live.Clear():
                self._step(asked.subsystem, lives[asked.task], LifecycleInput.CLEAR)
            case live.Reinit():
                self._step(asked.subsystem, lives[asked.task], LifecycleInput.REINIT)
            case live.Swap():
                lives[asked.task].said.clear()
            case live.Close():
                self._change(live.Change(asked.subsystem, kill=tuple(lives)), lives)
                del self.lives[asked.subsystem]
                self.variables.pop(asked.subsystem, None)

    def _change(self, asked: live.Change, lives: dict[str, _Life]) -> None:
        self._judge(asked, lives)
        for name in asked.off:
            self._step(asked.subsystem, lives[name], LifecycleInput.OFF)
        for name in asked.kill:
            self._step(asked.subsystem, lives.pop(name), LifecycleInput.KILL)
        self.variables.setdefault(asked.subsystem, {})
        for task in asked.spawn:
            rtpu = task.rtpu if task.rtpu in self._rtpus else self._rtpus[0]
            lives[task.name] = _Life(task, rtpu, frequency=task.frequency)
            self._tell_state(asked.subsystem, lives[task.name])
        for name, hz in asked.rates:
            lives[name].frequency = hz
        for turn in asked.on:
            self._turn_on(asked.subsystem, lives[turn.task], turn.arguments)

    def _judge(self, asked: live.Change, lives: dict[str, _Life]) -> None:
        """All or nothing: raises before anything is done."""
        after_kill = {name: one.state for name, one in lives.items() if name not in asked.kill}
        for task in asked.spawn:
            if task.name in after_kill:
                raise ValueError(f"there is a task {task.name} already")
            after_kill[task.name] = State.OFF
        for name in (*asked.off, *asked.kill, *(name for name, _ in asked.rates)):
            if name not in lives:
                raise ValueError(f"there is no task {name}")
        for turn in asked.on:
            after(after_kill[turn.task], LifecycleInput.ON)

    def _turn_on(self, home: str, one: _Life, arguments: str) -> None:
        one.arguments = arguments
        items = self._asks.get(one.task.name)
        if items and not arguments:
            self._step(home, one, LifecycleInput.ASK)
            self._told.append(event.Asked(home, one.task.name, "", items, self.now_s))
        else:
            self._step(home, one, LifecycleInput.ON if one.state is State.OFF else LifecycleInput.ANSWERED)

    def _step(self, home: str, one: _Life, step: LifecycleInput) -> None:
        former, one.state = one.state, after(one.state, step)
        if one.state is not former:
            self._tell_state(home, one)

    def _tell_state(self, home: str, one: _Life) -> None:
        self._told.append(event.TaskState(home, one.task.name, one.state.value, self.now_s))

    def _parameter(self, asked: live.Get | live.Set) -> request.Response:
        said = self.lives[asked.subsystem][asked.task].said
        if isinstance(asked, live.Set):
            said[asked.name] = asked.value
            return live.Value(None)
        if asked.name not in said:
            return request.Refused(f"there is nothing called {asked.name!r} to get")
        return live.Value(said[asked.name])

    # -- the whole

    def _command(self, asked: request.Request) -> request.Response:
        match asked:
            case request.Begin():
                if not self._prepared:
                    return request.Refused("no plan is prepared")
                self.running = self._prepared
                self._told.append(event.Began(0, 0, 1, self.running, self.now_s))
            case request.Reply():
                self._turn_on(asked.subsystem, self.lives[asked.subsystem][asked.task], asked.line)
            case request.Abort():
                self.running = ""
                self._told.append(event.Result(False, asked.cause, 0, 1, self.now_s, 0.0, {}, (), ""))
            case request.Stop() | live.Reset():
                self.is_stopped = isinstance(asked, request.Stop)
                self._told.append(event.Stopped(self.is_stopped, getattr(asked, "cause", "")))
            case live.Take() | live.Release():
                self._hand(asked)
                holder = "you" if isinstance(asked, live.Take) else ""
                self._told.append(event.Held(asked.subsystem, holder))
            case holding.Sessions():
                return holding.Company("you", self.sessions)
            case holding.Hand():
                self._told.append(event.Offered(asked.subsystem, "you", asked.to, "" if asked.to else "withdrawn"))
            case holding.Decline():
                self._told.append(event.Offered(asked.subsystem, "anna#2", "you", "you declines"))
            case live.Scene():
                scene = self.scenes.get(asked.world)
                return request.Refused(f"no world {asked.world} is open") if scene is None else live.Scenery(scene)
            case live.Advance():
                self._pass(asked.seconds)
            case request.Quit():
                self.is_over = True
        return request.Done()

    def _hand(self, asked: live.Take | live.Release) -> None:
        """A subsystem that is taken is there; one that is left with nothing in it is no more."""
        if isinstance(asked, live.Take):
            self._holders[asked.subsystem] = "you"
            self.lives.setdefault(asked.subsystem, {})
            return
        self._holders.pop(asked.subsystem, None)
        if not self.lives.get(asked.subsystem):
            self.lives.pop(asked.subsystem, None)

    def _pass(self, seconds: float) -> None:
        self.now_s += seconds
        self._as_time_passes(self)
