"""Sequences a flow: puts its steps, nested applications and branches in line, as the program the engine executes.

Loops become jumps (§4.4.7.3), conditional applications choices (§4.3.2), nested parallel applications forks (D13).
What is at fault is passed over here: readiness tells it, and nothing runs.
"""

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from onika.model.application import Action, AppFlow, Application, Branch, Icon, actions, wanted_targets
from onika.model.rules.loop import Loop, loops
from onika.model.rules.nesting import DEEPEST, MOST
from onika.model.syntax import Syntax
from onika.wire.plan import Again, Choose, Do, Fork, Halt, Instruction, Join, Jump, Meet, Rest, Unless


@dataclass(frozen=True, slots=True)
class SequencedAction:
    """An action in line: its icon, its targets, the file it stands in and the applications around it."""

    icon: Icon
    targets: tuple[Icon, ...]
    file: str
    within: tuple[str, ...]
    is_noop: bool
    spot: tuple[int, ...] = ()
    """Its line, behind those of the icons that run the applications around it, outermost first."""


@dataclass(slots=True)
class FlowSequence:
    """One flow of the plan: its actions and its program."""

    subsystem: str
    parent: int | None = None
    doings: list[SequencedAction] = field(default_factory=list)
    program: list[Instruction] = field(default_factory=list)

    def put(self, *instructions: Instruction) -> None:
        """Add to the program."""
        self.program += instructions

    @property
    def here(self) -> int:
        """The place of the next instruction."""
        return len(self.program)


@dataclass(frozen=True, slots=True)
class _Context:
    """Where a flow stands: its file, the applications around it, what fills its holes, where its tags meet."""

    file: str
    path: tuple[str, ...]
    """The names of the applications around it, for recursion."""
    within: tuple[str, ...]
    fills: Mapping[str, Icon]
    scope: str | None
    """The instance of the parallel application whose flow it is; None: its tags meet nobody (reading 27)."""
    spot: tuple[int, ...] = ()
    """The lines of the icons that run the applications around it."""


