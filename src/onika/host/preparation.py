"""What can be found wrong with a plan before anything moves, from its modules: all at once (E01, laws 24 to 26)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

from onika.model.rules.order import constant_order
from onika.model.task import LocalLine, Task, TaskType
from onika.runtime.sheet import SLOWEST_HARDWARE_HZ, ModuleSheet, differences, strangers
from onika.runtime.user_input import UserInput
from onika.runtime.wiring import WiredTask, disagreements, missing_constants, wire
from onika.wire.plan import Code, Plan, PlannedFlow, PlannedTask
from onika.wire.request import TargetValues
from onika.words.fault import Fault, Place

NOT_RUN = "the application is not run"

_SLOWEST_HZ = 1e-3
_FASTEST_HZ = 1e6
"""No task cycles more often; and no period rounds to nothing."""


class Loading(Protocol):
    """Where module code is executed to learn of it: a process of its own."""

    def sheet(self, code: Code) -> ModuleSheet | Fault:
        """The sheet of a module's class."""
        ...

    def constants(self, code: Code, local: tuple[tuple[str, tuple[str, ...]], ...]) -> dict[str, Any] | Fault:
        """A robot module's constants from its LOCAL lines; empty for any other."""
        ...

    def devices(self, world: str) -> tuple[str, ...] | Fault:
        """The devices of a world."""
        ...

    def resolve(
        self, code: Code, constants: dict[str, Any], targets: list[tuple[str, list[Any]]]
    ) -> list[str | None] | Fault:
        """Why each target is out of reach, or None."""
        ...


@dataclass(slots=True)
class Preparation:
    """A plan with what its modules say; it can run if there is no fault."""

    plan: Plan
    code: dict[str, Code] = field(default_factory=dict)
    flows: list[list[WiredTask]] = field(default_factory=list)
    triggers: dict[tuple[int, int], str | None] = field(default_factory=dict)
    constants: dict[int, dict[str, Any]] = field(default_factory=dict)
    """By flow: what robot modules say of themselves before they live, by variable."""
    faults: list[Fault] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)


def prepare(plan: Plan, targets: Sequence[TargetValues], loading: Loading) -> Preparation:
    """Look at every module, task, flow, argument line and target of a plan."""
    found = Preparation(plan, {code.digest: code for code in plan.code})
    sheets = _sheets(plan.code, loading, found.faults)
    for number, flow in enumerate(plan.flows):
        wired = _wired(flow, sheets, found)
        found.flows.append(wired)
        if len(wired) == len(flow.tasks):  # else every further word would only repeat what is missing
            found.faults += disagreements(wired) + missing_constants(wired) + _conflicts(wired) + _cycles(wired)
        _actions(number, flow, wired, found)
        _rates(flow, sheets, found)
        _values(number, flow, wired, targets, loading, found)
    found.faults += _shared_devices(
        [wire(task, sheets[task.digest]) for flow in plan.flows for task in flow.tasks if task.digest in sheets]
    )
    found.faults += _absent_devices(found.flows, loading)
    found.faults = sorted(set(found.faults))
    found.notes = list(dict.fromkeys(found.notes))
    return found


def inspect(tasks: Sequence[PlannedTask], code: Sequence[Code], loading: Loading) -> tuple[list[Fault], list[str]]:
    """Check tasks against their modules, each by itself: faults, and what is only worth knowing."""
    faults: list[Fault] = []
    notes: list[str] = []
    sheets = _sheets(code, loading, faults)
    for task in tasks:
        if task.digest in sheets:
            faults += differences(_task(task), sheets[task.digest], Place(task.place))
            notes += unknown_parameters(task, sheets[task.digest])
    return sorted(set(faults)), notes


def _sheets(codes: Sequence[Code], loading: Loading, faults: list[Fault]) -> dict[str, ModuleSheet]:
    sheets = {}
    for code in codes:
        sheet = loading.sheet(code)
        if isinstance(sheet, Fault):
            faults.append(sheet)
        else:
            sheets[code.digest] = sheet
    return sheets


def _wired(flow: PlannedFlow, sheets: Mapping[str, ModuleSheet], found: Preparation) -> list[WiredTask]:
    wired = []
    for task in flow.tasks:
        sheet = sheets.get(task.digest)
        if sheet is None:
            continue  # its module's fault is told already
        wrong = differences(_task(task), sheet, Place(task.place))
        found.faults += wrong
        found.notes += unknown_parameters(task, sheet)
        if not wrong:
            wired.append(wire(task, sheet))
    return wired


def unknown_parameters(task: PlannedTask, sheet: ModuleSheet) -> list[str]:
    """LOCAL lines that say nothing to the module."""
    return [
        f"{task.place}: LOCAL {name} is no parameter of module {task.module}; it is kept and not used"
        for name in strangers(_task(task), sheet)
    ]


def _conflicts(wired: Sequence[WiredTask]) -> list[Fault]:
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


def _cycles(wired: Sequence[WiredTask]) -> list[Fault]:
    _, cycles = constant_order([one.meeting for one in wired])
    return [
        Fault(Place(wired[0].task.place), "constants that do not wait for each other", " → ".join(cycle), NOT_RUN)
        for cycle in cycles
    ]


def _shared_devices(tasks: Sequence[WiredTask]) -> list[Fault]:
    """A device that takes commands is claimed by one task, over all flows."""
    claimed: dict[str, WiredTask] = {}
    faults = []
    for one in (one for one in tasks if one.sheet.hardware and one.device):
        other = claimed.setdefault(one.device or "", one)
        if other is not one:
            faults.append(_union(one, f"device {one.device} for one task", f"task {other.name} claims it too"))
    return faults


