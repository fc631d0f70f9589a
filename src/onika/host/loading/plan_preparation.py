"""What can be found wrong with a plan before anything moves, from its modules: all at once (E01, laws 24 to 26)."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from onika.host.loading.module_questions import ModuleQuestions
from onika.host.loading.plan_checks import (
    absent_devices,
    at_action,
    conflicts,
    cycles,
    note_at,
    remarks,
    shared_devices,
    unfit_together,
    wrong_rates,
)
from onika.host.loading.plan_conditions import wrong_conditions
from onika.host.loading.plan_form import wrong_code, wrong_plan, wrong_tasks, wrong_worlds
from onika.host.loading.stated_constants import stated_constants
from onika.host.loading.target_order import in_order
from onika.host.loading.target_resolution import Resolution, notes_on_resolved, resolve
from onika.host.loading.world_kinds import driven_kinds
from onika.model.planned import task_of
from onika.runtime.modules.sheet import differences, strangers
from onika.runtime.user_input import UserInput
from onika.runtime.wiring import WiredTask, disagreements, missing_constants, wire
from onika.wire.plan import Code, Plan, PlannedFlow, PlannedTask
from onika.wire.request import Resolved, TargetValues
from onika.wire.sheet import ModuleSheet
from onika.wire.world_source import WorldSource
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.reason import Reason, reason_of


@dataclass(slots=True)
class Preparation:
    """A plan with what its modules say; it can run if there is no fault."""

    plan: Plan
    code: dict[str, Code]
    faults: list[Fault]
    flows: list[list[WiredTask]] = field(default_factory=list)
    triggers: dict[tuple[int, int], str | None] = field(default_factory=dict)
    constants: dict[int, dict[str, Any]] = field(default_factory=dict)
    """By flow: what robot modules say of themselves before they live, by variable."""
    resolved: list[Resolved] = field(default_factory=list)
    """Joint targets that other robots take by way of their poses."""
    worlds: dict[str, bool] = field(default_factory=dict)
    """The worlds that it drives: whether they are simulated."""
    notes: list[Reason] = field(default_factory=list)


def prepare(plan: Plan, targets: Sequence[TargetValues], loading: ModuleQuestions) -> Preparation:
    """Look at every module, task, flow, argument line and target of a plan."""
    preparation = Preparation(plan, {code.digest: code for code in plan.code}, wrong_plan(plan, targets))
    if preparation.faults:
        return preparation  # nothing else of it is believed
    loading.offer(plan.worlds)
    loading.expect(plan.code)
    used = {task.digest for flow in plan.flows for task in flow.tasks}
    sheets = _sheets([code for code in plan.code if code.digest in used], loading, preparation.faults)
    resolution = resolve(plan, targets, sheets, loading)
    preparation.plan = plan = resolution.plan
    preparation.resolved = resolution.resolved
    preparation.faults += resolution.faults
    preparation.notes += notes_on_resolved(plan, resolution.resolved)
    for number, flow in enumerate(plan.flows):
        _flow(number, flow, sheets, resolution, loading, preparation)
    preparation.faults += shared_devices(
        [wire(task, sheets[task.digest]) for flow in plan.flows for task in flow.tasks if task.digest in sheets]
    )
    if [len(wired) for wired in preparation.flows] == [len(flow.tasks) for flow in plan.flows]:
        preparation.faults += wrong_conditions(plan.flows, preparation.flows, preparation.constants)
    everyone = [wired_task for flow in preparation.flows for wired_task in flow]
    _worlds(plan, everyone, loading, preparation)
    preparation.faults += unfit_together(everyone, loading)
    preparation.worlds = driven_kinds(everyone, loading)
    preparation.faults = sorted(set(preparation.faults))
    preparation.notes = list(dict.fromkeys(preparation.notes))
    return preparation


def _worlds(plan: Plan, everyone: Sequence[WiredTask], loading: ModuleQuestions, preparation: Preparation) -> None:
    """Devices that are nowhere; and what is wrong with the files of worlds, which is a fault where it has taken one."""
    absent = absent_devices(everyone, loading)
    found = [fault for files in plan.worlds for fault in loading.world_faults(files.world)]
    preparation.faults += absent + (found if absent else [])
    preparation.notes += [] if absent else [fault.sentence for fault in found]


def _flow(
    number: int,
    flow: PlannedFlow,
    sheets: Mapping[str, ModuleSheet],
    resolution: Resolution,
    loading: ModuleQuestions,
    preparation: Preparation,
) -> None:
    """Look at the tasks, actions, rates and targets of one flow."""
    wired = _wired(flow, sheets, preparation)
    preparation.flows.append(wired)
    preparation.notes += remarks(wired, loading)
    if len(wired) == len(flow.tasks):  # else every further word would only repeat what is missing
        preparation.faults += disagreements(wired) + missing_constants(wired) + conflicts(wired) + cycles(wired)
    _actions(number, flow, wired, preparation)
    _rates(flow, sheets, preparation)
    refused = {action for flow_of, action in resolution.refused if flow_of == number}
    targets = [target for target in resolution.targets if target.flow == number]
    _values(number, flow, wired, targets, loading, preparation, refused)


def inspect(
    tasks: Sequence[PlannedTask], code: Sequence[Code], loading: ModuleQuestions, worlds: Sequence[WorldSource] = ()
) -> tuple[list[Fault], list[Reason]]:
    """Check tasks against their modules, each by itself, and worlds of files: faults, and what is worth knowing."""
    faults = wrong_code(code) + wrong_tasks(tasks, [one.digest for one in code]) + wrong_worlds(worlds)
    notes: list[Reason] = []
    if faults:
        return sorted(set(faults)), notes
    loading.offer(worlds)
    faults = [fault for source in worlds for fault in loading.world_faults(source.world)]
    sheets = _sheets(code, loading, faults)
    for task in tasks:
        if task.digest in sheets:
            faults += differences(task_of(task), sheets[task.digest], Place(task.place))
            notes += unknown_parameters(task, sheets[task.digest])
    return sorted(set(faults)), notes


def _sheets(codes: Sequence[Code], loading: ModuleQuestions, faults: list[Fault]) -> dict[str, ModuleSheet]:
    sheets = {}
    for code in codes:
        sheet = loading.sheet(code)
        if isinstance(sheet, Fault):
            faults.append(sheet)
        else:
            sheets[code.digest] = sheet
    return sheets


def _wired(flow: PlannedFlow, sheets: Mapping[str, ModuleSheet], preparation: Preparation) -> list[WiredTask]:
    wired = []
    for task in flow.tasks:
        sheet = sheets.get(task.digest)
        if sheet is None:
            continue  # its module's fault is told already
        wrong = differences(task_of(task), sheet, Place(task.place))
        preparation.faults += wrong
        preparation.notes += unknown_parameters(task, sheet)
        if not wrong:
            wired.append(wire(task, sheet))
    return wired


def unknown_parameters(task: PlannedTask, sheet: ModuleSheet) -> list[Reason]:
    """LOCAL lines that say nothing to the module."""
    return [
        note_at(Place(task.place), Reason.of("host.parameter_unknown", name=name, module=task.module))
        for name in strangers(task_of(task), sheet)
    ]


def _actions(number: int, flow: PlannedFlow, wired: Sequence[WiredTask], preparation: Preparation) -> None:
    """Each action's trigger: the first in its configuration (reading 16)."""
    by_name = {wired_task.name: wired_task for wired_task in wired}
    for index, action in enumerate(flow.actions):
        if action.is_noop:
            preparation.triggers[number, index] = None
            continue
        present = [by_name[name] for name in action.tasks if name in by_name]
        triggers = [wired_task.name for wired_task in present if wired_task.sheet.trigger]
        preparation.triggers[number, index] = triggers[0] if triggers else None
        if not triggers and len(present) == len(action.tasks) and not action.lacks_tasks:
            preparation.faults.append(
                at_action(preparation.plan, number, index, Reason.of("host.trigger_missing", job=action.job))
            )
        if len(triggers) > 1:
            others = ", ".join(triggers[1:])
            note = Reason.of("host.triggers_more", job=action.job, trigger=triggers[0], others=others)
            preparation.notes.append(note_at(Place(action.place, action.line), note))


