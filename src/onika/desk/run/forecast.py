"""A forecast: a plan is run in virtual time in a process of its own, to see what would become of it (requirement E16).

The process takes only time that nobody else wants, reaches nothing outside of it, and ends with this one. What it runs
stands in a fresh workcell, and nobody answers what tasks ask.
"""

from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass, field
from threading import Lock
from time import monotonic
from typing import Any

from onika.desk.plan.compile import rtpus_of
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.desk.run.runtime_conversation import in_short
from onika.link.lost import LinkLost
from onika.model.planned import task_of
from onika.model.rules.agreement import device_of
from onika.model.syntax import GUARDED
from onika.wire import event, live, request
from onika.wire.plan import Plan, PlannedAction
from onika.wire.request import TargetValues
from onika.words.reason import NOTHING, Reason, reason_of

LONGEST_S = 600.0
"""How much of a program's time is foreseen."""

PATIENCE_S = 60.0
"""How long that may take."""

_TOUCHES = ("workcell.touches", "workcell.carried_touches")
_LOOK_S = 0.05


@dataclass(frozen=True, slots=True)
class ForeseenMishap:
    """What happens that the program does not mean: in which action, when, and how its world stands then.

    action  None: before the first, or nobody knows in which
    """

    text: Reason
    at_s: float
    action: PlannedAction | None
    world: str
    poses: bytes
    lit: tuple[str, ...]


@dataclass(slots=True)
class ForecastResult:
    """What came of it: how long the program lasts, what happens, how everything stands at its end.

    cause   why it is not foreseen to its end; nothing: it is
    watched  of each world of the program whether it says what happens there that is not meant
    scenes  what the worlds consist of in which something happens
    """

    lasts_s: float = 0.0
    cause: Reason = NOTHING
    mishaps: list[ForeseenMishap] = field(default_factory=list)
    standing: tuple[Reason, ...] = ()
    watched: dict[str, bool] = field(default_factory=dict)
    scenes: dict[str, dict[str, Any]] = field(default_factory=dict)


class Forecast:
    """One forecast; `end` ends it from any thread."""

    def __init__(self, plan: Plan, targets: tuple[TargetValues, ...], clock: Callable[[], float] = monotonic) -> None:
        self._plan = plan
        self._targets = targets
        self._clock = clock
        self._lock = Lock()
        self._runtime: LaunchedRuntime | None = None
        self._is_ended = False
        self._began: dict[int, list[tuple[float, int]]] = {}
        self._guarded = {(target.flow, target.action) for target in targets if target.kind == GUARDED}
        self.result = ForecastResult()

    @property
    def pid(self) -> int | None:
        """Its process, once that is there."""
        return None if self._runtime is None else self._runtime.pid

    def end(self) -> None:
        """It is not wanted any more: its process is killed."""
        with self._lock:
            self._is_ended = True
            if self._runtime is not None:
                self._runtime.end_at_once()

    def carry_out(self) -> ForecastResult:
        """Foresee what becomes of the plan; whatever goes wrong is the cause why it is not foreseen to its end."""
        try:
            runtime = self._launched()
            if runtime is not None:
                with runtime:
                    self._follow(runtime)
        except (LinkLost, TimeoutError, OSError) as lost:
            self.result.cause = in_short(lost.reason if isinstance(lost, LinkLost) else reason_of(lost))
        return self.result

    def _launched(self) -> LaunchedRuntime | None:
        with self._lock:
            if self._is_ended:
                return None
            options = ("--forecast",)
            self._runtime = LaunchedRuntime(rtpus_of(self._plan), True, False, options, has_black_box=False)
            return self._runtime

    def _follow(self, runtime: LaunchedRuntime) -> None:
        prepared = runtime.ask(request.Prepare(self._plan, self._targets))
        self.result.cause = _objection(prepared)
        if self.result.cause:
            return
        begun = runtime.ask(request.Begin(settle_s=0.5))
        if isinstance(begun, request.Refused):
            self.result.cause = begun.reason
            return
        self._listen(runtime)
        worlds = runtime.ask(request.Snapshot())
        if isinstance(worlds, request.Worlds):
            self.result.standing = tuple(said for standing in worlds.standings.values() for said in standing)
            self.result.watched = worlds.watched
        for world in dict.fromkeys(mishap.world for mishap in self.result.mishaps):
            scenery = runtime.ask(live.Scene(world))
            if isinstance(scenery, live.Scenery):
                self.result.scenes[world] = scenery.scene

    def _listen(self, runtime: LaunchedRuntime) -> None:
        """Until its end, or for so long."""
        until = self._clock() + PATIENCE_S
        while True:
            for message in runtime.events(_LOOK_S):
                self.hear(message)
                if isinstance(message, event.Result):
                    self.result.lasts_s = message.runtime_s
                    self.result.cause = NOTHING if message.completed else message.cause
                    return
            if self.result.lasts_s > LONGEST_S:
                self.result.cause = Reason.of("desk.forecast_long", minutes=LONGEST_S / 60.0)
            elif self._clock() > until:
                self.result.cause = Reason.of("desk.forecast_late", seconds=PATIENCE_S, at_s=self.result.lasts_s)
            if self.result.cause:
                return

    def hear(self, message: event.Event) -> None:
        """Something has happened in it."""
        if isinstance(message, event.Began):
            self._began.setdefault(message.flow, []).append((message.at_s, message.index))
        elif isinstance(message, event.Mishap):
            spot = self._spot(message.devices, message.at_s)
            if spot not in self._guarded or message.text.key not in _TOUCHES:
                action = None if spot is None else self._plan.flows[spot[0]].actions[spot[1]]
                self.result.mishaps.append(
                    ForeseenMishap(message.text, message.at_s, action, message.world, message.poses, message.lit)
                )
        at_s = getattr(message, "at_s", 0.0)
        self.result.lasts_s = max(self.result.lasts_s, at_s)

    def _spot(self, devices: tuple[str, ...], at_s: float) -> tuple[int, int] | None:
        """The action in which something happened to devices: of the flow that moves them, else of any.

        It is named by its flow and its number there.
        """
        own = [
            number
            for number, flow in enumerate(self._plan.flows)
            if any(device_of(task_of(task)) in devices for task in flow.tasks)
        ]
        present = [spot for number in own or self._began for spot in self._at(number, at_s)]
        if not present:
            return None
        _, number, index = max(present)
        return number, index

    def _at(self, number: int, at_s: float) -> list[tuple[float, int, int]]:
        """The action of a flow that had begun last by then: since when, in which flow, and which one."""
        begun = self._began.get(number, [])
        at = bisect_right(begun, (at_s, len(self._plan.flows[number].actions)))
        return [(begun[at - 1][0], number, begun[at - 1][1])] if at else []


def _objection(prepared: request.Response) -> Reason:
    """Why a plan is not foreseen."""
    if isinstance(prepared, request.Refused):
        return prepared.reason
    if not isinstance(prepared, request.Prepared):
        return NOTHING
    if prepared.faults:
        return prepared.faults[0].reason
    real = tuple(world for world, is_simulated in prepared.worlds.items() if not is_simulated)
    return Reason.of("desk.forecast_real", worlds=real) if real else NOTHING
