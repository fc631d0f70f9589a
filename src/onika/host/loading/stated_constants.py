"""What tasks of a flow state of themselves before any of them lives (laws 7, 16)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from onika.host.loading.module_questions import ModuleQuestions
from onika.host.loading.plan_checks import is_there, shapeless, states_constants, unfit
from onika.runtime.wiring import WiredTask
from onika.wire.plan import Code
from onika.words.fault import Fault


@dataclass(slots=True)
class StatedConstants:
    """Constants by variable, the hardware tasks among those who state some, each with its own, and what is wrong."""

    constants: dict[str, Any] = field(default_factory=dict)
    robots: list[tuple[WiredTask, Code, dict[str, Any]]] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)


def stated_constants(
    wired: Sequence[WiredTask], codes: Mapping[str, Code], loading: ModuleQuestions
) -> StatedConstants:
    """Ask each of them.

    Of one whose device is nowhere, or that cannot state anything, it is told once, and not of all that lacks for it.
    """
    stated, stating = StatedConstants(), []
    there = [wired_task for wired_task in wired if is_there(wired_task, loading)]
    for wired_task in sorted(there, key=lambda wired_task: wired_task.sheet.hardware):
        code = codes[wired_task.task.digest]
        published = loading.constants(code, wired_task.task.local) if states_constants(wired_task) else {}
        if isinstance(published, Fault):
            stated.faults.append(published)
            continue
        stating.append(wired_task)
        aliases = dict(wired_task.task.aliases)
        stated.constants |= {aliases.get(name, name): value for name, value in published.items()}
        stated.faults += unfit(wired_task, code, published, loading)
        if published and wired_task.sheet.hardware:
            stated.robots.append((wired_task, code, published))
    stated.faults += shapeless(stating, stated.constants)
    return stated
