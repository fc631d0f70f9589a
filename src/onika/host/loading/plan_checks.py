"""What can be wrong with tasks that are to live together, found before any of them does (laws 7, 9, 10, 16)."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from typing import Any

from onika.host.loading.module_questions import ModuleQuestions
from onika.model.rules.order import constant_order
from onika.runtime.modules.sheet import SLOWEST_HARDWARE_HZ
from onika.runtime.wiring import WiredTask
from onika.wire.plan import Code, Plan
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import Reason

_WORLD = ".world"
_LEAVING = (
    "files.robot_left_out",
    "files.world_left_out",
    "host.no_device_used",
    "workcell.device_left_out",
    "workcell.place_left_out",
    "workcell.robot_left_out",
)
"""What is done instead where devices are lacking afterwards."""
_SLOWEST_HZ = 1e-3
_FASTEST_HZ = 1e6
"""No task cycles more often; and no period rounds to nothing."""

GivenRate = tuple[Place, str | None, str, float]
"""Where a rate stands, the job it is given in (empty: the task's own file, None: by hand), the task, the hertz."""


def at_action(plan: Plan, flow: int, action: int, reason: Reason) -> Fault:
    """A fault of one action of a plan: it stands at its icon, and says in which flow and which action of it."""
    planned_action = plan.flows[flow].actions[action]
    subsystem, number = plan.flows[flow].subsystem, action + 1
    if planned_action.within:
        application = " / ".join(planned_action.within)
        where = Reason.of(
            "host.where_within", flow=subsystem, action=number, application=application, name=planned_action.name
        )
    else:
        where = Reason.of("host.where", flow=subsystem, action=number, name=planned_action.name)
    return Fault(Place(planned_action.place, planned_action.line), reason, NOT_RUN, where=where)


def conflicts(wired: Sequence[WiredTask]) -> list[Fault]:
    """In a flow's union: one module twice, a constant supplied twice, a variable read as a constant (law 9)."""
    faults = []
    modules: dict[str, str] = {}
    suppliers: dict[str, str] = {}
    for wired_task in wired:
        other = modules.setdefault(wired_task.task.module, wired_task.name)
        if other != wired_task.name:
            faults.append(
                _union(wired_task, Reason.of("host.module_twice", module=wired_task.task.module, other=other))
            )
        for svar in wired_task.outconst:
            other = suppliers.setdefault(svar, wired_task.name)
            if other != wired_task.name:
                faults.append(_union(wired_task, Reason.of("host.constant_twice", constant=svar, other=other)))
        for reader in wired:
            mixed = (set(wired_task.outvar) - set(wired_task.outconst)) & (set(reader.inconst) - set(reader.invar))
            faults += [
                _union(reader, Reason.of("host.constant_varies", constant=svar, task=wired_task.name))
                for svar in sorted(mixed)
            ]
    return faults


def _union(wired_task: WiredTask, reason: Reason) -> Fault:
    return Fault(Place(wired_task.task.place), reason, NOT_RUN)


def cycles(wired: Sequence[WiredTask]) -> list[Fault]:
    """Constants that wait for each other."""
    _, cycles = constant_order([wired_task.meeting for wired_task in wired])
    return [_union(wired[0], Reason.of("host.constants_wait", cycle=" → ".join(cycle))) for cycle in cycles]


def shared_devices(tasks: Sequence[WiredTask]) -> list[Fault]:
    """A device that takes commands is claimed by one task, over all flows."""
    claimed: dict[str, WiredTask] = {}
    faults = []
    for device, task in _with_device(tasks):
        if not task.sheet.hardware:
            continue
        other = claimed.setdefault(device, task)
        if other is not task:
            faults.append(_union(task, Reason.of("host.device_claimed", device=device, other=other.name)))
    return faults


def absent_devices(tasks: Sequence[WiredTask], loading: ModuleQuestions) -> list[Fault]:
    """Devices that no world has."""
    faults = []
    for device, task in _with_device(tasks):
        world, _, name = device.partition(":")
        devices = loading.devices(world)
        because = _lacked(name, loading.world_faults(world))
        if isinstance(devices, Fault):
            faults.append(replace(_union(task, _no_world(devices.reason, device)), because=because))
        elif name not in devices:
            there = devices or Reason.of("host.none_there")
            reason = Reason.of("host.no_such_device", world=world, devices=there, device=device)
            faults.append(replace(_union(task, reason), because=because))
    return faults


def is_there(task: WiredTask, loading: ModuleQuestions) -> bool:
    """Whether some world has the device of a task; nothing that needs one is true too."""
    world, _, name = (task.device or "").partition(":")
    devices = loading.devices(world) if world else ()
    return not world or (not isinstance(devices, Fault) and name in devices)


def _lacked(device: str, faults: Sequence[Fault]) -> tuple[Place, ...]:
    """Where it is told what a world lacks, and a device for that."""
    return tuple(fault.place for fault in faults if _leaves_out(fault, device))


def _leaves_out(fault: Fault, device: str) -> bool:
    """Whether a device may be lacking for this: a lamp, a sensor or a camera of the world has its own name."""
    if fault.instead.key == "workcell.device_left_out" and fault.place.file.endswith(_WORLD):
        return fault.instead.args["name"] == device
    return fault.instead.key in _LEAVING


def _with_device(tasks: Sequence[WiredTask]) -> list[tuple[str, WiredTask]]:
    return [(device, task) for task in tasks if (device := task.device)]


def _commanded(tasks: Sequence[WiredTask]) -> dict[str, dict[str, WiredTask]]:
    """By world and name, the devices that take commands of these tasks, each with its task."""
    worlds: dict[str, dict[str, WiredTask]] = {}
    for device, task in _with_device(tasks):
        if task.sheet.hardware:
            world, _, name = device.partition(":")
            worlds.setdefault(world, {})[name] = task
    return worlds


def _no_world(reason: Reason, device: str) -> Reason:
    """Why there is no world for a device: one that nobody offers is told with the device that wants it."""
    if reason.key != "host.no_such_world":
        return reason
    return Reason.of("host.no_world_of_device", worlds=reason.args["worlds"], device=device)


def unfit(wired_task: WiredTask, code: Code, constants: Mapping[str, Any], loading: ModuleQuestions) -> list[Fault]:
    """A device that is not the one which a task means: another robot or sensor, or one that stands elsewhere."""
    if not wired_task.device:
        return []
    reason = loading.fits(code, dict(constants), wired_task.device)
    if isinstance(reason, Fault):
        return [reason]
    if not reason:
        return []
    return [
        _union(wired_task, Reason.of("host.device_unlike", task=wired_task.name, device=wired_task.device, why=reason))
    ]


def unfit_together(tasks: Sequence[WiredTask], loading: ModuleQuestions) -> list[Fault]:
    """Devices of one world that cannot be used together, as arms with forces and others without (law 18)."""
    faults = []
    for world, claimed in _commanded(tasks).items():
        reasons = loading.company(world, tuple(sorted(claimed))) if len(claimed) > 1 else ()
        if isinstance(reasons, Fault):
            return [reasons]
        for why in reasons:
            named = [wired_task for name, wired_task in claimed.items() if name in why.args.values()]
            last = max(named or claimed.values(), key=lambda wired_task: wired_task.name)
            faults.append(_union(last, Reason.of("host.devices_unfit", world=world, why=why)))
    return faults


def note_at(place: Place, note: Reason) -> Reason:
    """What is only worth knowing, with where it stands."""
    if place.line:
        return Reason.of("host.note_at", file=place.file, line=place.line, note=note)
    return Reason.of("host.note_in", file=place.file, note=note)


def remarks(tasks: Sequence[WiredTask], loading: ModuleQuestions) -> list[Reason]:
    """What is odd about the devices of one flow, and forbids nothing: an arm moves, and the other arm's hand closes."""
    notes = []
    for world, claimed in _commanded(tasks).items():
        objections = loading.company(world, tuple(sorted(claimed)), is_of_flow=True) if len(claimed) > 1 else ()
        for remark in objections if isinstance(objections, tuple) else ():
            place = next(
                (wired_task.task.place for name, wired_task in claimed.items() if name in remark.args.values()), world
            )
            notes.append(note_at(Place(place), remark))
    return notes


def states_constants(wired_task: WiredTask) -> bool:
    """Whether a task is asked for its constants before it lives: hardware, and what its device gives its shapes."""
    shapes = {name for port in wired_task.ports for name in port.shape.names}
    return wired_task.sheet.hardware or (wired_task.device is not None and not shapes.isdisjoint(wired_task.outconst))


def shapeless(wired: Sequence[WiredTask], constants: Mapping[str, Any]) -> list[Fault]:
    """Tasks whose own shapes depend on a constant that they supply themselves, and do not state before they live."""
    return [
        Fault(
            Place(wired_task.task.place),
            Reason.of(
                "host.constant_not_given",
                name=name,
                module=wired_task.task.module,
                svar=port.svar,
                shape=str(port.shape),
            ),
            NOT_RUN,
        )
        for wired_task in wired
        for port in wired_task.ports
        for name in port.shape.names
        if name in wired_task.outconst and name not in constants
    ]


def wrong_rates(given: Sequence[GivenRate], hardware: Collection[str], instead: Reason) -> list[Fault]:
    """Rates without a period of whole nanoseconds, or with one too long for hardware (law 17)."""
    faults = []
    for place, job, name, hz in given:
        if not _SLOWEST_HZ <= hz <= _FASTEST_HZ:
            faults.append(Fault(place, _outside(name, job, hz), instead))
        elif hz < SLOWEST_HARDWARE_HZ and name in hardware and job != "":  # else told as a difference to its module
            faults.append(Fault(place, _too_slow(name, job, hz), instead))
    return faults


def _outside(name: str, job: str | None, hz: float) -> Reason:
    slowest, fastest = _SLOWEST_HZ, _FASTEST_HZ
    if job is None:
        return Reason.of("host.rate_outside_now", slowest=slowest, fastest=fastest, task=name, hz=hz)
    if job:
        return Reason.of("host.rate_outside_in", slowest=slowest, fastest=fastest, task=name, job=job, hz=hz)
    return Reason.of("host.rate_outside", slowest=slowest, fastest=fastest, task=name, hz=hz)


def _too_slow(name: str, job: str | None, hz: float) -> Reason:
    if job is None:
        return Reason.of("host.hardware_too_slow_now", task=name, slowest=SLOWEST_HARDWARE_HZ, hz=hz)
    return Reason.of("host.hardware_too_slow_in", task=name, job=job, slowest=SLOWEST_HARDWARE_HZ, hz=hz)
