"""Which steps of an application belong together: a target to its action, what stands in a branch to the branch."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from onika.model.application import AppFlow, Application, Branch, Icon, Step, actions
from onika.model.syntax import Syntax


@dataclass(frozen=True, slots=True)
class StepMembership:
    """The steps of an application by their numbers, as it was when it was looked at."""

    owners: Mapping[int, int]
    """Of each target, and of the hole for one: its action."""
    inside: Mapping[int, frozenset[int]]
    """Of each branch: the steps in it, at any depth."""

    @classmethod
    def of(cls, application: Application, syntax: Syntax) -> "StepMembership":
        """Those of an application whose steps have numbers."""
        owners: dict[int, int] = {}
        inside: dict[int, frozenset[int]] = {}
        for flow in application.flows:
            _look(flow, syntax, owners, inside)
        return cls(owners, inside)

    def targets(self) -> dict[int, tuple[int, ...]]:
        """Of each action that has some: its targets and the holes for them, in order."""
        inside: dict[int, tuple[int, ...]] = {}
        for target, action in self.owners.items():
            inside[action] = (*inside.get(action, ()), target)
        return inside

    def meant(self, step: int) -> frozenset[tuple[int, ...]]:
        """The actions that are meant by a step, each as the beginning of a spot."""
        return frozenset((member,) for member in self.inside.get(step, frozenset((self.owners.get(step, step),))))


def _look(flow: AppFlow, syntax: Syntax, owners: dict[int, int], inside: dict[int, frozenset[int]]) -> None:
    for action in actions(flow, syntax):
        for at in action.positions:
            owners[flow.steps[at].number] = action.icon.number
    for step in flow.steps:
        if isinstance(step, Branch):
            inside[step.number] = frozenset(_numbers(step.flows))
            for inner in step.flows:
                _look(inner, syntax, owners, inside)


def _numbers(flows: tuple[AppFlow, ...]) -> Iterator[int]:
    for flow in flows:
        for step in flow.steps:
            yield step.number
            if isinstance(step, Branch):
                yield from _numbers(step.flows)


def icons(application: Application) -> Iterator[Icon]:
    """Every icon of an application, those in branches behind those before the branch."""
    for flow in application.flows:
        yield from _icons(flow.steps)


def _icons(steps: tuple[Step, ...]) -> Iterator[Icon]:
    for step in steps:
        if isinstance(step, Icon):
            yield step
        elif isinstance(step, Branch):
            for flow in step.flows:
                yield from _icons(flow.steps)
