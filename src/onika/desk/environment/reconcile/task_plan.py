"""What a runtime needs to bring a placed task to life: the task as a plan carries it, and its code by hash."""

from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path

import msgspec

from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.desk.plan.compile import UNKNOWN, planned_task
from onika.desk.plan.module_code import module_code
from onika.model.configuration import Placed
from onika.model.task import Task
from onika.store.remote.library_fetcher import unfetched
from onika.wire.plan import Code, PlannedTask
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class SpawnPlan:
    """A task to be born, and its code."""

    task: PlannedTask
    code: Code


def birth(placed: Placed, libraries: OpenLibraries, units: Collection[str]) -> SpawnPlan | Reason:
    """How a placed task is born, or why it cannot be; on a unit that is not there it is born on the first one."""
    task = libraries.tasks.get(placed.task)
    if task is None:
        return Reason.of("desk.no_task", name=placed.task)
    code = code_of(task.module, libraries, placed.task)
    if isinstance(code, Reason):
        return Reason.of("run.cannot_live", task=placed.task, why=code)
    rtpu = placed.rtpu if placed.rtpu in units else UNKNOWN
    planned = planned_task(task, rtpu, code.digest, str(libraries.task_file(placed.task)))
    return SpawnPlan(msgspec.structs.replace(planned, frequency=rate_of(placed, task)), code)


def rate_of(placed: Placed, task: Task) -> float | None:
    """The rate of a placed task in hertz; None where it has none."""
    if task.frequency is None:
        return None
    return placed.frequency or task.frequency


def code_of(module: str, libraries: OpenLibraries, task: str) -> Code | Reason:
    """The code of a task's module as it stands in its file now, beside the task or in another open library."""
    path = code_path(module, libraries, task)
    if path is None:
        return Reason.of("run.code_missing", module=module)
    lacking = unfetched((path,))
    if lacking:
        return lacking[0].reason
    try:
        source = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as wrong:
        return Reason.of("run.code_unreadable", path=str(path), why=str(wrong))
    return module_code(module, path, source)


def code_path(module: str, libraries: OpenLibraries, task: str) -> Path | None:
    """Where the code of a task's module stands."""
    home = libraries.homes.get(task)
    bases = (*((home.base,) if home else ()), *(library.base for library in libraries.libraries))
    return next((path for base in bases if (path := base.code_file(module)).is_file()), None)


def is_hardware(task: Task, libraries: OpenLibraries) -> bool:
    """Whether it moves a device, as its module says; one that was never read does if it names a device."""
    sheet = libraries.sheets.get(task.module)
    if sheet is not None:
        return sheet.hardware
    return any(line.key == "DEVICE" for line in task.local)
