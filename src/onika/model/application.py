"""An application: one or more flows of icons and holes (dissertation §5.5, §A.4)."""

from dataclasses import dataclass, field

from onika.model.onikon import Onikon
from onika.model.syntax import Syntax


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


@dataclass(frozen=True, slots=True)
class Hole:
    """A gap between two icons whose edges do not fit."""

    line: int = field(default=0, compare=False)
    """As that of an icon."""
    kept: str = ""
    """The lines of the target of unknown type that stands there, which are written again as they are."""


@dataclass(frozen=True, slots=True)
class Branch:
    """Flows of which one runs, in line (requirement D13); an inner flow may be empty.

    Without conditions the flow is chosen as that of a nested conditional application: by the return value of the
    action before. With conditions, one fewer than flows, the first that holds chooses its flow, else the last one runs.
    """

    flows: tuple["AppFlow", ...]
    conditions: tuple[str, ...] = ()
    line: int = field(default=0, compare=False)


Step = Icon | Hole | Branch


@dataclass(frozen=True, slots=True)
class AppFlow:
    """A sequence of steps; the start and end icons are implied (decision 46)."""

    steps: tuple[Step, ...]


@dataclass(frozen=True, slots=True)
class Application:
    """What an `.appl` file says; with several flows it is parallel or else conditional."""

    name: str
    is_parallel: bool
    flows: tuple[AppFlow, ...]

    @property
    def has_hole(self) -> bool:
        """Whether it is incomplete."""
        return any(isinstance(step, Hole) for flow in self.flows for step in flow.steps)


def actions(flow: AppFlow, syntax: Syntax) -> tuple[tuple[int, Icon, Icon | None], ...]:
    """The actions of a flow: position of the job or application among the steps, its icon, its target's icon.

    The target is None where the action takes none or none follows it. Holes and stray targets are no actions.
    """
    steps = flow.steps
    found = []
    for position, step in enumerate(steps):
        kind = syntax.acting(step.onikon.type) if isinstance(step, Icon) else None
        if isinstance(step, Icon) and kind and kind.is_action:
            after = steps[position + 1] if position + 1 < len(steps) else None
            takes = kind.needs_target and isinstance(after, Icon) and is_target(after, syntax)
            found.append((position, step, after if takes and isinstance(after, Icon) else None))
    return tuple(found)


def is_target(icon: Icon, syntax: Syntax) -> bool:
    """Whether an icon is a target of a known type."""
    kind = syntax.find(icon.onikon.type)
    return kind is not None and kind.is_target
