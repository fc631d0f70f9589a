"""What a plan, a task and a piece of code must be before any module is asked about them: names, numbers, references.

An environment of ours never sends anything else. A runtime does not rely on that: whatever a plan says is judged here
before it is believed, so that what is executed later finds every task, action and place it is told of (law 24).
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from hashlib import sha256
from math import isfinite

from onika.engine.program import FlowProgram
from onika.model.task import TaskType
from onika.wire.plan import Code, Fork, Join, Meet, Plan, PlannedAction, PlannedFlow, PlannedTask, Rest
from onika.wire.request import TargetValues
from onika.wire.world_source import WorldSource, digest_of
from onika.words.fault import NOT_RUN, Fault, Place
from onika.words.name import SVAR_NAME, TASK_NAME
from onika.words.reason import NOTHING, Argument, Reason, reason_of

_LONGEST = 4096
"""Letters of a text that is no source of a module."""
_SHOWN = 80
"""Letters of a text that are told when it is wrong."""
_MOST_ACTIONS = 20_000


def wrong_plan(plan: Plan, targets: Sequence[TargetValues]) -> list[Fault]:
    """Everything about a plan that no environment would send."""
    place = Place(shown(plan.application) or "plan")
    reasons = [*_text(plan.application, "application")]
    if not plan.application:
        reasons.append(Reason.of("host.plan_unnamed"))
    if not plan.flows:
        reasons.append(Reason.of("host.plan_empty"))
    names = [flow.subsystem for flow in plan.flows]
    reasons += [
        Reason.of("host.subsystem_twice", name=shown(name)) for name in sorted({*names}) if names.count(name) > 1
    ]
    faults = [Fault(place, reason, NOT_RUN) for reason in reasons]
    faults += wrong_code(plan.code) + wrong_worlds(plan.worlds)
    digests = {code.digest for code in plan.code}
    for number, flow in enumerate(plan.flows):
        replaced = [task for _, task in flow.replaced]
        faults += wrong_tasks(flow.tasks, digests)
        faults += wrong_tasks(replaced, {task.digest for task in replaced})  # not executed: no code is needed
        faults += [Fault(place, reason, NOT_RUN) for reason in _flow(number, flow, plan)]
    if not faults:
        faults += [Fault(place, reason, NOT_RUN) for reason in _references(plan, targets)]
    return faults


def wrong_tasks(tasks: Iterable[PlannedTask], digests: Iterable[str]) -> list[Fault]:
    """Tasks that no `.rmod` file could describe, or whose code is not among `digests`."""
    known = {*digests}
    return [Fault(Place(shown(task.place)), reason, NOT_RUN) for task in tasks for reason in _task(task, known)]


def wrong_code(codes: Iterable[Code]) -> list[Fault]:
    """Code whose module has no name of one, or whose digest is not that of its source: another's would be executed."""
    faults = []
    for code in codes:
        reasons = [*_name(code.module, "module"), *_text(code.path, "path")]
        if sha256(code.source.encode("utf-8", "surrogatepass")).hexdigest() != code.digest:
            reasons.append(Reason.of("host.digest_wrong", module=shown(code.module)))
        faults += [Fault(Place(shown(code.path)), reason, NOT_RUN) for reason in reasons]
    return faults


def wrong_worlds(worlds: Iterable[WorldSource]) -> list[Fault]:
    """Worlds of files without a name of one, or whose digest is not that of their files."""
    faults = []
    for files in worlds:
        reasons = [*_name(files.world, "world")]
        if digest_of(files.files) != files.digest:
            reasons.append(Reason.of("host.digest_of_world_wrong", world=shown(files.world)))
        faults += [Fault(Place(shown(files.world)), reason, NOT_RUN) for reason in reasons]
    return faults


def wrong_name(name: str, what: str) -> Reason:
    """Why this is no name of a subsystem, task, unit or module; empty: it is one."""
    return next(_name(name, what), NOTHING)


def shown(text: str) -> str:
    """A text of somebody else, short and without control characters."""
    printable = "".join(letter if letter.isprintable() else "?" for letter in text[: _SHOWN + 1])
    return printable if len(text) <= _SHOWN else f"{printable[:_SHOWN]}…"


