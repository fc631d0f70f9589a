"""What can be found wrong with a plan before anything moves, from its modules: all at once (E01, laws 24 to 26)."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from onika.host.loading.module_questions import Loading
from onika.host.loading.plan_checks import (
    absent_devices,
    at_action,
    conflicts,
    cycles,
    remarks,
    shapeless,
    shared_devices,
    unfit,
    unfit_together,
    wrong_rates,
)
from onika.host.loading.plan_conditions import wrong_conditions
from onika.host.loading.target_resolution import resolve, told
from onika.model.planned import task_of
from onika.runtime.sheet import differences, strangers
from onika.runtime.user_input import UserInput
from onika.runtime.wiring import WiredTask, disagreements, missing_constants, wire
from onika.wire.plan import Code, Plan, PlannedFlow, PlannedTask
from onika.wire.request import Resolved, TargetValues
from onika.wire.sheet import ModuleSheet
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import Reason, reason_of


@dataclass(slots=True)
class Preparation:
    """A plan with what its modules say; it can run if there is no fault."""

    plan: Plan
    code: dict[str, Code] = field(default_factory=dict)
    flows: list[list[WiredTask]] = field(default_factory=list)
    triggers: dict[tuple[int, int], str | None] = field(default_factory=dict)
    constants: dict[int, dict[str, Any]] = field(default_factory=dict)
    """By flow: what robot modules say of themselves before they live, by variable."""
    resolved: list[Resolved] = field(default_factory=list)
    """Joint targets that other robots take by way of their poses."""
    faults: list[Fault] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)


def prepare(plan: Plan, targets: Sequence[TargetValues], loading: Loading) -> Preparation:
    """Look at every module, task, flow, argument line and target of a plan."""
    found = Preparation(plan, {code.digest: code for code in plan.code})
    used = {task.digest for flow in plan.flows for task in flow.tasks}
    sheets = _sheets([code for code in plan.code if code.digest in used], loading, found.faults)
    resolution = resolve(plan, targets, sheets, loading)
    found.plan = plan = resolution.plan
    found.resolved = resolution.resolved
    found.faults += resolution.faults
    found.notes += told(plan, resolution.resolved)
    for number, flow in enumerate(plan.flows):
        wired = _wired(flow, sheets, found)
        found.flows.append(wired)
        found.notes += remarks(wired, loading)
        if len(wired) == len(flow.tasks):  # else every further word would only repeat what is missing
            found.faults += disagreements(wired) + missing_constants(wired) + conflicts(wired) + cycles(wired)
        _actions(number, flow, wired, found)
        _rates(flow, sheets, found)
        refused = {action for flow_of, action in resolution.refused if flow_of == number}
        _values(number, flow, wired, [one for one in resolution.targets if one.flow == number], loading, found, refused)
    found.faults += shared_devices(
        [wire(task, sheets[task.digest]) for flow in plan.flows for task in flow.tasks if task.digest in sheets]
    )
    if all(len(wired) == len(flow.tasks) for wired, flow in zip(found.flows, plan.flows, strict=True)):
        found.faults += wrong_conditions(plan.flows, found.flows, found.constants)
    everyone = [one for flow in found.flows for one in flow]
    found.faults += absent_devices(everyone, loading) + unfit_together(everyone, loading)
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
            faults += differences(task_of(task), sheets[task.digest], Place(task.place))
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
        wrong = differences(task_of(task), sheet, Place(task.place))
        found.faults += wrong
        found.notes += unknown_parameters(task, sheet)
        if not wrong:
            wired.append(wire(task, sheet))
    return wired


def unknown_parameters(task: PlannedTask, sheet: ModuleSheet) -> list[str]:
    """LOCAL lines that say nothing to the module."""
    return [
        f"{task.place}: LOCAL {name} is no parameter of module {task.module}; it is kept and not used"
        for name in strangers(task_of(task), sheet)
    ]


def _actions(number: int, flow: PlannedFlow, wired: Sequence[WiredTask], found: Preparation) -> None:
    """Each action's trigger: the first in its configuration (reading 16)."""
    by_name = {one.name: one for one in wired}
    for index, action in enumerate(flow.actions):
        if action.is_noop:
            found.triggers[number, index] = None
            continue
        present = [by_name[name] for name in action.tasks if name in by_name]
        triggers = [one.name for one in present if one.sheet.trigger]
        found.triggers[number, index] = triggers[0] if triggers else None
        if not triggers and len(present) == len(action.tasks) and not action.lacks_tasks:
            found.faults.append(at_action(found.plan, number, index, Reason.of("host.trigger_missing", job=action.job)))
        if len(triggers) > 1:
            others = ", ".join(triggers[1:])
            found.notes.append(
                f"{Place(action.place, action.line)}: {action.job} ends with {triggers[0]}; {others} is a trigger too"
            )


