"""The order of constants and the reconfiguration of a living subsystem, read a second time by search.

Written from §5.3.4, A13, laws 3 and 10 and readings 6 and 14; it shares no code with the rules.
"""

from collections.abc import Collection, Sequence

from onika.model.task import Task

from .tasks import device, named, reads_at_init, writes_at_init


def suppliers(task: Task, among: Sequence[Task]) -> set[str]:
    """Who has to be initialised before this task; one that supplies itself waits for itself."""
    return {item.name for item in among if writes_at_init(item) & reads_at_init(task)}


def waits_for(tasks: Sequence[Task]) -> dict[str, set[str]]:
    """Everybody for whom a task waits, at once or in the end."""
    waits = {task.name: suppliers(task, tasks) for task in tasks}
    for _ in tasks:
        waits = {name: wait.union(*(waits[each] for each in wait)) for name, wait in waits.items()}
    return waits


def rings(tasks: Sequence[Task]) -> set[frozenset[str]]:
    """The sets of tasks of which each waits for all the others of its set."""
    waits = waits_for(tasks)
    return {
        frozenset(other for other in waits if other == name or (other in waits[name] and name in waits[other]))
        for name in waits
        if name in waits[name]
    }


def is_in_order(order: Sequence[str], tasks: Sequence[Task]) -> bool:
    """Each task once, each after those for whom it waits, save those that wait for it too."""
    waits = waits_for(tasks)
    place = {name: at for at, name in enumerate(order)}
    return sorted(order) == sorted(waits) and all(
        place[before] < place[name] for name in waits for before in waits[name] if name not in waits[before]
    )


def kept(living: Sequence[Task], kill: Collection[str]) -> set[str]:
    return {task.name for task in living if task.name not in kill}


def killed_first(living: Sequence[Task], kill: Collection[str], new: Sequence[Task]) -> set[str]:
    """Of those that go: who shares name, module or hardware with one that comes (reading 14; A06 for the name)."""
    return {
        old.name
        for old in living
        if old.name in kill
        and any(old.name == each.name or old.module == each.module or device(old) & device(each) for each in new)
    }


def broken_into(living: Sequence[Task], kill: Collection[str], new: Sequence[Task]) -> set[str]:
    """Of those that go: into whose variable the first value of one that comes would break (§4.2.2)."""
    return {
        old.name
        for old in living
        if old.name in kill and any(named(old, "OUTVAR", "OUTBOTH") & writes_at_init(each) for each in new)
    }


def reinitialised(living: Sequence[Task], kill: Collection[str], new: Sequence[Task]) -> set[str]:
    """Who has to learn a constant that changed.

    Of those that stay, whoever reads one of a task that comes, as it may have been said before by one that is gone
    (law 10); and of all, whoever reads one of a task that is itself initialised anew.
    """
    staying = [task for task in living if task.name not in kill]
    come = set().union(*(writes_at_init(task) for task in new))
    names = {task.name for task in staying if reads_at_init(task) & come}
    for _ in [*staying, *new]:
        said_anew = set().union(*(writes_at_init(task) for task in [*staying, *new] if task.name in names))
        names |= {task.name for task in [*staying, *new] if reads_at_init(task) & said_anew}
    return names
