"""The sweeps of a job as they would be made: the source that its tasks are run by in virtual time, for who reads it."""

from collections.abc import Mapping, Sequence
from typing import Any

from onika.ring.segment import Segment
from onika.runtime.command import Spawn
from onika.runtime.execution.sweep_source import SweepMember, SweepPort, sweep_source
from onika.runtime.period import period_of
from onika.runtime.subsystem import RunningSubsystem
from onika.runtime.table import SIZE, Table
from onika.runtime.wiring import WiredTask
from onika.words.shape import Shape


def sweep_listing(
    subsystem: str, tasks: Sequence[WiredTask], rates: Mapping[str, float], constants: Mapping[str, Any]
) -> list[tuple[float, str]]:
    """Of each rate in hertz, fastest first, the source of its sweep.

    Raises KeyError for a constant on which a shape depends, where no robot module states it before it lives.
    """
    table = Table(Segment.create("sweep", SIZE))
    running = RunningSubsystem(subsystem, table, tasks, {task.name: task.task.rtpu for task in tasks}, constants)
    groups: dict[float, list[tuple[tuple[int, int, str], SweepMember]]] = {}
    for task in tasks:
        rate = rates.get(task.name, task.task.frequency)
        if rate is None or task.task.type != "periodic":
            continue  # it runs when it is asked to, one by one
        spawn = running.spawn(task.name, "", "", 0, None)
        place = -task.sheet.crit, spawn.rank, f"{subsystem}/{task.name}"
        groups.setdefault(rate, []).append((place, _member(task, spawn)))
    table.close()
    rates_in_order = sorted(groups, key=period_of)
    return [(rate, sweep_source([member for _, member in sorted(groups[rate])]).text) for rate in rates_in_order]


def _member(task: WiredTask, spawn: Spawn) -> SweepMember:
    kinds = {port.port: port.kind for port in task.ports}
    moved = [
        (kinds[port.port].is_input, SweepPort(spawn.subsystem, port.svar, port.offset, Shape.parse(port.shape).size))
        for port in spawn.ports
        if kinds[port.port].at_cycle
    ]
    inputs = tuple(port for is_input, port in moved if is_input)
    outputs = tuple(port for is_input, port in moved if not is_input)
    return SweepMember(spawn.subsystem, spawn.task, task.sheet.hardware, inputs, outputs)