def _rates(flow: PlannedFlow, sheets: Mapping[str, ModuleSheet], preparation: Preparation) -> None:
    """Rates that configurations or tasks give: a period of whole nanoseconds, for hardware short enough (law 17)."""
    hardware = {task.name for task in flow.tasks if task.digest in sheets and sheets[task.digest].hardware}
    given = [
        (Place(action.place, action.line), action.job, name, hz) for action in flow.actions for name, hz in action.rates
    ]
    given += [(Place(task.place), "", task.name, task.frequency) for task in flow.tasks if task.frequency is not None]
    preparation.faults += wrong_rates(given, hardware, NOT_RUN)


def _values(
    number: int,
    flow: PlannedFlow,
    wired: Sequence[WiredTask],
    targets: Sequence[TargetValues],
    loading: ModuleQuestions,
    preparation: Preparation,
    refused: Collection[int],
) -> None:
    """Argument lines against the triggers' inputs, and the reach of every target.

    refused   the actions of whose targets it is said already that they are none for this robot
    """
    stated = stated_constants(wired, preparation.code, loading)
    preparation.constants[number] = constants = stated.constants
    preparation.faults += stated.faults
    wrong, counted = _arguments(number, flow, wired, constants, preparation.plan, preparation.triggers)
    wrong = {index: fault for index, fault in wrong.items() if index not in refused}
    counted -= set(refused)
    for wired_task, code, published in stated.robots:
        users = [
            target
            for target in targets
            if target.action in counted and wired_task.name in flow.actions[target.action].tasks
        ]
        questions, places = in_order(flow, wired_task.name, users)
        reasons = loading.resolve(code, published, questions)
        known = reasons if isinstance(reasons, Fault) else [reasons[place] for place in places]
        _reach(number, users, known, preparation, wrong)
    preparation.faults += wrong.values()


