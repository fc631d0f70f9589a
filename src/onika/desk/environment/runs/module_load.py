"""The code of a task's module is loaded by the runtime as it stands in its file now: what is wrong is told (C31, C05).

The runtime executes it apart, where nothing lives for it, and says what its class declares; that counts from now on,
and is held against the task's `.rmod`. The runtime is launched where there is none.
"""

import re
from collections.abc import Iterator
from dataclasses import replace

from onika.desk.environment.outcome.code_faults import at_line
from onika.desk.environment.outcome.outcome import Ask, Done, InterimModel, No, Procedure, RequiredRuntime
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.descriptions import LearntDescriptions, forgotten
from onika.desk.environment.reconcile.merge import runtime_view
from onika.desk.environment.reconcile.task_plan import code_of
from onika.desk.environment.runs import flow_placement
from onika.desk.environment.state.model import Model
from onika.desk.run.runtime_conversation import in_short
from onika.model.task import Task
from onika.wire import act, live
from onika.wire.plan import Code
from onika.wire.runtime_standing import Standing
from onika.wire.sheet import ModuleSheet
from onika.wire.view import LoadedView
from onika.words.reason import Reason

_NAME = r"^\s*{name}\s*[:=]"

Faults = tuple[tuple[int, Reason], ...]
"""Sentences by the lines of the code, 0 for the whole."""


def load_module(model: Model, command: act.LoadModule, _outside: Services) -> No | Procedure:
    """Have it loaded; the value is a `view.LoadedView`, which has no faults where all is well."""
    task = model.libraries.tasks.get(command.task)
    if task is None:
        return No(Reason.of("desk.no_task", name=command.task))
    code = code_of(task.module, model.libraries, command.task)
    if isinstance(code, Reason):
        return No(code)
    return _loaded(model, task, code)


def _loaded(model: Model, task: Task, code: Code) -> Procedure:
    state = model.runtime if model.runtime.state == "linked" else flow_placement.starting(model.runtime)
    reach = RequiredRuntime(model.runtime.address)
    model, standing = yield Ask(replace(model, runtime=state), live.Survey(), reach)
    if not isinstance(standing, Standing):
        why = refusal(standing)
        yield InterimModel(flow_placement.lost(model, why))
        return No(Reason.of("run.no_runtime", why=in_short(why)))
    model = replace(model, runtime=runtime_view(model.runtime, standing))
    model, response = yield Ask(model, live.Describe((code,)))
    if not isinstance(response, live.Described):
        return No(refusal(response))
    sheet = response.sheets.get(code.digest)
    if sheet is None:
        why = response.faults.get(code.digest, Reason.of("run.unreadable"))
        learnt = LearntDescriptions(unread={task.module: why})
        return Done(learnt.taken_over(forgotten(model, task.module)), value=LoadedView((at_line(why),)))
    learnt = LearntDescriptions({task.module: sheet}, digests={task.module: code.digest})
    faults = tuple(_differences(task, sheet, code.source))
    return Done(learnt.taken_over(forgotten(model, task.module)), value=LoadedView(faults))


def _differences(task: Task, sheet: ModuleSheet, source: str) -> Iterator[tuple[int, Reason]]:
    """The ports in which class and `.rmod` differ, each at its line of the code; those of the `.rmod` alone at none."""
    declared = {port.name: port.kind for port in sheet.ports}
    written = {name: kind.value for name, kind in task.kinds().items()}
    for name, kind in declared.items():
        if written.get(name) != kind:
            line = _line_of(name, source)
            yield line, Reason.of("desk.port_not_in_rmod", kind=kind, name=name, task=task.name)
    for name, kind in written.items():
        if name not in declared:
            yield 0, Reason.of("runtime.port_undeclared", module=task.module, kind=kind, name=name)


def _line_of(name: str, source: str) -> int:
    pattern = re.compile(_NAME.format(name=re.escape(name)))
    return next((number for number, line in enumerate(source.split("\n"), 1) if pattern.match(line)), 0)