def _rates(flow: PlannedFlow, sheets: Mapping[str, ModuleSheet], found: Preparation) -> None:
    """Rates that configurations or tasks give: a period of whole nanoseconds, for hardware short enough (law 17)."""
    hardware = {task.name for task in flow.tasks if task.digest in sheets and sheets[task.digest].hardware}
    given = [
        (Place(action.place, action.line), action.job, name, hz) for action in flow.actions for name, hz in action.rates
    ]
    given += [(Place(task.place), "", task.name, task.frequency) for task in flow.tasks if task.frequency is not None]
    found.faults += wrong_rates(given, hardware, NOT_RUN)


def _values(
    number: int,
    flow: PlannedFlow,
    wired: Sequence[WiredTask],
    targets: Sequence[TargetValues],
    loading: Loading,
    found: Preparation,
    refused: Collection[int],
) -> None:
    """Argument lines against the triggers' inputs, and the reach of every target.

    refused   the actions of whose targets it is said already that they are none for this robot
    """
    constants: dict[str, Any] = {}
    robots = []
    for one in (one for one in wired if one.device and not one.sheet.hardware):
        found.faults += unfit(one, found.code[one.task.digest], {}, loading)
    for one in (one for one in wired if one.sheet.hardware):
        code = found.code[one.task.digest]
        published = loading.constants(code, one.task.local)
        if isinstance(published, Fault):
            found.faults.append(published)
            continue
        aliases = dict(one.task.aliases)
        constants |= {aliases.get(name, name): value for name, value in published.items()}
        found.faults += unfit(one, code, published, loading)
        if published:
            robots.append((one, code, published))
    found.constants[number] = constants
    found.faults += shapeless(wired, constants)
    wrong, counted = _arguments(number, flow, wired, constants, found.plan, found.triggers)
    wrong = {index: fault for index, fault in wrong.items() if index not in refused}
    counted -= set(refused)
    for one, code, published in robots:
        users = [
            target for target in targets if target.action in counted and one.name in flow.actions[target.action].tasks
        ]
        reasons = loading.resolve(code, published, [(t.kind, list(t.values)) for t in users])
        _reach(number, users, reasons, found, wrong)
    found.faults += wrong.values()


def _arguments(
    number: int,
    flow: PlannedFlow,
    wired: Sequence[WiredTask],
    constants: dict[str, Any],
    plan: Plan,
    triggers: Mapping[tuple[int, int], str | None],
) -> tuple[dict[int, Fault], set[int]]:
    """What is wrong with the argument line of each action; the actions whose lines have as many values as are taken."""
    by_name = {one.name: one for one in wired}
    wrong: dict[int, Fault] = {}
    counted = set()
    inputs: dict[str, UserInput] = {}
    for index, action in enumerate(flow.actions):
        trigger = by_name.get(triggers.get((number, index)) or "")
        if trigger is None or not action.arguments:
            counted.add(index)
            continue
        try:
            if trigger.name not in inputs:
                coded = {port: constants[svar] for port, svar in _coded(trigger).items() if svar in constants}
                inputs[trigger.name] = UserInput(trigger.sheet.inputs, coded)
            known = inputs[trigger.name]
            if known.takes(action.arguments):
                counted.add(index)
            known.parse(action.arguments)
        except KeyError:
            counted.add(index)  # a bound that only a running task supplies: seen at the run
        except ValueError as error:
            target, why = action.target or action.job, reason_of(error)
            reason = Reason.of("host.values_unfit", task=trigger.name, target=target, why=why)
            wrong[index] = at_action(plan, number, index, reason)
    return wrong, counted


def _coded(wired: WiredTask) -> dict[str, str]:
    return {port.port: port.svar for port in wired.ports if port.kind.at_init and port.kind.is_input}


def _reach(
    number: int,
    users: Sequence[TargetValues],
    reasons: list[str | None] | Fault,
    found: Preparation,
    wrong: dict[int, Fault],
) -> None:
    """Targets out of reach; what is said of one so is not said again of its values."""
    if isinstance(reasons, Fault):
        found.faults.append(reasons)
        return
    for target, reason in zip(users, reasons, strict=True):
        if reason is not None:
            wrong.pop(target.action, None)
            name = found.plan.flows[number].actions[target.action].target or ""
            unreachable = Reason.of("host.unreachable", target=name, why=reason)
            found.faults.append(at_action(found.plan, number, target.action, unreachable))
