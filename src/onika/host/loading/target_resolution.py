"""Joint targets for another robot than the one they were made for: re-resolved by way of the tool's pose (law 26).

The pose is what the replaced robot would bring its tool to. A target with whose values both robots come to one pose
stays as it is, as from a robot to its kinematic mode; any other becomes the posture nearest to the one before it.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any

from msgspec.structs import replace

from onika.host.loading.module_questions import ModuleQuestions
from onika.host.loading.plan_checks import at_action, note_at
from onika.runtime.user_input import UserInput
from onika.wire.plan import Code, Plan, PlannedAction, PlannedFlow, PlannedTask
from onika.wire.request import Resolved, TargetValues
from onika.wire.sheet import ModuleSheet
from onika.words import argument
from onika.words.fault import Fault, Place
from onika.words.reason import NOTHING, Reason, reason_of

JOINT = "joint object"
"""The type of target whose first NDOF values are those of joints (§A.7)."""
_SAME = 1e-9
"""Two poses that differ by no more, in m or in parts of a unit vector, are one."""

Values = tuple[Any, ...]


@dataclass(slots=True)
class Resolution:
    """A plan and its targets as the robots that stand in for others take them."""

    plan: Plan
    targets: list[TargetValues]
    resolved: list[Resolved] = field(default_factory=list)
    refused: set[tuple[int, int]] = field(default_factory=set)
    """The actions of targets that are none for the robot."""
    faults: list[Fault] = field(default_factory=list)


def resolve(
    plan: Plan, targets: Sequence[TargetValues], sheets: Mapping[str, ModuleSheet], loading: ModuleQuestions
) -> Resolution:
    """The plan with every joint target of a redirected robot resolved anew; as it is where nothing is redirected."""
    resolution = Resolution(plan, list(targets))
    if not any(flow.replaced for flow in plan.flows):
        return resolution
    code = {code.digest: code for code in plan.code}
    for number, flow in enumerate(plan.flows):
        tasks = {task.name: task for task in flow.tasks}
        for name, old in flow.replaced:
            new = tasks.get(name)
            if new is not None and new.digest in sheets and sheets[new.digest].hardware:
                _Pair(number, flow, old, new, code, sheets, loading, resolution).resolve()
    _rewrite(resolution)
    return resolution


class _Pair:
    """One robot that stands for another one in a flow."""

    def __init__(
        self,
        number: int,
        flow: PlannedFlow,
        old: PlannedTask,
        new: PlannedTask,
        code: Mapping[str, Code],
        sheets: Mapping[str, ModuleSheet],
        loading: ModuleQuestions,
        resolution: Resolution,
    ) -> None:
        self._number, self._flow, self._old, self._new = number, flow, old, new
        self._sheets = sheets
        self._code, self._loading, self._found = code, loading, resolution

    def resolve(self) -> None:
        """All its joint targets."""
        aims = [
            (at, target)
            for at, target in enumerate(self._found.targets)
            if target.flow == self._number
            and target.kind == JOINT
            and self._new.name in self._flow.actions[target.action].tasks
        ]
        ours = self._constants(self._new) if aims else None
        if not ours:
            return  # no robot that states anything, or told when its constants are looked at
        theirs = self._constants(self._old)
        if theirs is None:
            old = self._old.name
            self._refuse(aims, lambda target: Reason.of("host.robot_unknown", old=old, target=target))
        elif theirs != ours:  # else it is the same robot, in another mode
            self._transfer(aims, theirs, ours)

    def _constants(self, task: PlannedTask) -> dict[str, Any] | None:
        code = self._code.get(task.digest)
        constants = None if code is None else self._loading.constants(code, task.local)
        if isinstance(constants, dict) and constants:
            return constants
        return None

    def _transfer(self, aims: list[tuple[int, TargetValues]], theirs: dict[str, Any], ours: dict[str, Any]) -> None:
        """By way of the poses; what both take in the same way stays."""
        aims = list(self._counted(aims, theirs))
        values = [list(target.values) for _, target in aims]
        poses = self._poses(self._old, theirs, values)
        if poses is None:
            module = self._old.module
            self._refuse(aims, lambda target: Reason.of("host.poses_unknown", module=module, target=target))
            return
        kept = self._kept(values, poses, ours) if theirs.get("NDOF") == ours.get("NDOF") else set()
        changed = [k for k in range(len(aims)) if k not in kept]
        postures = self._loading.postures(self._code[self._new.digest], ours, [poses[k] for k in changed])
        if isinstance(postures, Fault):
            self._found.faults.append(postures)
        elif postures is None:
            lacking, module = [aims[k] for k in changed], self._new.module
            self._refuse(lacking, lambda target: Reason.of("host.postures_unknown", module=module, target=target))
        else:
            for k, posture in zip(changed, postures, strict=True):
                self._take(*aims[k], posture, theirs.get("NDOF", 0))

    def _counted(
        self, aims: list[tuple[int, TargetValues]], theirs: dict[str, Any]
    ) -> Iterator[tuple[int, TargetValues]]:
        """Those with as many values as the replaced robot takes; else a duration would be taken for a joint."""
        for at, aim in aims:
            wrong = self._miscounted(self._flow.actions[aim.action], theirs)
            if wrong:
                self._refuse([(at, aim)], partial(self._miscounted_at, wrong))
            elif len(aim.values) >= theirs.get("NDOF", 0):
                yield at, aim

    def _miscounted_at(self, why: Reason, target: str) -> Reason:
        return Reason.of("host.values_unfit", task=self._old.name, target=target, why=why)

    def _miscounted(self, action: PlannedAction, theirs: dict[str, Any]) -> Reason:
        """Why the argument line of an action has not as many values as its trigger takes for the replaced robot."""
        digests = {task.name: task.digest for task in self._flow.tasks}
        sheets = [self._sheets.get(digests.get(name, "")) for name in action.tasks]
        trigger = next((sheet for sheet in sheets if sheet is not None and sheet.trigger), None)
        if trigger is None or not action.arguments:
            return NOTHING
        try:
            user_input = UserInput(trigger.inputs, theirs)
            if not user_input.takes(action.arguments):
                user_input.parse(action.arguments)
        except KeyError:
            return NOTHING  # a bound that only a running task supplies
        except ValueError as wrong:
            return reason_of(wrong)
        return NOTHING

    def _poses(self, task: PlannedTask, constants: dict[str, Any], values: list[list[Any]]) -> list[list[float]] | None:
        poses = self._loading.poses(self._code[task.digest], constants, values)
        if isinstance(poses, Fault):
            self._found.faults.append(poses)
            return None
        return poses

    def _kept(self, values: list[list[Any]], poses: list[list[float]], ours: dict[str, Any]) -> set[int]:
        """The targets whose values bring the new robot to the same poses, within its limits."""
        code = self._code[self._new.digest]
        own = self._poses(self._new, ours, values)
        why = self._loading.resolve(code, ours, [(JOINT, value) for value in values])
        if own is None or isinstance(why, Fault):
            return set()
        return {
            k
            for k, (mine, theirs) in enumerate(zip(own, poses, strict=True))
            if why[k] is None and max(abs(a - b) for a, b in zip(mine, theirs, strict=True)) <= _SAME
        }

    def _take(self, at: int, aim: TargetValues, posture: list[float] | Reason, joints: int) -> None:
        if isinstance(posture, Reason):
            new, old = self._new.name, self._old.name
            self._refuse(
                [(at, aim)],
                lambda target: Reason.of("host.posture_missing", task=new, old=old, target=target, why=posture),
            )
            return
        values = (*posture, *aim.values[joints:])
        self._found.targets[at] = replace(aim, values=values)
        resolved = Resolved(aim.flow, aim.action, aim.name, self._new.name, self._old.name, aim.values, values)
        self._found.resolved.append(resolved)

    def _refuse(self, aims: list[tuple[int, TargetValues]], reason: Callable[[str], Reason]) -> None:
        """Refuse some targets, each for a reason that names it."""
        for _, aim in aims:
            self._found.refused.add((aim.flow, aim.action))
            target = aim.name or self._found.plan.flows[aim.flow].actions[aim.action].job
            self._found.faults.append(at_action(self._found.plan, aim.flow, aim.action, reason(target)))


def notes_on_resolved(plan: Plan, resolved: Sequence[Resolved]) -> Iterator[Reason]:
    """In words, once for all uses of a target: what became of it."""
    uses: dict[tuple[Any, ...], list[Resolved]] = {}
    for use in resolved:
        uses.setdefault((use.target, use.task, use.values), []).append(use)
    for (target, task, values), uses_of_target in uses.items():
        first = plan.flows[uses_of_target[0].flow].actions[uses_of_target[0].action]
        numbers = " ".join(f"{value:.4g}" if isinstance(value, float) else str(value) for value in values)
        count, old = len(uses_of_target), uses_of_target[0].instead_of
        note = (
            Reason.of("host.resolved_often", target=target, task=task, count=count, old=old, numbers=numbers)
            if count > 1
            else Reason.of("host.resolved", target=target, task=task, old=old, numbers=numbers)
        )
        yield note_at(Place(first.place, first.line), note)


def _rewrite(resolution: Resolution) -> None:
    """The argument lines of the actions whose targets are others now."""
    changed = {(resolved.flow, resolved.action) for resolved in resolution.resolved}
    lines: dict[tuple[int, int], list[str]] = {address: [] for address in changed}
    for target in resolution.targets:
        if (target.flow, target.action) in changed:
            lines[target.flow, target.action] += (_shown(value) for value in target.values)
    flows = []
    for number, flow in enumerate(resolution.plan.flows):
        actions = tuple(
            replace(action, arguments=argument.join(lines[number, index])) if (number, index) in changed else action
            for index, action in enumerate(flow.actions)
        )
        flows.append(replace(flow, actions=actions))
    resolution.plan = replace(resolution.plan, flows=tuple(flows))


def _shown(value: Any) -> str:
    return value if isinstance(value, str) else repr(value)
