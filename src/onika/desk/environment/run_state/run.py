"""A run of an open application: what is shown of it, and how the actions of its plan belong to steps (E07, E11)."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from msgspec import structs

from onika.desk.environment.run_state.membership import StepMembership
from onika.desk.environment.run_state.messages import IconWording
from onika.desk.environment.run_state.puzzle_attempt import PuzzleAttempt
from onika.desk.plan.begin_places import FlowEnd
from onika.desk.plan.flow_guests import guest_of
from onika.desk.plan.flow_index import FlowIndex
from onika.desk.plan.flow_worlds import driven_worlds
from onika.desk.run.flow_status import FlowStatus
from onika.wire import event
from onika.wire.plan import Again, Plan, PlannedAction, Unless
from onika.wire.view import FlowRunView, RunView
from onika.words.reason import NOTHING, Reason


@dataclass(frozen=True, slots=True)
class RunPart:
    """The flows of a run that one of several runtimes carries out."""

    station: str
    flows: tuple[int, ...]
    """Their numbers in the whole plan, in the order in which that runtime has them."""
    result: event.Result | None = None
    """How it has ended; None: it goes on."""


@dataclass(frozen=True, slots=True)
class Run:
    """The run of an application that goes on now, or the last one."""

    view: RunView
    plan: Plan
    flow_index: FlowIndex
    """Its flows by the words of steering."""
    belonging: StepMembership
    wording: IconWording = field(default_factory=IconWording)
    """The words in which it is told."""
    durations: Mapping[tuple[int, int], float] = field(default_factory=dict)
    """What targets say of how long their action should take, by flow and action."""
    statuses: Mapping[str, FlowStatus] = field(default_factory=dict)
    """Where its flows are, by subsystem."""
    on: frozenset[str] = frozenset()
    """The tasks that are ON, as `SUBSYSTEM/TASK`."""
    failures: Mapping[str, event.Failed] = field(default_factory=dict)
    """Of the tasks in ERROR, by `SUBSYSTEM/TASK`."""
    halts: Mapping[str, event.Drive] = field(default_factory=dict)
    """What was told of drives that hold now, by device."""
    awaits: int | None = None
    """The live change that has to end before it can begin, by its number."""
    reason: Reason = NOTHING
    """Why a flow stood when it was ended."""
    is_given_up: bool = False
    """Whether the user has said abort before it had begun."""
    is_to_pause: bool = False
    """Whether the user has said pause before it had begun."""
    outcomes: Mapping[int, Reason] = field(default_factory=dict)
    """What came of live changes while the run was about to begin, by number."""
    station: str = ""
    """Where it is carried out; empty: at the first station."""
    attempt: PuzzleAttempt | None = None
    """The puzzle that it is to solve; None: there is none."""
    ends: Mapping[int, FlowEnd] = field(default_factory=dict)
    """Where its flows were when it ended, by number."""
    parts: tuple[RunPart, ...] = ()
    """Of a run at several stations, what each carries out; empty: it is at one."""

    @property
    def doc(self) -> str:
        """The application."""
        return self.view.doc

    @property
    def is_over(self) -> bool:
        """Whether it has come to its end."""
        return self.view.state == "over"

    @property
    def homes(self) -> tuple[str, ...]:
        """Its subsystems, in the order of the plan."""
        return tuple(flow.subsystem for flow in self.plan.flows)

    def is_at(self, station: str) -> bool:
        """Whether something of it is carried out at a station."""
        return self.station == station if not self.parts else any(part.station == station for part in self.parts)

    def homes_at(self, station: str) -> tuple[str, ...]:
        """Its subsystems there."""
        if not self.parts:
            return self.homes if self.station == station else ()
        flows = [flow for part in self.parts if part.station == station for flow in part.flows]
        return tuple(self.plan.flows[flow].subsystem for flow in flows)

    def station_of(self, subsystem: str) -> str:
        """Where one of its flows is carried out."""
        flow = self.number_of(subsystem)
        return next((part.station for part in self.parts if flow in part.flows), self.station)

    def status(self, subsystem: str) -> FlowStatus:
        """Where a flow is."""
        return self.statuses.get(subsystem, FlowStatus())

    def with_status(self, subsystem: str, status: FlowStatus) -> "Run":
        """With a flow where it is now."""
        return replace(self, statuses={**self.statuses, subsystem: status})

    def number_of(self, subsystem: str) -> int | None:
        """Which flow of the plan lives in a subsystem; None: none."""
        return next((n for n, flow in enumerate(self.plan.flows) if flow.subsystem == subsystem), None)

    def action(self, flow: int, index: int) -> PlannedAction | None:
        """An action of the plan; None: there is none such."""
        actions = self.plan.flows[flow].actions if 0 <= flow < len(self.plan.flows) else ()
        if 0 <= index < len(actions):
            return actions[index]
        return None

    def step_at(self, subsystem: str, index: int) -> int:
        """The step of the application that an action belongs to; 0: none."""
        flow = self.number_of(subsystem)
        action = None if flow is None else self.action(flow, index)
        if action is not None and action.spot:
            return action.spot[0]
        return 0

    def actions_of(self, step: int) -> Iterator[tuple[int, int]]:
        """The actions of a step by flow and index, those of flows that are not nested first; of a branch all in it."""
        meant = self.belonging.meant(step)
        for is_nested in (False, True):
            for number, flow in enumerate(self.plan.flows):
                if (flow.parent is not None) is is_nested:
                    yield from ((number, at) for at, action in enumerate(flow.actions) if action.spot[:1] in meant)

    def has_loops(self, flow: int) -> bool:
        """Whether a flow can go round."""
        return any(isinstance(instruction, Again | Unless) for instruction in self.plan.flows[flow].program)

    def shown(self, **changes: Any) -> "Run":
        """With something else in what is shown."""
        return replace(self, view=structs.replace(self.view, **changes))

    def in_flow(self, subsystem: str, **changes: Any) -> "Run":
        """With something else shown of a flow."""
        flows = self.view.flows
        return self.shown(flows={**flows, subsystem: structs.replace(flows[subsystem], **changes)})

    def noted(self, text: Reason) -> "Run":
        """With one more note, said by a runtime; old ones are forgotten."""
        return self.shown(notes=(*self.view.notes, self.wording.with_icons(text))[-_MOST_NOTES:])

    def called(self, subsystem: str, index: int) -> str:
        """What an action is about, in the words of its icons; empty: there is none such."""
        flow = self.number_of(subsystem)
        action = None if flow is None else self.action(flow, index)
        return "" if action is None else self.wording.action(action)


_MOST_NOTES = 60
_AS_NAMED = IconWording()


def begun(
    doc: str, plan: Plan, number: int, at_s: float, belonging: StepMembership, wording: IconWording = _AS_NAMED
) -> Run:
    """A run that is about to begin; `at_s` is seconds since 1970."""
    flows = {
        flow.subsystem: FlowRunView(
            order,
            of=len(flow.actions),
            is_nested=flow.parent is not None,
            worlds=driven_worlds(flow),
            guest=guest_of((flow,)),
        )
        for order, flow in enumerate(plan.flows)
    }
    of = sum(len(flow.actions) for flow in plan.flows)
    view = RunView(
        doc, plan.application, number, began_at_s=at_s, flows=flows, of=of, steps_by_task=_steps_by_task(plan)
    )
    return Run(view, plan, FlowIndex.of(plan), belonging, wording.hearing(plan))


def _steps_by_task(plan: Plan) -> dict[str, tuple[int, ...]]:
    """The steps of the application in which each task is ON, in the order of the plan, by `SUBSYSTEM/TASK`."""
    steps: dict[str, dict[int, None]] = {}
    for flow in plan.flows:
        for action in flow.actions:
            for task in action.tasks if action.spot else ():
                steps.setdefault(f"{flow.subsystem}/{task}", {})[action.spot[0]] = None
    return {address: tuple(numbers) for address, numbers in steps.items()}
