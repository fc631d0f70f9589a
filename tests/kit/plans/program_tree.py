"""Programs for tests as trees: actions, loops, branches, nested parallel applications; made into plans in one call."""

from dataclasses import dataclass, field

from kit.plans.build import job, plan
from onika.engine.engine import Engine
from onika.wire.plan import (
    Again,
    Choose,
    Do,
    Fork,
    Halt,
    Instruction,
    Join,
    Jump,
    Meet,
    Plan,
    PlannedAction,
    PlannedFlow,
    Rest,
    Unless,
)


@dataclass(frozen=True, slots=True)
class Act:
    """An action; its first task is its trigger. A no-op has no tasks."""

    tag: str = ""
    tasks: tuple[str, ...] = ("move", "arm")
    is_noop: bool = False
    breakpoint: str | None = None
    """The condition under which the flow rests after it; empty: always; none: never."""


@dataclass(frozen=True, slots=True)
class Loop:
    """A loop: bottom-test, whose last step is the test, or top-test, whose first step is."""

    name: str
    body: "tuple[Node, ...]"
    is_top: bool = False
    condition: str = ""


@dataclass(frozen=True, slots=True)
class Pick:
    """Flows of which one is taken, by the value before or by conditions (one fewer)."""

    flows: "tuple[tuple[Node, ...], ...]"
    conditions: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Side:
    """A nested parallel application: flow 0 goes on in the flow it stands in, the others beside it."""

    flows: "tuple[tuple[Node, ...], ...]"


Node = Act | Loop | Pick | Side
Tree = tuple[Node, ...]


def planned(*trees: Tree) -> Plan:
    """The plan of parallel flows; actions are numbered as they stand, flow i is the subsystem `flow{i}`."""
    builders = [_Builder(f"flow{number}", None) for number in range(len(trees))]
    for number, tree in enumerate(trees):
        builders[number].lay(tree, number, builders)
        builders[number].program.append(Halt())
    return Plan("test", tuple(builder.flow() for builder in builders), ())


def engine_for(made: Plan, passive: frozenset[tuple[int, str]] = frozenset(), **more: object) -> Engine:
    """An engine for it: the first task of each action is its trigger; tasks rank as they are first named."""
    return Engine(
        made,
        triggers={
            (flow, index): action.tasks[0] if action.tasks else None
            for flow, planned_flow in enumerate(made.flows)
            for index, action in enumerate(planned_flow.actions)
        },
        passive=passive,
        ranks={
            (flow, task.name): rank
            for flow, planned_flow in enumerate(made.flows)
            for rank, task in enumerate(planned_flow.tasks)
        },
        **more,  # type: ignore[arg-type]
    )


def acts(tree: Tree) -> list[Act]:
    """The actions that a flow itself carries out, in their order."""
    own_acts: list[Act] = []
    for node in tree:
        match node:
            case Act():
                own_acts.append(node)
            case Loop():
                own_acts += acts(node.body)
            case Pick():
                own_acts += [act for flow in node.flows for act in acts(flow)]
            case Side():
                own_acts += acts(node.flows[0])
    return own_acts


@dataclass
class _Builder:
    """One flow of the plan while it is laid out."""

    subsystem: str
    parent: int | None
    program: list[Instruction] = field(default_factory=list)
    actions: list[Act] = field(default_factory=list)

    def lay(self, tree: Tree, number: int, builders: "list[_Builder]") -> None:
        for node in tree:
            match node:
                case Act():
                    self._act(node)
                case Loop() if node.is_top:
                    self._top(node, number, builders)
                case Loop():
                    first = len(self.program)
                    self.lay(node.body, number, builders)
                    self.program.append(Again(node.name, first, node.condition))
                case Pick():
                    self._pick(node, number, builders)
                case Side():
                    self._side(node, number, builders)

    def flow(self) -> PlannedFlow:
        jobs = [job(*act.tasks, trigger=act.tasks[0] if act.tasks else None) for act in self.actions]
        made = plan(jobs).flows[0]
        described = tuple(map(_action, made.actions, self.actions))
        return PlannedFlow(self.subsystem, made.tasks, described, tuple(self.program), self.parent)

    def _act(self, act: Act) -> None:
        index = len(self.actions)
        self.actions.append(act)
        self.program += [Meet(act.tag)] if act.tag else []
        self.program.append(Do(index))
        self.program += [Rest(index, act.breakpoint)] if act.breakpoint is not None else []

    def _top(self, loop: Loop, number: int, builders: "list[_Builder]") -> None:
        first = len(self.program)
        self.lay(loop.body[:1], number, builders)
        test = len(self.program)
        self.program.append(Halt())
        self.lay(loop.body[1:], number, builders)
        self.program.append(Jump(first, loop.name))
        self.program[test] = Unless(loop.name, len(self.program), loop.condition)

    def _pick(self, pick: Pick, number: int, builders: "list[_Builder]") -> None:
        start = len(self.program)
        self.program.append(Halt())
        to, ends = [], []
        for flow in pick.flows:
            to.append(len(self.program))
            self.lay(flow, number, builders)
            ends.append(len(self.program))
            self.program.append(Halt())
        self.program[start] = Choose(tuple(to), pick.conditions)
        for end in ends:
            self.program[end] = Jump(len(self.program))

    def _side(self, side: Side, number: int, builders: "list[_Builder]") -> None:
        children = []
        for flow in side.flows[1:]:
            builders.append(_Builder(f"{self.subsystem}.{len(builders)}", number))
            children.append(len(builders) - 1)
            builders[-1].lay(flow, len(builders) - 1, builders)
            builders[children[-1]].program.append(Halt())
        self.program.append(Fork(tuple((child, 0) for child in children)))
        self.lay(side.flows[0], number, builders)
        self.program.append(Join(tuple(children)))


def _action(made: PlannedAction, act: Act) -> PlannedAction:
    return PlannedAction(
        name=made.name,
        job=made.job,
        target=made.target,
        place=made.place,
        tasks=made.tasks,
        rates=made.rates,
        arguments=made.arguments,
        synch_tag=act.tag or None,
        marker=act.breakpoint is not None,
        is_noop=act.is_noop,
    )
