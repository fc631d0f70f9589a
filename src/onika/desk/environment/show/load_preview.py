"""What a task would take of a processing unit before it is placed, and which would have no time on any (X13)."""

from collections.abc import Mapping

from onika.desk.environment.outcome.remedy import reasons
from onika.desk.environment.state.document import Document
from onika.desk.environment.state.open_libraries import OpenLibraries
from onika.wire.view import Objection, UnitView
from onika.words.fault import Refusal
from onika.words.reason import Reason

_WHOLE = 1.0
"""All the time of a unit."""


def shares(libraries: OpenLibraries, cycles_us: Mapping[str, float]) -> dict[str, float]:
    """By task: measured cycle time × rate, as a share of a unit; without those whose code was never measured.

    cycles_us    the mean time of a cycle in microseconds, by the digest of the code
    """
    measured = {module: cycles_us[digest] for module, digest in libraries.digests.items() if digest in cycles_us}
    shares_by_task: dict[str, float] = {}
    for name, task in libraries.tasks.items() if measured else ():
        hz = libraries.rates.get(name) or task.frequency
        if hz and task.module in measured:
            shares_by_task[name] = round(measured[task.module] * 1e-6 * hz, 2)
    return shares_by_task


def without_time(
    document: Document, libraries: OpenLibraries, shares_by_task: Mapping[str, float], units: Mapping[str, UnitView]
) -> dict[str, tuple[Objection, ...]]:
    """The tasks that would overload even the unit with the most time left, with the number; of a live document."""
    free = {name: unit.load for name, unit in units.items() if not unit.is_lost}
    if document.live is None or document.live.state != "live" or not free:
        return {}
    unit = min(free, key=free.__getitem__)
    placed = set(document.content.names)
    return {
        name: reasons((Refusal(_no_time(name, share, unit, free[unit])),), document.id, libraries.tasks[name])
        for name, share in shares_by_task.items()
        if name not in placed and name in libraries.tasks and free[unit] + share > _WHOLE
    }


def joined(
    greyed: dict[str, tuple[Objection, ...]], late: Mapping[str, tuple[Objection, ...]]
) -> dict[str, tuple[Objection, ...]]:
    """All that may not be placed, first by the rules, then for want of time."""
    if not late:
        return greyed
    return greyed | {name: (*greyed.get(name, ()), *why) for name, why in late.items()}


def _no_time(name: str, share: float, unit: str, load: float) -> Reason:
    return Reason.of("run.no_time_left", task=name, share=share, unit=unit, load=load, use=load + share)
