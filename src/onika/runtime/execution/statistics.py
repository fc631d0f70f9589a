"""The statistics of a running task: its status (A11, A17), its cost (X13), its values when it fails (A18)."""

from time import get_clock_info
from typing import Any

from onika.runtime.counters import Counters
from onika.runtime.execution.running_task import RunningTask
from onika.runtime.load import TaskLoad
from onika.runtime.modules.binding import Binding
from onika.runtime.news import TaskStatus
from onika.runtime.table import value_of

TICK_MS = get_clock_info("monotonic").resolution * 1e3
"""The tick of the clock by which all units run."""
_FEW_CYCLES = 20
"""With fewer since the last status those before it say more."""
_LONGEST_LIST = 64
"""Elements of an array that are told of a failure; a picture would be too long a read."""


def status_of(task: RunningTask, now: int) -> TaskStatus:
    """The figures since the last status; counting begins anew."""
    counters, spawn = task.counters, task.spawn
    profiled_ns = counters.profiled_ns(now)
    status = TaskStatus(
        subsystem=spawn.subsystem,
        task=spawn.task,
        module=spawn.module,
        state=task.state.value,
        type=spawn.task_type,
        crit=-task.slot.key[0],
        cycle=counters.cycles,
        miss=task.slot.missed,
        warn=counters.warnings,
        reference_hz=_reference_hz(task),
        # a profile that is shorter than a period says nothing of the rate
        measured_hz=counters.cycles / (max(profiled_ns, task.period_ns) * 1e-9),
        profiled_s=profiled_ns * 1e-9,
        total_us=counters.total_ns / 1e3,
        least_us=counters.least_ns / 1e3,
        mean_us=counters.mean_ns / 1e3,
        most_us=counters.most_ns / 1e3,
        tid=task.tid,
        tick_ms=TICK_MS,
    )
    if counters.cycles:
        task.last_profile = counters
    task.counters = Counters(None if counters.on_since_ns is None else now)
    task.slot.missed = 0
    return status


def load_of(task: RunningTask) -> TaskLoad:
    """What the task costs by its newest figures, with those before the last status where there are few since."""
    newest = [task.counters]
    if task.counters.cycles < _FEW_CYCLES:
        newest.append(task.last_profile)
    cycles = sum(profile.cycles for profile in newest)
    mean_ns = sum(profile.total_ns for profile in newest) / cycles if cycles else 0.0
    most_ns = max(profile.most_ns for profile in newest)
    spawn = task.spawn
    return TaskLoad(spawn.subsystem, spawn.task, task.is_on, _reference_hz(task), mean_ns / 1e3, most_ns / 1e3, cycles)


def values_of(binding: Binding) -> dict[str, Any]:
    """The values of all ports as the module sees them, as plain lists and numbers; long ones are cut."""
    return {name: _plain(value_of(data.tobytes(), shape)) for name, shape, data in binding.values}


def _reference_hz(task: RunningTask) -> float:
    if task.spawn.frequency is None:
        return 0.0
    return 1e9 / task.period_ns


def _plain(value: Any) -> Any:
    if not hasattr(value, "tolist"):
        if isinstance(value, list):
            return value[:_LONGEST_LIST]
        return value
    flat = value.ravel()
    if flat.size <= _LONGEST_LIST:
        return value.tolist()
    return [*flat[:_LONGEST_LIST].tolist(), f"… ({flat.size})"]
