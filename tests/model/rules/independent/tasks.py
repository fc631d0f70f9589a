"""Equations (2), (3), (5) and (6), the matrix of pins and the union of a flow, read a second time as tables and sets.

Written from §4.2.2, §5.3.3 and readings 1, 5, 6, 7 and 9 alone; it shares no code with the rules.
"""

from collections.abc import Iterable
from itertools import combinations

from onika.model.task import Task

Pins = set[tuple[str, str]]
"""(kind, state variable) of every pin, a tandem being one pin of the kind INBOTH or OUTBOTH."""

CONNECTS = {
    ("INCONST", "OUTCONST"): True,
    ("INCONST", "OUTBOTH"): True,
    ("INCONST", "OUTVAR"): False,
    ("INVAR", "OUTCONST"): True,
    ("INVAR", "OUTBOTH"): True,
    ("INVAR", "OUTVAR"): True,
    ("INBOTH", "OUTCONST"): True,
    ("INBOTH", "OUTBOTH"): True,
    ("INBOTH", "OUTVAR"): True,
}
"""Which input may stand at which output (reading 6)."""


def pins(task: Task) -> Pins:
    result = set()
    for const, var, way in ((task.inconst, task.invar, "IN"), (task.outconst, task.outvar, "OUT")):
        for coded in [*const, *var]:
            in_both = coded in const and coded in var
            kind = way + ("BOTH" if in_both else "CONST" if coded in const else "VAR")
            alias = [new for old, new in task.aliases if old == coded]
            result.add((kind, alias[0] if alias else coded))
    return result


def named(task: Task, *kinds: str) -> set[str]:
    return {svar for kind, svar in pins(task) if kind in kinds}


def reads(task: Task) -> set[str]:
    return named(task, "INCONST", "INVAR", "INBOTH")


def writes(task: Task) -> set[str]:
    return named(task, "OUTCONST", "OUTVAR", "OUTBOTH")


def reads_at_init(task: Task) -> set[str]:
    return named(task, "INCONST", "INBOTH")


def writes_at_init(task: Task) -> set[str]:
    return named(task, "OUTCONST", "OUTBOTH")


def may_meet(item: str, other: str) -> bool:
    """The matrix of pins: may these two kinds share a variable?"""
    if item.startswith("IN") and other.startswith("IN"):
        return True
    if item.startswith("OUT") and other.startswith("OUT"):
        return False
    return CONNECTS[(item, other) if item.startswith("IN") else (other, item)]


def clash(task: Task, other: Task) -> bool:
    """Equation (3) as reading 5 reads it, either way round."""
    return bool(named(task, "OUTVAR") & named(other, "INCONST") or named(other, "OUTVAR") & named(task, "INCONST"))


def greyed(library: Iterable[Task], placed: Iterable[Task]) -> set[str]:
    """Equation (2), and the module of §4.2.2."""
    placed = list(placed)
    return {
        t.name
        for t in library
        if any(writes(t) & writes(s) or s.name == t.name or s.module == t.module or clash(s, t) for s in placed)
    }


def self_fed(task: Task) -> set[str]:
    """Equation (5)."""
    return reads(task) & writes(task)


def hanging(tasks: Iterable[Task]) -> set[str]:
    """Equation (6)."""
    tasks = list(tasks)
    every = {svar for task in tasks for svar in reads(task) | writes(task)}
    return {p for p in every if any(p in reads(t) for t in tasks) and not any(p in writes(s) for s in tasks)}


def device(task: Task) -> set[str]:
    """The hardware that a task declares as its own (law 16)."""
    return {line.words[0] for line in task.local if line.key == "DEVICE"}


def union_is_free(tasks: Iterable[Task]) -> bool:
    """Reading 1, and what law 9 adds to it: constants have one supplier, which is no pure OUTVAR."""
    return not any(
        item.module == other.module
        or device(item) & device(other)
        or writes_at_init(item) & writes_at_init(other)
        or clash(item, other)
        for item, other in combinations(list(tasks), 2)
    )


def configuration_is_free(tasks: Iterable[Task]) -> bool:
    """Whether nobody in a configuration would be greyed out beside the others."""
    return not any(greyed([item], [other]) for item, other in combinations(list(tasks), 2))
