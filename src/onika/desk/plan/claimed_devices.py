"""Devices that two flows of a plan would move, as far as the code of modules says so without being executed (law 16).

A runtime finds the same when it prepares the plan, and more: a class may learn from another that it moves a device.
"""

import ast
from collections.abc import Iterator
from functools import lru_cache

from onika.model.planned import task_of
from onika.model.rules.agreement import device_of
from onika.wire.plan import Plan, PlannedTask
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import Reason


def faults(plan: Plan) -> Iterator[Fault]:
    """One for each task that moves a device which a task of an earlier flow moves; those of one flow are told else."""
    sources = {code.digest: code.source for code in plan.code}
    owners: dict[str, tuple[int, PlannedTask]] = {}
    for number, flow in enumerate(plan.flows):
        for task in flow.tasks:
            device = device_of(task_of(task))
            if not device or not moves_a_device(sources.get(task.digest, "")):
                continue
            first, other = owners.setdefault(device, (number, task))
            if first != number:
                reason = Reason.of("host.device_claimed", device=device, other=other.name)
                yield Fault(Place(task.place), reason, NOT_RUN)


@lru_cache(maxsize=1024)  # asked after every change of an application
def moves_a_device(source: str) -> bool:
    """Whether the class in a module's text says `hardware = True`."""
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError, RecursionError):
        return False  # a runtime says what is wrong with it
    bodies = (statement.body for statement in tree.body if isinstance(statement, ast.ClassDef))
    return any(_is_flag(statement) for body in bodies for statement in body)


def _is_flag(statement: ast.stmt) -> bool:
    match statement:
        case ast.Assign(targets=[ast.Name(id="hardware")], value=ast.Constant(value=True)):
            return True
        case ast.AnnAssign(target=ast.Name(id="hardware"), value=ast.Constant(value=True)):
            return True
    return False
