"""An application laid out for the rules: its flows, those of branches too, each with its actions (requirement E01)."""

from collections.abc import Iterator
from dataclasses import dataclass

from onika.model.application import Action, AppFlow, Application, Branch, Hole, Icon, Step, actions, flows_within
from onika.model.syntax import Syntax
from onika.words.fault import Fault, Place


@dataclass(frozen=True, slots=True)
class Passage:
    """A flow, or a flow of a branch; `path` names it within the application, `number` the flow it belongs to."""

    path: str
    number: int
    flow: AppFlow
    actions: tuple[Action, ...]
    is_inner: bool = False
    """Whether it is a flow of a branch."""


@dataclass(frozen=True, slots=True)
class Outline:
    """An application with its passages in order; `file` names it in messages, `is_nested` that another one runs it."""

    application: Application
    file: str
    is_nested: bool
    passages: tuple[Passage, ...]

    @classmethod
    def of(cls, application: Application, syntax: Syntax, file: str, *, is_nested: bool = False) -> "Outline":
        """The outline of an application."""
        passages = tuple(
            Passage(path, number, inner, actions(inner, syntax), inner is not flow)
            for number, flow in enumerate(application.flows)
            for path, inner in flows_within(flow, f"flow {number}")
        )
        return cls(application, file, is_nested, passages)

    def actions(self) -> Iterator[tuple[Passage, Action]]:
        """Every action with its passage."""
        for passage in self.passages:
            for action in passage.actions:
                yield passage, action

    def of_flow(self, number: int) -> Iterator[Passage]:
        """The passages of one flow: itself, then those of its branches."""
        return (passage for passage in self.passages if passage.number == number)

    def where(self, passage: Passage) -> str:
        """The name of a passage in texts: `flow 1, step 3, branch 0`, of which application if that is nested."""
        return f"{passage.path} of `{self.application.name}`" if self.is_nested else passage.path

    def at(self, passage: Passage, position: int) -> str:
        """The name of a step in texts: `` `there`, step 3 of flow 0``."""
        step = passage.flow.steps[position]
        return f"{shown(step)}, step {position} of {self.where(passage)}"

    def place(self, step: Step | None = None) -> Place:
        """The line at which a step stands, where it was read from a file; without one the whole file."""
        return Place(self.file, step.line if step else 0)

    def fault(self, step: Step | None, expected: str, found: str) -> Fault:
        """What keeps the application from being run."""
        return Fault(self.place(step), expected, found, "the application is not run")

    def note(self, step: Step | None, expected: str, found: str, instead: str) -> Fault:
        """What is worth knowing."""
        return Fault(self.place(step), expected, found, instead, is_note=True)


def shown(step: Step) -> str:
    """A step in a text."""
    if isinstance(step, Icon):
        return f"`{step.onikon.name}`"
    return "a hole" if isinstance(step, Hole) else f"a branch of {len(step.flows)}" if isinstance(step, Branch) else ""
