"""What can be wrong with tasks that are to live together, found before any of them does (laws 7, 9, 10, 16)."""

from collections.abc import Collection, Mapping, Sequence
from typing import Any

from onika.host.loading.module_questions import Loading
from onika.model.rules.order import constant_order
from onika.model.task import LocalLine, Task, TaskType
from onika.runtime.sheet import SLOWEST_HARDWARE_HZ
from onika.runtime.wiring import WiredTask
from onika.wire.plan import Code, Plan, PlannedTask
from onika.words.fault import Fault, Place

NOT_RUN = "the application is not run"

_SLOWEST_HZ = 1e-3
_FASTEST_HZ = 1e6
"""No task cycles more often; and no period rounds to nothing."""

GivenRate = tuple[Place, str, str, float]
"""Where a rate stands, the job it is given in (` in JOB`, empty: the task's own file), the task, the rate in hertz."""


def at_action(plan: Plan, flow: int, action: int, expected: str, found: str, instead: str = NOT_RUN) -> Fault:
    """A fault of one action of a plan: it stands at its icon, and says in which flow and which action of it."""
    one = plan.flows[flow].actions[action]
    inside = f" of {' / '.join(one.within)}" if one.within else ""
    where = f"{plan.flows[flow].subsystem}, action {action + 1}{inside}: {one.name}"
    return Fault(Place(one.place, one.line), expected, found, instead, where=where)


def conflicts(wired: Sequence[WiredTask]) -> list[Fault]:
    """In a flow's union: one module twice, a constant supplied twice, a variable read as a constant (law 9)."""
    faults = []
    modules: dict[str, str] = {}
    suppliers: dict[str, str] = {}
    for one in wired:
        other = modules.setdefault(one.task.module, one.name)
        if other != one.name:
            faults.append(_union(one, f"module {one.task.module} once in a flow", f"also in task {other}"))
        for svar in one.outconst:
            other = suppliers.setdefault(svar, one.name)
            if other != one.name:
                faults.append(_union(one, f"one supplier of the constant {svar}", f"also task {other}"))
        for reader in wired:
            mixed = (set(one.outvar) - set(one.outconst)) & (set(reader.inconst) - set(reader.invar))
            faults += [
                _union(reader, f"a constant {svar}", f"task {one.name} writes it at every cycle")
                for svar in sorted(mixed)
            ]
    return faults


def _union(one: WiredTask, expected: str, found: str) -> Fault:
    return Fault(Place(one.task.place), expected, found, NOT_RUN)


def cycles(wired: Sequence[WiredTask]) -> list[Fault]:
    """Constants that wait for each other."""
    _, cycles = constant_order([one.meeting for one in wired])
    return [
        Fault(Place(wired[0].task.place), "constants that do not wait for each other", " → ".join(cycle), NOT_RUN)
        for cycle in cycles
    ]


def shared_devices(tasks: Sequence[WiredTask]) -> list[Fault]:
    """A device that takes commands is claimed by one task, over all flows."""
    claimed: dict[str, WiredTask] = {}
    faults = []
    for one in (one for one in tasks if one.sheet.hardware and one.device):
        other = claimed.setdefault(one.device or "", one)
        if other is not one:
            faults.append(_union(one, f"device {one.device} for one task", f"task {other.name} claims it too"))
    return faults


def absent_devices(tasks: Sequence[WiredTask], loading: Loading) -> list[Fault]:
    """Devices that no world has."""
    faults = []
    for one in (one for one in tasks if one.device):
        world, _, name = (one.device or "").partition(":")
        known = loading.devices(world)
        if isinstance(known, Fault):
            expected = known.expected.removeprefix("expected ").partition(", found ")[0]
            faults.append(Fault(Place(one.task.place), expected, f"DEVICE {one.device}", NOT_RUN))
        elif name not in known:
            expected = f"a device of world {world} ({', '.join(known)})"
            faults.append(Fault(Place(one.task.place), expected, f"DEVICE {one.device}", NOT_RUN))
    return faults


