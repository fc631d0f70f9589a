"""Which tasks may stand for which others while an application runs (requirement E09, §5.9.1, reading 29).

Any task with the same outputs or more, by aliased names. What it writes beyond them, its module and its device must not
meet those of the tasks beside it; and what it reads must be written, where everything that the other one reads is.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from onika.model.configuration import Configuration
from onika.model.own_lines import NO_OWN_LINES
from onika.model.redirect import Choice
from onika.model.rules import placement
from onika.model.rules.union import devices
from onika.model.syntax import same_type
from onika.model.task import Task
from onika.words.fault import Refusal
from onika.words.reason import Reason

Crews = Mapping[str, Sequence[Task]]
"""The tasks of each job of a flow that uses the replaced task, by the name of its configuration."""


@dataclass(frozen=True, slots=True)
class Candidate:
    """A task that could stand for another one; none of its `refusals`: it can."""

    task: Task
    refusals: tuple[Refusal, ...] = ()
    more: tuple[str, ...] = ()
    """What it writes beyond what the other one does."""


def candidates(old: Task, tasks: Iterable[Task], crews: Crews, others: Sequence[Task]) -> list[Candidate]:
    """The tasks that can stand for `old` in a flow, then those that come near and cannot, with all reasons.

    others   the tasks of the other flows
    """
    candidates = [
        Candidate(task, refusals(old, task, crews, others), tuple(sorted(task.outputs - old.outputs)))
        for task in tasks
        if task.name != old.name and _is_near(old, task)
    ]
    return sorted(candidates, key=lambda candidate: (bool(candidate.refusals), candidate.task.name))


def refusals(old: Task, new: Task, crews: Crews, others: Sequence[Task] = ()) -> tuple[Refusal, ...]:
    """Every reason why `new` may not stand for `old` in a flow; none: it may."""
    refusals = (*shortcomings(old, new, crews), *_clashes(old, new, crews, others))
    return tuple({refusal.reason: refusal for refusal in reversed(refusals)}.values())[::-1]


def shortcomings(old: Task, new: Task, crews: Crews) -> tuple[Refusal, ...]:
    """What `new` lacks to stand for `old`: outputs, the same kind of target, and somebody who writes what it reads."""
    return tuple(dict.fromkeys((*_lacks(old, new), *_takes(old, new), *_starves(old, new, crews))))


def is_alike(old: Task, new: Task) -> bool:
    """Whether `new` has the outputs of `old` or more, and takes the same targets."""
    return old.outputs <= new.outputs and _same_targets(old, new)


def redirected(configuration: Configuration, choice: Choice, tasks: Mapping[str, Task]) -> Configuration:
    """A configuration with other tasks in it.

    A rate that the configuration gives of its own holds for whoever stands there; else it is that of his own file.
    """
    if not choice.keys() & {placed.task for placed in configuration.placed}:
        return configuration
    placed = []
    for member in configuration.placed:
        new, old = tasks.get(choice.get(member.task, member.task)), tasks.get(member.task)
        if member.task not in choice or new is None:
            placed.append(member)
            continue
        is_own = old is not None and member.frequency != old.frequency
        hz = member.frequency if is_own else new.frequency or 0.0
        placed.append(replace(member, task=new.name, frequency=hz, own=NO_OWN_LINES, rmod=""))
    return replace(configuration, placed=tuple(placed))


def _is_near(old: Task, new: Task) -> bool:
    """Whether anybody would think of it: something in common of what they write, or nothing is written by both."""
    if old.outputs:
        return not old.outputs.isdisjoint(new.outputs)
    return not new.outputs and _same_targets(old, new)


def _lacks(old: Task, new: Task) -> Iterator[Refusal]:
    if lacking := sorted(old.outputs - new.outputs):
        yield Refusal(Reason.of("rules.outputs_lacking", new=new.name, svars=tuple(lacking), old=old.name))


def _takes(old: Task, new: Task) -> Iterator[Refusal]:
    if not _same_targets(old, new):
        yield Refusal(
            Reason.of("rules.targets_differ", new=new.name, of_new=_taken(new), old=old.name, of_old=_taken(old))
        )


def _same_targets(old: Task, new: Task) -> bool:
    mine, theirs = _targets(old), _targets(new)
    return len(mine) == len(theirs) and all(map(same_type, mine, theirs))


def _targets(task: Task) -> tuple[str, ...]:
    if task.object_type:
        return (task.object_type, *task.more_targets)
    return ()


def _taken(task: Task) -> Reason:
    """The targets that a task takes, in words."""
    if not task.object_type:
        return Reason.of("rules.no_target")
    if task.more_targets:
        return Reason.of("rules.target_of_with", kind=task.object_type, more=task.more_targets)
    return Reason.of("rules.target_of", kind=task.object_type)


def _starves(old: Task, new: Task, crews: Crews) -> Iterator[Refusal]:
    for name, crew in crews.items():
        written = frozenset[str]().union(*(task.outputs for task in crew if task.name != old.name))
        if old.inputs - written - old.outputs:
            continue  # it is not the redirection that leaves something unwritten
        if lacking := tuple(sorted(new.inputs - written - new.outputs)):
            remedy = Reason.of("rules.place_writer", configuration=name, svars=lacking)
            yield Refusal(Reason.of("rules.inputs_lacking", new=new.name, svars=lacking, configuration=name), (remedy,))


def _clashes(old: Task, new: Task, crews: Crews, others: Sequence[Task]) -> Iterator[Refusal]:
    beside = {task.name: task for crew in crews.values() for task in crew if task.name != old.name}
    if new.name in beside:
        yield Refusal(Reason.of("rules.in_flow_already", task=new.name))
        return
    for crew in crews.values():
        yield from placement.refusals(new, (task for task in crew if task.name != old.name))
    for task in beside.values():
        if task.module == new.module:
            reason = Reason.of("rules.module_used", module=new.module, other=task.name)
            yield Refusal(reason, (Reason.of("rules.replace", task=task.name),))
    for other in (*beside.values(), *others):
        for device in sorted(set(devices(other)) & set(devices(new))):
            reason = Reason.of("rules.device_claimed", device=device, other=other.name)
            yield Refusal(reason, (Reason.of("rules.redirect_too", task=other.name),))