def _arguments(
    number: int,
    flow: PlannedFlow,
    wired: Sequence[WiredTask],
    constants: dict[str, Any],
    plan: Plan,
    triggers: Mapping[tuple[int, int], str | None],
) -> tuple[dict[int, Fault], set[int]]:
    """What is wrong with the argument line of each action; the actions whose lines have as many values as are taken."""
    by_name: dict[str | None, WiredTask] = {wired_task.name: wired_task for wired_task in wired}
    wrong: dict[int, Fault] = {}
    counted = set()
    inputs: dict[str, UserInput] = {}
    for index, action in enumerate(flow.actions):
        trigger = by_name.get(triggers.get((number, index)))
        if trigger is None or not action.arguments:
            counted.add(index)
            continue
        try:
            if trigger.name not in inputs:
                coded = {port.port: constants[port.svar] for port in trigger.ports if port.svar in constants}
                inputs[trigger.name] = UserInput(trigger.sheet.inputs, coded)
            user_input = inputs[trigger.name]
            if user_input.takes(action.arguments):
                counted.add(index)
            user_input.parse(action.arguments)
        except KeyError:
            counted.add(index)  # a bound that only a running task supplies: seen at the run
        except ValueError as error:
            target, why = action.target or action.job, reason_of(error)
            reason = Reason.of("host.values_unfit", task=trigger.name, target=target, why=why)
            wrong[index] = at_action(plan, number, index, reason)
    return wrong, counted


def _reach(
    number: int,
    users: Sequence[TargetValues],
    reasons: list[Reason | None] | Fault,
    preparation: Preparation,
    wrong: dict[int, Fault],
) -> None:
    """Targets out of reach; what is said of one so is not said again of its values."""
    if isinstance(reasons, Fault):
        preparation.faults.append(reasons)
        return
    for target, reason in zip(users, reasons, strict=True):
        if reason is not None:
            wrong.pop(target.action, None)
            name = preparation.plan.flows[number].actions[target.action].target or ""
            unreachable = Reason.of("host.unreachable", target=name, why=reason)
            preparation.faults.append(at_action(preparation.plan, number, target.action, unreachable))
