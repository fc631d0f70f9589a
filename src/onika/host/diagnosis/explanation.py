"""The explanation: the chain from a cause to whoever waits, the last seconds, the choices (requirement X06).

It decides nothing and changes nothing; `host.diagnosis.explainer` says when there is something to explain.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from msgspec import structs

from onika.host.diagnosis.nan_origin import Suspicion, is_no_number, suspicion
from onika.host.diagnosis.stall import waiting_for
from onika.host.diagnosis.stop_cause import Cause, CauseKind
from onika.host.diagnosis.stop_choice import choices
from onika.host.diagnosis.variable_history import VariableHistory
from onika.host.loading.plan_preparation import Preparation
from onika.runtime.wiring import WiredTask
from onika.wire import event
from onika.wire.plan import PlannedAction
from onika.wire.steer import Position
from onika.words.fault import Place
from onika.words.reason import Reason, every

MOST_COURSES = 8
"""Variables that are shown: more than anybody reads would hide the ones that matter."""
MOST_NUMBERS = 6000
"""Numbers in all courses together; an event has to fit on any link."""


def explain(
    prepared: Preparation, cause: Cause, positions: Sequence[Position], history: VariableHistory, at_s: float
) -> event.Explained:
    """Tell all that is known of a cause; `at_s` counts from the run's start.

    `positions` are those of the standstill; where the run ends by the cause, as they were before everybody was killed.
    """
    scene = _scene(prepared, cause, positions)
    suspected = _suspicion(scene, cause, history)
    seen = _seen_first(scene, cause)
    is_known = not seen or any(writer == seen for _, writer in suspected.trail)  # then the trail goes as far, or on
    suspect = suspected.task if is_known else seen
    text = cause.text
    if suspect not in ("", seen):
        text = Reason.of("host.cause_suspected", cause=cause.text, suspicion=suspected.reason)
    return event.Explained(
        subsystem=cause.subsystem,
        task=cause.task,
        action="" if scene.action is None else scene.action.name,
        index=scene.index,
        place=_place(scene),
        text=text,
        path=cause.path,
        line=cause.line,
        waiting=waiting_for(cause.subsystem, positions) if cause.subsystem else (),
        courses=_courses(scene, cause, suspected, history),
        choices=choices(cause, prepared.plan.flows, positions),
        at_s=at_s,
        kind=cause.kind.value,
        suspect=suspect,
    )


@dataclass(frozen=True, slots=True)
class _Scene:
    """Where it happened."""

    action: PlannedAction | None
    index: int
    task: WiredTask | None
    beside: tuple[WiredTask, ...]
    """The tasks of the action, or of the flow before its first one."""


def _scene(prepared: Preparation, cause: Cause, positions: Sequence[Position]) -> _Scene:
    number = next((n for n, flow in enumerate(prepared.plan.flows) if flow.subsystem == cause.subsystem), None)
    if number is None:
        return _Scene(None, -1, None, ())
    planned, wired = prepared.plan.flows[number], prepared.flows[number]
    index = next((position.action for position in positions if position.subsystem == cause.subsystem), -1)
    action = planned.actions[index] if 0 <= index < len(planned.actions) else None
    task = next((wired_task for wired_task in wired if wired_task.name == cause.task), None)
    on = tuple(
        wired_task for wired_task in wired if action is None or not action.tasks or wired_task.name in action.tasks
    )
    return _Scene(action, index, task, on)


def _place(scene: _Scene) -> str:
    if scene.action is not None:
        return str(Place(scene.action.place, scene.action.line))
    if scene.task is not None:
        return scene.task.task.place
    return ""


def _suspicion(scene: _Scene, cause: Cause, history: VariableHistory) -> Suspicion:
    if scene.task is None or cause.kind is not CauseKind.ERROR:
        return Suspicion()
    seen = _as_failed(scene.task, cause)

    def is_wrong(svar: str) -> bool:
        if svar in seen:
            return is_no_number(seen[svar])
        course = history.course(cause.subsystem, svar)
        return course is not None and is_no_number(course.values[-1])

    return suspicion(scene.task, scene.beside, is_wrong)


def _seen_first(scene: _Scene, cause: Cause) -> str:
    """Who was first to write what was no number at that instant, among the tasks of its own unit (law 5)."""
    writers = {reason.args["task"] for reason in every(cause.text) if reason.key == "runtime.first_written"}
    return next((wired_task.name for wired_task in scene.beside if wired_task.name in writers), "")


def _as_failed(task: WiredTask, cause: Cause) -> dict[str, Any]:
    """The task's inputs as it read them: by now the table may say something else."""
    inputs = {port.port: port.svar for port in task.ports if port.kind.is_input}
    return {inputs[port]: value for port, value in cause.values.items() if port in inputs}


def _courses(scene: _Scene, cause: Cause, suspected: Suspicion, history: VariableHistory) -> tuple[event.Course, ...]:
    if scene.task is None:
        return ()
    units = {port.svar: port.unit for wired_task in (*scene.beside, scene.task) for port in wired_task.ports}
    courses: list[event.Course] = []
    numbers = 0
    for svar in dict.fromkeys(_that_matter(scene.task, scene.beside, cause, suspected)):
        course = history.course(cause.subsystem, svar)
        cost = 0 if course is None else len(course.values) * _count(course.values[0])
        if course is not None and numbers + cost <= MOST_NUMBERS and len(courses) < MOST_COURSES:
            courses.append(structs.replace(course, unit=units.get(svar, "")))
            numbers += cost
    return tuple(courses)


def _that_matter(task: WiredTask, beside: Sequence[WiredTask], cause: Cause, suspected: Suspicion) -> Iterator[str]:
    """Variables in the order in which they matter: the way of the trouble, the task's own, then what feeds it."""
    yield from (svar for svar, _ in suspected.trail)
    for wired_task in beside:
        if wired_task.name == suspected.task:
            yield from wired_task.invar
    if cause.kind in (CauseKind.ASKING, CauseKind.REFUSED) or cause.entry in ("init", "reinit"):
        yield from (*task.inconst, *task.outconst)
    yield from (*task.invar, *task.outvar)
    for wired_task in beside:
        if set(wired_task.outvar) & set(task.invar):
            yield from wired_task.invar


def _count(value: Any) -> int:
    if isinstance(value, list):
        return sum(map(_count, value))
    return 1
