"""Objections to what is asked of a subsystem by hand, found before anything is changed."""

from collections.abc import Sequence

from onika.host.loading.plan_checks import GivenRate, wrong_rates
from onika.host.loading.plan_preparation import unknown_parameters
from onika.model.planned import task_of
from onika.runtime.modules.sheet import differences
from onika.runtime.wiring import WiredTask, wire
from onika.wire.live import Change
from onika.wire.plan import PlannedTask
from onika.wire.sheet import ModuleSheet
from onika.words.fault import Fault, Place
from onika.words.reason import Reason

INSTEAD = Reason.of("words.nothing_changed")


def of_change(fault: Fault) -> Fault:
    """A fault of an application's rules, said of a change."""
    return Fault(fault.place, fault.reason, INSTEAD)


def wired(
    tasks: Sequence[PlannedTask], sheets: dict[str, ModuleSheet]
) -> tuple[list[WiredTask], list[Fault], list[Reason]]:
    """Tasks bound to their modules' ports; in what they differ from these, and what is worth knowing."""
    wired, faults, notes = [], [], []
    for task in tasks:
        sheet = sheets.get(task.digest)
        if sheet is None:
            continue  # its module's fault is told already
        wrong = differences(task_of(task), sheet, Place(task.place))
        faults += wrong
        notes += unknown_parameters(task, sheet)
        if not wrong:
            wired.append(wire(task, sheet))
    return wired, faults, notes


def names(order: Change, living: Sequence[WiredTask]) -> list[Fault]:
    """Tasks that are named and are not there, or are there already."""
    there = {wired_task.name for wired_task in living}
    born = [planned_task.name for planned_task in order.spawn]
    after = (there - set(order.kill)) | set(born)
    place = Place(f"subsystem {order.subsystem}")
    missing = [(name, there) for name in order.kill] + [(name, there) for name in order.off]
    missing += [(turn.task, after) for turn in order.on] + [(name, after) for name, _ in order.rates]
    faults = [
        Fault(
            place,
            Reason.of("host.task_unknown", names=tuple(sorted(candidates)) or Reason.of("host.no_task"), name=name),
            INSTEAD,
        )
        for name, candidates in missing
        if name not in candidates
    ]
    twice = [name for name in dict.fromkeys(born) if born.count(name) > 1 or name in there - set(order.kill)]
    return faults + [Fault(place, Reason.of("host.task_twice", name=name), INSTEAD) for name in twice]


def rates(order: Change, tasks: Sequence[WiredTask]) -> list[Fault]:
    """Rates that no task can have."""
    place = Place(f"subsystem {order.subsystem}")
    given: list[GivenRate] = [(place, None, name, hz) for name, hz in order.rates]
    given += [
        (Place(planned_task.place), "", planned_task.name, planned_task.frequency)
        for planned_task in order.spawn
        if planned_task.frequency is not None
    ]
    timeless = {task.name for task in tasks if task.task.frequency is None}
    faults = [
        Fault(place, Reason.of("host.rate_of_aperiodic", name=name, hz=hz), INSTEAD)
        for name, hz in order.rates
        if name in timeless
    ]
    return faults + wrong_rates(given, {task.name for task in tasks if task.sheet.hardware}, INSTEAD)


def moved(before: WiredTask, after: WiredTask) -> list[Fault]:
    """A living task keeps its device."""
    if before.device == after.device:
        return []
    return [
        Fault(
            Place(before.task.place),
            Reason.of("host.device_changed", device=str(before.device), device_2=str(after.device)),
            INSTEAD,
        )
    ]


def grown(before: WiredTask, after: WiredTask) -> list[Fault]:
    """In what another module's ports differ from those that other tasks are bound to."""
    place = Place(before.task.place)
    bound_ports = {port.port: port for port in before.ports}
    faults = [
        Fault(
            place,
            Reason.of(
                "host.bound_unlike",
                svar=old.svar,
                shape=str(old.shape),
                unit=old.unit,
                shape_2=str(port.shape),
                unit_2=port.unit,
            ),
            INSTEAD,
        )
        for port in after.ports
        if (old := bound_ports[port.port]) != port
    ]
    if before.sheet.hardware is not after.sheet.hardware:
        was_hardware = before.sheet.hardware
        reason = Reason.of("host.no_longer_hardware") if was_hardware else Reason.of("host.now_hardware")
        faults.append(Fault(place, reason, INSTEAD))
    return faults
