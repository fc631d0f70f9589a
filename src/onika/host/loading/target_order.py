"""The targets of an arm in the order in which it goes to them, as far as that is certain beforehand (law 26).

A relative target begins where the one before it ended. That one is known where both are carried out one behind the
other, and nothing between them moves the arm; behind a loop or a choice nobody knows.
"""

from collections.abc import Sequence
from typing import Any

from onika.wire.plan import Do, Meet, PlannedFlow, Rest
from onika.wire.request import TargetValues

RELATIVE = "relative object"
"""The type of target that says how far the tool goes from where it is (requirement D25)."""

UNKNOWN: tuple[str, list[Any]] = ("", [])
"""Stands between two targets where nobody knows what the arm does between them."""

Question = tuple[str, list[Any]]


def in_order(flow: PlannedFlow, robot: str, targets: Sequence[TargetValues]) -> tuple[list[Question], list[int]]:
    """What a robot's module is asked about these targets of its, and for each target which question is about it."""
    if all(target.kind != RELATIVE for target in targets):
        return [(target.kind, list(target.values)) for target in targets], list(range(len(targets)))
    questions: list[Question] = []
    places: dict[int, int] = {}
    by_action: dict[int, list[int]] = {}
    for k, target in enumerate(targets):
        by_action.setdefault(target.action, []).append(k)
    for action in _actions(flow, robot):
        mine = by_action.pop(action, None) if action is not None else None
        for k in mine or ():
            places[k] = len(questions)
            questions.append((targets[k].kind, list(targets[k].values)))
        if not mine:
            questions.append(UNKNOWN)
    for k in (k for rest in by_action.values() for k in rest):  # in no program that is carried out
        questions.append(UNKNOWN)
        places[k] = len(questions)
        questions.append((targets[k].kind, list(targets[k].values)))
    return questions, [places[k] for k in range(len(targets))]


def _actions(flow: PlannedFlow, robot: str) -> list[int | None]:
    """The actions that move the robot, in order; None where something else may come between two of them."""
    if not flow.program:
        return [number for number, action in enumerate(flow.actions) if robot in action.tasks]
    order: list[int | None] = []
    for instruction in flow.program:
        if isinstance(instruction, Do):
            if robot in flow.actions[instruction.action].tasks:
                order.append(instruction.action)
        elif not isinstance(instruction, Meet | Rest):
            order.append(None)
    return order
