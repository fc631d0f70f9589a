"""A run that is to solve a puzzle: what the runtime tells at its end, and what came of it (requirements G10, H07)."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from onika.desk.plan.flow_index import variables
from onika.desk.run.value_text import in_a_line
from onika.model.puzzle import Puzzle
from onika.wire import event
from onika.wire.plan import Plan
from onika.wire.view import GoalView, PuzzleResultView, RunView
from onika.words.condition import Condition
from onika.words.reason import NOTHING, Reason

_FLOW = "flow"


@dataclass(frozen=True, slots=True)
class PuzzleAttempt:
    """A run for a puzzle."""

    puzzle: Puzzle
    addresses: Mapping[str, str]
    """Where the variable of each condition is, by the text of the condition; what no task has is left out."""
    actions: int
    uncounted: Reason = NOTHING
    """Why the run does not count, as far as that was known when it began."""

    @classmethod
    def of(cls, puzzle: Puzzle, plan: Plan, uncounted: Reason) -> "PuzzleAttempt":
        """The attempt of a plan, in the subsystems in which its flows live."""
        conditions = map(Condition.parse, puzzle.expectations)
        placed = {condition.text: _address(condition, plan) for condition in conditions}
        addresses = {text: address for text, address in placed.items() if address}
        actions = sum(len(flow.actions) for flow in plan.flows)
        return cls(puzzle, addresses, actions, uncounted)

    @property
    def watch(self) -> tuple[str, ...]:
        """What the runtime shall read at the end."""
        return tuple(dict.fromkeys(self.addresses.values()))

    def result(self, run: RunView, told: event.Result) -> PuzzleResultView:
        """What came of it; the run is as it is shown at its end."""
        goals = tuple(self._goal(text, told.values) for text in self.puzzle.expectations)
        uncounted = self.uncounted or _intervention(run)
        is_solved = told.completed and not uncounted and all(goal.is_met for goal in goals)
        return PuzzleResultView(
            puzzle=self.puzzle.name,
            goals=goals,
            is_solved=is_solved,
            uncounted=uncounted,
            stars=self.puzzle.stars(self.actions, told.runtime_s) if is_solved else 0,
            actions=self.actions,
            took_s=told.runtime_s,
        )

    def _goal(self, text: str, values: Mapping[str, Any]) -> GoalView:
        condition = Condition.parse(text)
        address = self.addresses.get(text, "")
        here = {condition.address: values[address]} if address in values else {}
        found = condition.value_of(here)
        return GoalView(text, condition.holds(here), _shown(found))


def _shown(found: Any) -> str:
    """A value for people, without the dust of computation."""
    if found is None:
        return ""
    return in_a_line(round(found, 4) + 0.0 if isinstance(found, float) else found)


def _intervention(run: RunView) -> Reason:
    """Whether somebody has left out an action of it."""
    is_left = any(step.state == "left" for step in run.steps.values())
    return Reason.of("run.puzzle_left_out") if is_left and run.is_completed else NOTHING


def _address(condition: Condition, plan: Plan) -> str:
    """`SUBSYSTEM/NAME` of a condition; flows are called `flow0`, `flow1` wherever they live. Empty: no task has it."""
    flow, slash, name = condition.address.rpartition("/")
    for number, planned in enumerate(plan.flows):
        is_meant = not slash or flow == f"{_FLOW}{number}"
        if is_meant and name in variables(planned):
            return f"{planned.subsystem}/{name}"
    return ""