def _task(task: PlannedTask, digests: set[str]) -> Iterator[Reason]:
    yield from _name(task.name, "task")
    yield from _name(task.module, "module")
    yield from _name(task.rtpu, "rtpu")
    yield from _text(task.place, "place")
    if task.digest not in digests:
        yield Reason.of("host.code_missing", task=shown(task.name), module=shown(task.module))
    if task.type not in {kind.value for kind in TaskType}:
        types = tuple(kind.value for kind in TaskType)
        yield Reason.of("host.task_type", task=shown(task.name), types=types, type=shown(task.type))
    if task.frequency is not None and not isfinite(task.frequency):
        yield Reason.of("host.rate_infinite", task=shown(task.name))
    for name in (
        *task.inconst,
        *task.outconst,
        *task.invar,
        *task.outvar,
        *(name for pair in task.aliases for name in pair),
    ):
        if not SVAR_NAME.match(name) or len(name) > _LONGEST:
            yield Reason.of("host.variable_name", task=shown(task.name), name=shown(name))
    for key, words in task.local:
        for word in (key, *words):
            yield from _text(word, "local")


def _flow(number: int, flow: PlannedFlow, plan: Plan) -> Iterator[Reason]:
    """What is wrong with a flow by itself."""
    yield from _name(flow.subsystem, "subsystem")
    names = [task.name for task in flow.tasks]
    yield from (Reason.of("host.flow_task_twice", name=shown(name)) for name in _doubled(names))
    yield from (reason for name, _ in flow.replaced for reason in _name(name, "task"))
    if flow.parent is not None and not (0 <= flow.parent < len(plan.flows) and flow.parent != number):
        yield _outside("parent", flow.parent, len(plan.flows))
    if len(flow.actions) > _MOST_ACTIONS:
        yield Reason.of("host.actions_many", most=_MOST_ACTIONS, count=len(flow.actions))
    for action in flow.actions:
        yield from _action(action, {*names})
    yield from _program(flow)


def _program(flow: PlannedFlow) -> Iterator[Reason]:
    for instruction in flow.program:
        if isinstance(instruction, Rest) and not -1 <= instruction.action < len(flow.actions):
            yield _outside("action", instruction.action, len(flow.actions))
        if isinstance(instruction, Meet):
            yield from _text(instruction.tag, "tag")
    try:
        FlowProgram(flow)
    except ValueError as error:
        yield reason_of(error)


def _action(action: PlannedAction, tasks: set[str]) -> Iterator[Reason]:
    for text in (action.name, action.job, action.target or "", action.place, action.synch_tag or "", *action.within):
        yield from _text(text, "action")
    yield from _text(action.arguments, "arguments")
    strangers = sorted({*action.tasks, *(name for name, _ in action.rates)} - tasks)
    if strangers:
        yield Reason.of("host.action_tasks", action=shown(action.name), names=tuple(map(shown, strangers)))
    if len({*action.tasks}) < len(action.tasks):
        yield Reason.of("host.action_task_twice", action=shown(action.name))
    if not all(isfinite(hz) for _, hz in action.rates):
        yield Reason.of("host.rate_infinite", task=shown(action.name))


def _references(plan: Plan, targets: Sequence[TargetValues]) -> Iterator[Reason]:
    """What one flow or target says of another flow."""
    count = len(plan.flows)
    programs = [FlowProgram(flow) for flow in plan.flows]
    for number, flow in enumerate(plan.flows):
        for instruction in flow.program:
            if isinstance(instruction, Fork):
                for other, place in instruction.flows:
                    if not 0 <= other < count or other == number:
                        yield _outside("flow", other, count)
                    elif not 0 <= place < len(programs[other].instructions):
                        yield _outside("place", place, len(programs[other].instructions))
            if isinstance(instruction, Join):
                yield from (_outside("flow", other, count) for other in instruction.flows if not 0 <= other < count)
    for target in targets:
        if not 0 <= target.flow < count:
            yield _outside("flow", target.flow, count)
        elif not 0 <= target.action < len(plan.flows[target.flow].actions):
            yield _outside("action", target.action, len(plan.flows[target.flow].actions))


def _doubled(names: Sequence[str]) -> list[str]:
    return [name for name, count in Counter(names).items() if count > 1]


def _outside(what: str, number: int, count: int) -> Reason:
    return Reason.of("host.number_outside", what=what, count=count, number=number)


def _name(name: str, what: str) -> Iterator[Reason]:
    if not TASK_NAME.match(name):
        yield Reason.of("host.name_form", what=what, name=shown(name))


def _text(text: str, what: Argument) -> Iterator[Reason]:
    if len(text) > _LONGEST or "\0" in text:
        yield Reason.of("host.text_form", what=what, most=_LONGEST)
