"""The worlds whose devices tasks drive, and tasks in other worlds than their files say (requirement E09)."""

from collections.abc import Iterable, Mapping
from dataclasses import replace

from onika.model.redirect import WorldChoice
from onika.model.rules.union import DEVICE, devices
from onika.model.task import LocalLine, Task


def worlds_of(tasks: Iterable[Task]) -> tuple[str, ...]:
    """The worlds that tasks have devices in, by name."""
    claimed = {device.partition(":") for task in tasks for device in devices(task)}
    return tuple(sorted({world for world, colon, _ in claimed if colon}))


def relocated(task: Task, worlds: WorldChoice) -> Task:
    """The task with its device in the world that stands for its own; itself where none does."""
    local = tuple(_line(line, worlds) for line in task.local)
    if local == task.local:
        return task
    return replace(task, local=local)


def all_relocated(tasks: Mapping[str, Task], worlds: WorldChoice) -> Mapping[str, Task]:
    """Tasks by name, each with its device in the world that stands for its own."""
    if not worlds:
        return tasks
    return {name: relocated(task, worlds) for name, task in tasks.items()}


def _line(line: LocalLine, worlds: WorldChoice) -> LocalLine:
    if line.key != DEVICE or not line.words:
        return line
    world, colon, device = line.words[0].partition(":")
    return LocalLine(line.key, (worlds.get(world, world) + colon + device, *line.words[1:]))
