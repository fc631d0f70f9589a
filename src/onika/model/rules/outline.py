"""An application laid out for the rules: its flows, those of branches too, each with its actions (requirement E01)."""

from collections.abc import Iterator
from dataclasses import dataclass

from onika.model.application import Action, AppFlow, Application, Branch, Icon, Step, actions, flows_within
from onika.model.syntax import Syntax
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class Passage:
    """A flow, or a flow of a branch; `path` names it within the application, `number` the flow it belongs to."""

    path: str
    number: int
    flow: AppFlow
    actions: tuple[Action, ...]
    is_inner: bool = False
    """Whether it is a flow of a branch."""

    @property
    def named(self) -> Reason:
        """Its name in texts."""
        if self.is_inner:
            return Reason.plain(self.path)
        return Reason.of("rules.flow", number=self.number)


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

    def where(self, passage: Passage) -> Reason:
        """The name of a passage in texts: `flow 1, step 3, branch 0`, of which application if that is nested."""
        flow = passage.named
        if self.is_nested:
            return Reason.of("rules.flow_within", flow=flow, application=self.application.name)
        return flow

    def at(self, passage: Passage, position: int) -> Reason:
        """The name of a step in texts: `` `there`, step 3 of flow 0``."""
        step = shown(passage.flow.steps[position])
        return Reason.of("rules.at", step=step, position=position, flow=self.where(passage))

    def place(self, step: Step | None = None) -> Place:
        """The line at which a step stands, where it was read from a file; without one the whole file."""
        return Place(self.file, step.line if step else 0)

    def fault(self, step: Step | None, reason: Reason) -> Fault:
        """What keeps the application from being run."""
        return Fault(self.place(step), reason, NOT_RUN)

    def note(self, step: Step | None, reason: Reason, instead: Reason) -> Fault:
        """What is worth knowing."""
        return Fault(self.place(step), reason, instead, is_note=True)


def shown(step: Step) -> Reason:
    """A step in a text."""
    if isinstance(step, Icon):
        return Reason.of("rules.icon", name=step.onikon.name)
    if isinstance(step, Branch):
        return Reason.of("rules.branch_of", count=len(step.flows))
    return Reason.of("rules.hole")
