"""An application: one or more flows of icons and holes (dissertation §5.5, §A.4)."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from onika.model.onikon import Onikon
from onika.model.syntax import Syntax, same_type


@dataclass(frozen=True, slots=True)
class Icon:
    """An onikon placed in a flow, with its marks (requirement D06)."""

    onikon: Onikon
    marker: bool = False
    """Whether the flow pauses after it."""
    synch_tag: str | None = None
    while_tag: str | None = None
    while_test: bool = False
    """Whether its return value decides the loop of `while_tag`."""
    marker_if: str = ""
    """The condition under which the flow pauses after it (`words.condition`); empty: always."""
    while_if: str = ""
    """The condition while which the loop goes on, in place of the test's return value; empty: the return value."""
    line: int = field(default=0, compare=False)
    """Where it stood in the file it was read from, for messages; 0 elsewhere."""
    number: int = field(default=0, compare=False)
    """What it is called while it is open, one after the other from 1; 0 elsewhere."""


@dataclass(frozen=True, slots=True)
class Hole:
    """A gap between two icons whose edges do not fit."""

    line: int = field(default=0, compare=False)
    """As that of an icon."""
    kept: str = ""
    """The lines of the target of unknown type that stands there, which are written again as they are."""
    number: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True)
class Branch:
    """Flows of which one runs, in line (requirement D13); an inner flow may be empty.

    Without conditions the flow is chosen as that of a nested conditional application: by the return value of the
    action before. With conditions, one fewer than flows, the first that holds chooses its flow, else the last one runs.
    """

    flows: tuple["AppFlow", ...]
    conditions: tuple[str, ...] = ()
    line: int = field(default=0, compare=False)
    number: int = field(default=0, compare=False)


Step = Icon | Hole | Branch


@dataclass(frozen=True, slots=True)
class AppFlow:
    """A sequence of steps; the start and end icons are implied (reading 46)."""

    steps: tuple[Step, ...]


@dataclass(frozen=True, slots=True)
class Application:
    """What an `.appl` file says; with several flows it is parallel or else conditional."""

    name: str
    is_parallel: bool
    flows: tuple[AppFlow, ...]

    @property
    def has_hole(self) -> bool:
        """Whether it is incomplete, in a branch too."""
        return any(isinstance(step, Hole) for _, flow in every_flow(self) for step in flow.steps)


class Action(NamedTuple):
    """A job or application in a flow: its position among the steps, its icon and its targets.

    `targets` stand in the order of `wanted_targets`, as many as are there; where one is open stands its hole, and a
    hole in which several are open stands for each of them.
    """

    position: int
    icon: Icon
    targets: tuple[Icon | Hole, ...] = ()

    @property
    def positions(self) -> tuple[int, ...]:
        """The position of each of its targets; one hole may stand for several."""
        at, targets = self.position, []
        for number, target in enumerate(self.targets):
            at += not (number and isinstance(target, Hole) and target is self.targets[number - 1])
            targets.append(at)
        return tuple(targets)

    @property
    def end(self) -> int:
        """The position behind its last step."""
        return (self.positions or (self.position,))[-1] + 1


def actions(flow: AppFlow, syntax: Syntax) -> tuple[Action, ...]:
    """The actions of a flow, without those of its branches; other holes and stray targets are no actions."""
    steps = flow.steps
    paths = []
    for position, step in enumerate(steps):
        if isinstance(step, Icon):
            kind = syntax.acting(step.onikon.type)
            if kind and kind.is_action:
                wanted = wanted_targets(step.onikon, syntax)
                paths.append(Action(position, step, _targets(steps, position + 1, wanted, syntax)))
    return tuple(paths)


def wanted_targets(onikon: Onikon, syntax: Syntax) -> tuple[str, ...]:
    """The types of the targets an action takes, in order: by its own type, then its further ones.

    Empty for complete actions, for no-ops and for what is no action of a known type.
    """
    kind = syntax.find(onikon.type)
    if kind and kind.needs_target:
        return (syntax.object_of(kind), *onikon.more_targets)
    return ()


def is_target(icon: Icon, syntax: Syntax) -> bool:
    """Whether an icon is a target of a known type."""
    kind = syntax.find(icon.onikon.type)
    return kind is not None and kind.is_target


def every_flow(application: Application) -> Iterator[tuple[str, AppFlow]]:
    """All flows, those of branches behind the one they stand in, each with its path: `flow 1, step 3, branch 0`."""
    for number, flow in enumerate(application.flows):
        yield from flows_within(flow, f"flow {number}")


def flows_within(flow: AppFlow, path: str) -> Iterator[tuple[str, AppFlow]]:
    """A flow and all flows of its branches, at any depth; `path` is that of the flow itself."""
    yield path, flow
    for position, step in enumerate(flow.steps):
        if isinstance(step, Branch):
            for number, inner in enumerate(step.flows):
                yield from flows_within(inner, f"{path}, step {position}, branch {number}")


def without_breakpoints(application: Application) -> Application:
    """The same application with no breakpoint in it, in a branch neither."""
    return _with_steps(application, lambda icon: replace(icon, marker=False, marker_if=""))


def with_numbers_as_lines(application: Application) -> Application:
    """The same application, each step at the line of its number: what is told of a line is told of a step."""
    return _with_steps(application, lambda icon: replace(icon, line=icon.number), by_number=True)


def _with_steps(application: Application, change: Callable[[Icon], Icon], *, by_number: bool = False) -> Application:
    """With every icon changed; `by_number`: holes and branches stand at the lines of their numbers too."""

    def changed(step: Step) -> Step:
        if isinstance(step, Icon):
            return change(step)
        line = step.number if by_number else step.line
        if isinstance(step, Hole):
            return replace(step, line=line)
        return replace(step, line=line, flows=tuple(AppFlow(tuple(map(changed, flow.steps))) for flow in step.flows))

    flows = tuple(AppFlow(tuple(map(changed, flow.steps))) for flow in application.flows)
    return replace(application, flows=flows)


def _targets(steps: tuple[Step, ...], at: int, wanted: tuple[str, ...], syntax: Syntax) -> tuple[Icon | Hole, ...]:
    """What stands from step `at` on for the targets an action wants."""
    parts: list[Icon | Hole] = []
    while len(parts) < len(wanted) and at < len(steps):
        step = steps[at]
        at += 1
        if isinstance(step, Hole):
            after = steps[at] if at < len(steps) else None
            parts += [step] * _open(wanted[len(parts) :], after, syntax)
        elif isinstance(step, Icon) and is_target(step, syntax):
            parts.append(step)
        else:
            break
    return tuple(parts)


def _open(wanted: tuple[str, ...], after: Step | None, syntax: Syntax) -> int:
    """How many of the `wanted` a hole stands for: all before the one that follows it, else all."""
    if isinstance(after, Hole):
        return 1
    if not (isinstance(after, Icon) and is_target(after, syntax)):
        return len(wanted)
    kind = after.onikon.type
    return next((at for at, type_name in enumerate(wanted) if at and same_type(type_name, kind)), 1)