class Sequencer:
    """Puts an application in line. `file_of` gives the file of a nested application."""

    def __init__(self, syntax: Syntax, applications: Mapping[str, Application], file_of: Callable[[str], str]) -> None:
        self._syntax = syntax
        self._applications = applications
        self._file_of = file_of
        self._instances: Counter[str] = Counter()
        self._count = 0
        self.lines: list[FlowSequence] = []

    def sequence(self, application: Application, file: str) -> list[FlowSequence]:
        """Every flow, those of nested parallel applications behind those of the application itself."""
        flows = application.flows if application.is_parallel else application.flows[:1]
        scope = "" if application.is_parallel and len(flows) > 1 else None
        self.lines = [FlowSequence(f"flow{number}") for number in range(len(flows))]
        context = _Context(file, (application.name,), (), {}, scope)
        for number, flow in enumerate(flows):
            self._flow(number, flow, context)
            self.lines[number].put(Halt())
        return self.lines

    def _flow(self, number: int, flow: AppFlow, context: _Context) -> None:
        """One flow, its actions one after the other, its loops closed."""
        line = self.lines[number]
        every = actions(flow, self._syntax)
        doing = {action.position: action for action in every}
        own_loops = [
            loop for loop in loops(flow, every) if doing.keys() >= {loop.start, loop.end}
        ]  # not at a stray target
        rounds = _Rounds(line, [(self._unique(_join(context, loop.tag)), loop) for loop in own_loops])
        for position, step in enumerate(flow.steps):
            if isinstance(step, Branch):
                self._branch(number, step.flows, step.conditions, context, f"branch at line {step.line}")
            elif position in doing and self._count < MOST:
                rounds.open(position)
                self._action(number, doing[position], context)
                rounds.close(position, step.while_if if isinstance(step, Icon) else "")

    def _action(self, number: int, action: Action, context: _Context) -> None:
        line, icon = self.lines[number], action.icon
        if icon.synch_tag is not None and context.scope is not None:
            line.put(Meet(f"{context.scope} {icon.synch_tag}".strip()))
        kind = self._syntax.acting(icon.onikon.type)
        targets = _targets(action, context, self._syntax)
        if kind is None or not kind.is_application:
            self._count += 1
            line.put(Do(len(line.doings)))
            is_noop = kind is not None and kind.is_noop
            spot = (*context.spot, icon.line)
            line.doings.append(SequencedAction(icon, targets, context.file, context.within, is_noop, spot))
            line.put(*([Rest(len(line.doings) - 1, icon.marker_if)] if icon.marker else []))
            return
        self._nested(number, icon, targets, context)
        line.put(*([Rest(-1, icon.marker_if)] if icon.marker else []))

    def _nested(self, number: int, icon: Icon, targets: tuple[Icon, ...], context: _Context) -> None:
        name = icon.onikon.name
        application = self._applications.get(name)
        if application is None or name in context.path or len(context.path) > DEEPEST:
            return  # readiness tells
        fills = {plain_type(target.onikon.type): target for target in targets}
        is_parallel = application.is_parallel and len(application.flows) > 1
        scope = self._unique(_join(context, name)) if is_parallel else None
        spot = (*context.spot, icon.line)
        inner = _Context(self._file_of(name), (*context.path, name), (*context.within, name), fills, scope, spot)
        if is_parallel:
            self._parallel(number, application, inner)
        elif len(application.flows) == 1:
            self._flow(number, application.flows[0], inner)
        else:
            self._branch(number, application.flows, (), inner, name)

    def _branch(
        self, number: int, flows: Sequence[AppFlow], conditions: tuple[str, ...], context: _Context, name: str
    ) -> None:
        """One of several flows, then on behind them all; nothing where there is none."""
        line = self.lines[number]
        if not flows:
            return
        choice = line.here
        line.put(Choose((choice,)))  # where to is known when all are in line
        to, ends = [], []
        for flow in flows:
            to.append(line.here)
            self._flow(number, flow, context)
            ends.append(line.here)
            line.put(Jump(choice))
        line.program[choice] = Choose(tuple(to), conditions, name)
        for end in ends:
            line.program[end] = Jump(line.here)

    def _parallel(self, number: int, application: Application, context: _Context) -> None:
        """Its flow 0 goes on here, the others on subsystems of their own."""
        line = self.lines[number]
        others = [self._child(number, which) for which in range(1, len(application.flows))]
        fork = line.here
        line.put(Halt())
        self._flow(number, application.flows[0], context)
        line.put(Join(tuple(others)))
        begun = []
        for child, flow in zip(others, application.flows[1:], strict=True):
            begun.append((child, self.lines[child].here))
            self._flow(child, flow, context)
            self.lines[child].put(Halt())
        line.program[fork] = Fork(tuple(begun), application.name)

    def _child(self, parent: int, which: int) -> int:
        """The flow that serves as the n-th other one of a flow's nested parallel applications, one after the other."""
        subsystem = f"{self.lines[parent].subsystem}.{which}"
        for number, line in enumerate(self.lines):
            if line.subsystem == subsystem:
                return number
        self.lines.append(FlowSequence(subsystem, parent))
        return len(self.lines) - 1

    def _unique(self, name: str) -> str:
        self._instances[name] += 1
        return name if self._instances[name] == 1 else f"{name}#{self._instances[name]}"


class _Rounds:
    """The loops of one flow, each with its name, while it is put in line."""

    def __init__(self, line: FlowSequence, loops: Sequence[tuple[str, Loop]]) -> None:
        self._line = line
        self._loops = loops
        self._starts: dict[str, int] = {}
        self._tests: dict[str, tuple[int, str]] = {}

    def open(self, position: int) -> None:
        """The action at this position comes next."""
        for name, loop in self._loops:
            if loop.start == position:
                self._starts[name] = self._line.here

    def close(self, position: int, condition: str) -> None:
        """The action at this position is in line."""
        line = self._line
        for name, loop in self._loops:
            if position == loop.test and not loop.is_top:
                line.put(Again(name, self._starts[name], condition))
            elif position == loop.test:
                self._tests[name] = (line.here, condition)
                line.put(Unless(name, line.here, condition))
            elif position == loop.end:
                at, tested = self._tests[name]
                line.put(Jump(self._starts[name], name))
                line.program[at] = Unless(name, line.here, tested)


def _targets(action: Action, context: _Context, syntax: Syntax) -> tuple[Icon, ...]:
    """The targets of an action; what fills a hole comes from outside, by its type (reading 32)."""
    wanted = wanted_targets(action.icon.onikon, syntax)
    targets = (
        target if isinstance(target, Icon) else context.fills.get(plain_type(kind))
        for target, kind in zip(action.targets, wanted, strict=False)
    )
    return tuple(icon for icon in targets if icon is not None)


def plain_type(name: str) -> str:
    """The name of a type, to be compared (reading 37)."""
    return " ".join(name.lower().split())


def _join(context: _Context, name: str) -> str:
    return "/".join((*context.within, name))