def unfit(one: WiredTask, code: Code, constants: Mapping[str, Any], loading: Loading) -> list[Fault]:
    """A device that is not the one which a task means: another robot or sensor, or one that stands elsewhere."""
    if not one.device:
        return []
    reason = loading.fits(code, dict(constants), one.device)
    if isinstance(reason, Fault):
        return [reason]
    return [_union(one, f"the device that {one.name} means as {one.device}", reason)] if reason else []


def unfit_together(tasks: Sequence[WiredTask], loading: Loading) -> list[Fault]:
    """Devices of one world that cannot be used together, as arms with forces and others without (law 18)."""
    worlds: dict[str, dict[str, WiredTask]] = {}
    for one in (one for one in tasks if one.device and one.sheet.hardware):
        world, _, name = (one.device or "").partition(":")
        worlds.setdefault(world, {})[name] = one
    faults = []
    for world, claimed in worlds.items():
        reasons = loading.company(world, tuple(sorted(claimed))) if len(claimed) > 1 else ()
        if isinstance(reasons, Fault):
            return [reasons]
        last = max(claimed.values(), key=lambda one: one.name)
        faults += [_union(last, f"devices of {world} that can be used together", reason) for reason in reasons]
    return faults


def remarks(tasks: Sequence[WiredTask], loading: Loading) -> list[str]:
    """What is odd about the devices of one flow, and forbids nothing: an arm moves, and the other arm's hand closes."""
    worlds: dict[str, dict[str, WiredTask]] = {}
    for one in (one for one in tasks if one.device and one.sheet.hardware):
        world, _, name = (one.device or "").partition(":")
        worlds.setdefault(world, {})[name] = one
    found = []
    for world, claimed in worlds.items():
        said = loading.company(world, tuple(sorted(claimed)), is_of_flow=True) if len(claimed) > 1 else ()
        for remark in said if isinstance(said, tuple) else ():
            place = next((one.task.place for name, one in claimed.items() if name in remark), world)
            found.append(f"{place}: {remark}")
    return found


def shapeless(wired: Sequence[WiredTask], constants: Mapping[str, Any]) -> list[Fault]:
    """Tasks whose own shapes depend on a constant that they supply themselves, and do not state before they live."""
    return [
        Fault(
            Place(one.task.place),
            f"{name} from `constants` of module {one.task.module}, as {port.svar} {port.shape} needs it",
            "none",
            NOT_RUN,
        )
        for one in wired
        for port in one.ports
        for name in port.shape.names
        if name in one.outconst and name not in constants
    ]


def wrong_rates(given: Sequence[GivenRate], hardware: Collection[str], instead: str) -> list[Fault]:
    """Rates without a period of whole nanoseconds, or with one too long for hardware (law 17)."""
    faults = []
    for place, where, name, hz in given:
        if not _SLOWEST_HZ <= hz <= _FASTEST_HZ:
            expected = f"{_SLOWEST_HZ:g} Hz to {_FASTEST_HZ:g} Hz for {name}{where}"
            faults.append(Fault(place, expected, f"{hz:g} Hz", instead))
        elif hz < SLOWEST_HARDWARE_HZ and name in hardware and where:  # without: told as a difference to its module
            expected = f"hardware task {name}{where} at {SLOWEST_HARDWARE_HZ:g} Hz or more"
            faults.append(Fault(place, expected, f"{hz:g} Hz", instead))
    return faults


def task_of(planned: PlannedTask) -> Task:
    """The task as its file describes it."""
    return Task(
        name=planned.name,
        module=planned.module,
        aliases=planned.aliases,
        inconst=planned.inconst,
        outconst=planned.outconst,
        invar=planned.invar,
        outvar=planned.outvar,
        type=TaskType(planned.type),
        frequency=planned.frequency,
        local=tuple(LocalLine(key, words) for key, words in planned.local),
    )
