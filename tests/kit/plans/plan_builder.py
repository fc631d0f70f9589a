"""Plans of real modules without any file, for tests of what runs plans.

builder = PlanBuilder()
builder.task("push", PUSH, frequency=50.0)
plan = builder.plan([action("push"), action("push", arguments="3")])
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from hashlib import sha256

from kit.worlds.box_cells import boxes_files
from onika.runtime.modules.code import load
from onika.runtime.modules.sheet import sheet_of
from onika.wire.plan import Code, Plan, PlannedAction, PlannedFlow, PlannedTask
from onika.wire.sheet import ModuleSheet
from onika.wire.world_source import WorldSource
from onika.words.fault import Fault

_PORTS = {
    "inconst": ("INCONST", "INBOTH"),
    "outconst": ("OUTCONST", "OUTBOTH"),
    "invar": ("INVAR", "INBOTH"),
    "outvar": ("OUTVAR", "OUTBOTH"),
}


@dataclass(frozen=True, slots=True)
class Action:
    """Which tasks are ON, what their trigger is told, at what rates; without tasks it is a no-op."""

    tasks: tuple[str, ...]
    arguments: str = ""
    rates: tuple[tuple[str, float], ...] = ()


def action(*tasks: str, arguments: str = "", rates: Mapping[str, float] | None = None) -> Action:
    """One action of a flow."""
    return Action(tasks, arguments, tuple((rates or {}).items()))


class PlanBuilder:
    """Tasks by name; a task's ports are those that its module declares."""

    def __init__(self) -> None:
        self._tasks: dict[str, PlannedTask] = {}
        self._code: dict[str, Code] = {}

    def task(
        self,
        name: str,
        source: str,
        *,
        frequency: float | None = 100.0,
        local: Mapping[str, str] | None = None,
        aliases: Mapping[str, str] | None = None,
        rtpu: str = "unknown",
        module: str = "",
        kind: str = "",
    ) -> PlannedTask:
        """A task of a module with this source, which is named like the task unless said otherwise."""
        code = Code(sha256(source.encode()).hexdigest(), module or name, f"{module or name}.py", source)
        self._code[code.digest] = code
        sheet = _sheet(code)
        ports = {key: tuple(port.name for port in sheet.ports if port.kind in kinds) for key, kinds in _PORTS.items()}
        self._tasks[name] = PlannedTask(
            name=name,
            module=code.module,
            digest=code.digest,
            place=f"{name}.rmod",
            rtpu=rtpu,
            frequency=frequency,
            type=kind or ("periodic" if frequency else "aperiodic"),
            aliases=tuple((aliases or {}).items()),
            local=tuple((key, tuple(words.split())) for key, words in (local or {}).items()),
            **ports,
        )
        return self._tasks[name]

    def planned(self, name: str) -> PlannedTask:
        """The task of this name."""
        return self._tasks[name]

    def code(self, name: str) -> Code:
        """The code behind a task."""
        return self._code[self._tasks[name].digest]

    def plan(self, *flows: Sequence[Action]) -> Plan:
        """A plan called `test` whose flows are flow0, flow1, …; actions stand in lines 1, 2 …, then 101, 102 …"""
        planned = tuple(self._flow(number, flow) for number, flow in enumerate(flows))
        used = {task.digest for flow in planned for task in flow.tasks}
        codes = tuple(code for digest, code in self._code.items() if digest in used)
        return Plan("test", planned, codes, worlds=_worlds(planned))

    def _flow(self, number: int, flow: Sequence[Action]) -> PlannedFlow:
        names = dict.fromkeys(name for action in flow for name in action.tasks)
        actions = tuple(_planned(number, index, action) for index, action in enumerate(flow))
        return PlannedFlow(f"flow{number}", tuple(self._tasks[name] for name in names), actions)


def _worlds(flows: Sequence[PlannedFlow]) -> tuple[WorldSource, ...]:
    """The shipped worlds that are files, where a task has a device of such a one."""
    lines = (line for flow in flows for task in flow.tasks for line in task.local)
    devices = (words[0] for key, words in lines if key == "DEVICE" and words)
    is_of_boxes = any(device.partition(":")[0].partition("@")[0] == "boxes" for device in devices)
    return (boxes_files(),) if is_of_boxes else ()


def _planned(flow: int, index: int, action: Action) -> PlannedAction:
    return PlannedAction(
        name=f"action {index}",
        job=f"job{index}",
        target="there" if action.arguments else None,
        place="test.appl",
        line=100 * flow + index + 1,
        tasks=action.tasks,
        is_noop=not action.tasks,
        rates=action.rates,
        arguments=action.arguments,
    )


def _sheet(code: Code) -> ModuleSheet:
    """The sheet of a module; without ports for one that cannot be loaded."""
    cls = load(code.source, code.path, code.module)
    return ModuleSheet((), (), (), False, False, False, 0, "") if isinstance(cls, Fault) else sheet_of(cls)
