"""Which tasks may stand in one configuration, Equations (2) and (3) (dissertation §5.3.3, §4.2.2)."""

from collections.abc import Iterable

from onika.model.task import Task
from onika.words.fault import Refusal


def refusals(task: Task, placed: Iterable[Task]) -> tuple[Refusal, ...]:
    """Every reason why `task` may not join the tasks `placed`, Equation (2); empty: it may.

    The reasons are its name, its module, each output shared and each pure OUTVAR that meets a pure INCONST, by
    aliased names.
    """
    return tuple(refusal for other in placed for refusal in _between(task, other))


def greyed(library: Iterable[Task], placed: Iterable[Task]) -> dict[str, tuple[Refusal, ...]]:
    """The set G of Equation (2): the tasks of a library that may not be placed, each with all its reasons."""
    standing = tuple(placed)
    reasons = {task.name: refusals(task, standing) for task in library}
    return {name: found for name, found in reasons.items() if found}


def alias_refusals(changed: Task, others: Iterable[Task]) -> tuple[Refusal, ...]:
    """Why the aliases of `changed` may not be taken over beside the `others` of its configuration (decision 9)."""
    twice = tuple(
        Refusal(
            f"{' and '.join(names)} of `{changed.name}` would both write {svar}", (f"give {names[-1]} another alias",)
        )
        for svar, names in _writers(changed).items()
        if len(names) > 1
    )
    return twice + refusals(changed, (task for task in others if task.name != changed.name))


def meets_constant(writer: Task, reader: Task) -> frozenset[str]:
    """O_V(writer) ∩ I_C(reader) of Equation (3): given only while it runs, needed at initialisation."""
    return given_while_running(writer) & needed_at_start(reader)


def given_while_running(task: Task) -> frozenset[str]:
    """O_V of a task: the variables of its pure OUTVARs."""
    return _pure(task, task.outvar, task.outconst)


def needed_at_start(task: Task) -> frozenset[str]:
    """I_C of a task: the variables of its pure INCONSTs."""
    return _pure(task, task.inconst, task.invar)


def _between(task: Task, other: Task) -> list[Refusal]:
    found = []
    if task.name == other.name:
        return [Refusal(f"`{task.name}` is placed already", (f"show `{other.name}`",))]
    if task.module == other.module:
        reason = f"its module `{task.module}` runs already, in `{other.name}`"
        found.append(Refusal(reason, (f"replace `{other.name}`", f"show `{other.name}`")))
    for svar in sorted(task.outputs & other.outputs):
        reason = f"writes {svar}, which `{other.name}` already writes"
        found.append(Refusal(reason, (f"replace `{other.name}`", f"alias {svar}", f"show `{other.name}`")))
    for writer, reader in ((task, other), (other, task)):
        for svar in sorted(meets_constant(writer, reader)):
            reason = f"`{reader.name}` needs {svar} at initialisation, `{writer.name}` gives it only while it runs"
            found.append(Refusal(reason, (f"replace `{other.name}`", f"alias {svar}", f"show `{other.name}`")))
    return found


def _pure(task: Task, names: Iterable[str], tandem: Iterable[str]) -> frozenset[str]:
    """The variables of some ports that are not part of an INBOTH or OUTBOTH."""
    both = set(tandem)
    return frozenset(task.svars(tuple(name for name in names if name not in both)))


def _writers(task: Task) -> dict[str, list[str]]:
    """The coded names of the outputs behind every variable a task writes."""
    writers: dict[str, list[str]] = {}
    names = tuple(dict.fromkeys(task.outconst + task.outvar))
    for name, svar in zip(names, task.svars(names), strict=True):
        writers.setdefault(svar, []).append(name)
    return writers