def _absent_devices(flows: Sequence[Sequence[WiredTask]], loading: Loading) -> list[Fault]:
    """Devices that no world has."""
    faults = []
    for one in (one for flow in flows for one in flow if one.device):
        world, _, name = (one.device or "").partition(":")
        known = loading.devices(world)
        if isinstance(known, Fault):
            faults.append(Fault(Place(one.task.place), known.expected, f"DEVICE {one.device}", NOT_RUN))
        elif name not in known:
            expected = f"a device of world {world} ({', '.join(known)})"
            faults.append(Fault(Place(one.task.place), expected, f"DEVICE {one.device}", NOT_RUN))
    return faults


def _actions(number: int, flow: PlannedFlow, wired: Sequence[WiredTask], found: Preparation) -> None:
    """Each action's trigger: the first in its configuration (decision 16)."""
    by_name = {one.name: one for one in wired}
    for index, action in enumerate(flow.actions):
        present = [by_name[name] for name in action.tasks if name in by_name]
        triggers = [one.name for one in present if one.sheet.trigger]
        found.triggers[number, index] = triggers[0] if triggers else None
        if not triggers and len(present) == len(action.tasks) and not action.lacks_tasks:
            place = Place(action.place, action.line)
            found.faults.append(Fault(place, f"a trigger that ends job {action.job}", "none", NOT_RUN))
        if len(triggers) > 1:
            others = ", ".join(triggers[1:])
            found.notes.append(
                f"{Place(action.place, action.line)}: {action.job} ends with {triggers[0]}; {others} is a trigger too"
            )


def _rates(flow: PlannedFlow, sheets: Mapping[str, ModuleSheet], found: Preparation) -> None:
    """Rates that configurations or tasks give: a period of whole nanoseconds, for hardware short enough (law 17)."""
    hardware = {task.name for task in flow.tasks if task.digest in sheets and sheets[task.digest].hardware}
    given = [
        (Place(action.place, action.line), f" in {action.job}", name, hz)
        for action in flow.actions
        for name, hz in action.rates
    ]
    given += [(Place(task.place), "", task.name, task.frequency) for task in flow.tasks if task.frequency is not None]
    for place, where, name, hz in given:
        if not _SLOWEST_HZ <= hz <= _FASTEST_HZ:
            expected = f"{_SLOWEST_HZ:g} Hz to {_FASTEST_HZ:g} Hz for {name}{where}"
            found.faults.append(Fault(place, expected, f"{hz:g} Hz", NOT_RUN))
        elif hz < SLOWEST_HARDWARE_HZ and name in hardware and where:  # without: told as a difference to its module
            expected = f"hardware task {name}{where} at {SLOWEST_HARDWARE_HZ:g} Hz or more"
            found.faults.append(Fault(place, expected, f"{hz:g} Hz", NOT_RUN))


def _values(
    number: int,
    flow: PlannedFlow,
    wired: Sequence[WiredTask],
    targets: Sequence[TargetValues],
    loading: Loading,
    found: Preparation,
) -> None:
    """Argument lines against the triggers' inputs, and the reach of every target."""
    constants: dict[str, Any] = {}
    robots = []
    for one in (one for one in wired if one.sheet.hardware):
        code = found.code[one.task.digest]
        published = loading.constants(code, one.task.local)
        if isinstance(published, Fault):
            found.faults.append(published)
            continue
        aliases = dict(one.task.aliases)
        constants |= {aliases.get(name, name): value for name, value in published.items()}
        if published:
            robots.append((one, code, published))
    found.constants[number] = constants
    found.faults += _shapeless(wired, constants)
    refused = _arguments(number, flow, wired, constants, found)
    for one, code, published in robots:
        users = [
            target
            for target in targets
            if target.flow == number and target.action not in refused and one.name in flow.actions[target.action].tasks
        ]
        _reach(flow, users, loading.resolve(code, published, [(t.kind, list(t.values)) for t in users]), found)


def _shapeless(wired: Sequence[WiredTask], constants: Mapping[str, Any]) -> list[Fault]:
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


def _arguments(
    number: int, flow: PlannedFlow, wired: Sequence[WiredTask], constants: dict[str, Any], found: Preparation
) -> set[int]:
    by_name = {one.name: one for one in wired}
    refused = set()
    for index, action in enumerate(flow.actions):
        trigger = by_name.get(found.triggers.get((number, index)) or "")
        if trigger is None or not action.arguments:
            continue
        coded = {port: constants[svar] for port, svar in _coded(trigger).items() if svar in constants}
        try:
            UserInput(trigger.sheet.inputs, coded).parse(action.arguments)
        except KeyError:
            continue  # a bound that only a running task supplies: seen at the run
        except ValueError as wrong:
            refused.add(index)
            target = action.target or action.job
            found.faults.append(
                Fault(Place(action.place, action.line), f"values for {trigger.name}", f"{target}: {wrong}", NOT_RUN)
            )
    return refused


def _coded(wired: WiredTask) -> dict[str, str]:
    return {port.port: port.svar for port in wired.ports if port.kind.at_init and port.kind.is_input}


def _reach(
    flow: PlannedFlow, users: Sequence[TargetValues], reasons: list[str | None] | Fault, found: Preparation
) -> None:
    if isinstance(reasons, Fault):
        found.faults.append(reasons)
        return
    for target, reason in zip(users, reasons, strict=True):
        if reason is not None:
            action = flow.actions[target.action]
            found.faults.append(
                Fault(Place(action.place, action.line), "a target within reach", f"{action.target}: {reason}", NOT_RUN)
            )


def _task(planned: PlannedTask) -> Task:
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
