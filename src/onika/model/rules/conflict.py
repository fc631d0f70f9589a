"""Tasks of one configuration that may not stand together, as a file may hold them (Equations (2) and (3), C26)."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import combinations, product

from onika.model.rules import placement
from onika.model.task import Task
from onika.words.fault import Refusal


def conflicts(tasks: Sequence[Task], new: int = 0) -> Iterator[tuple[Task, Task, tuple[Refusal, ...]]]:
    """Every pair that may not stand together, with all reasons why the later task may not join the earlier one.

    new     the first of them that is asked about: those before it may stand as they like
    """
    for later, earlier in sorted((max(pair), min(pair)) for pair in _suspects(tasks) if max(pair) >= new):
        yield tasks[later], tasks[earlier], placement.refusals(tasks[later], [tasks[earlier]])


def _suspects(tasks: Sequence[Task]) -> set[tuple[int, int]]:
    """The pairs that share a name, a module or an output, or meet in a constant; few, so that each can be asked."""
    pairs: set[tuple[int, int]] = set()
    for of in (_name, _module, _outputs):
        for positions in _by(tasks, of).values():
            pairs.update(combinations(positions, 2))
    given, needed = _by(tasks, placement.given_while_running), _by(tasks, placement.needed_at_start)
    for svar in given.keys() & needed.keys():
        pairs.update((min(pair), max(pair)) for pair in product(given[svar], needed[svar]) if pair[0] != pair[1])
    return pairs


def _by(tasks: Sequence[Task], of: Callable[[Task], Iterable[str]]) -> dict[str, list[int]]:
    positions: dict[str, list[int]] = {}
    for position, task in enumerate(tasks):
        for key in of(task):
            positions.setdefault(key, []).append(position)
    return positions


def _name(task: Task) -> tuple[str]:
    return (task.name,)


def _module(task: Task) -> tuple[str]:
    return (task.module,)


def _outputs(task: Task) -> frozenset[str]:
    return task.outputs
