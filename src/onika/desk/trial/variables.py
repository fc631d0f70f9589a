"""Chooses the variables of a run that are worth keeping, by what modules declare; their names mean nothing here.

What a task with a device says of the world is *measured*. A *reference* is what a trigger writes as a single number,
and what any task writes in the type, shape and unit of something that hardware of the same flow measures. Forces,
torques and speeds are left out, as they differ from run to run while all that matters is the same; so are texts, and
matrices, whose content measured variables show in fewer numbers.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from onika.wire.plan import PlannedAction, PlannedFlow, PlannedTask
from onika.wire.sheet import ModuleSheet, PortSheet
from onika.words.name import resolve
from onika.words.shape import Shape

DEVICE = "DEVICE"
"""The LOCAL line by which a task names its device."""

FLOORS = {"rad": 0.005, "deg": 0.3, "m": 0.002, "mm": 2.0, "-": 0.01}
"""How exactly a real number can be asked for, by its unit; one of another unit is not worth keeping."""

Sheets = Mapping[str, ModuleSheet]
"""What modules declare, by the digests of their code."""


@dataclass(frozen=True, slots=True)
class KeptVariable:
    """A variable that is worth keeping: its unit, or those of its elements where they differ, and who writes it."""

    name: str
    units: tuple[str, ...]
    is_real: bool
    is_measured: bool
    writer: str

    def unit_of(self, address: str) -> str:
        """The unit of `GRIP_MEZ[0]`, or of all its elements."""
        at = address.removeprefix(self.name).strip("[]")
        return self.units[min(int(at or 0), len(self.units) - 1)]


def robots(flow: PlannedFlow, sheets: Sheets) -> tuple[tuple[str, str], ...]:
    """The hardware tasks of a flow and their devices."""
    return tuple((task.name, _device(task)) for task in flow.tasks if _sheet(task, sheets, "hardware"))


def kept_after(flow: PlannedFlow, action: PlannedAction, sheets: Sheets) -> tuple[KeptVariable, ...]:
    """The variables to be kept after an action: of the tasks that are on in it, measured ones first."""
    on = [task for task in flow.tasks if task.name in action.tasks]
    forms = {(port.shape, port.unit) for task in flow.tasks if _device(task) for port in _outputs(task, sheets)}
    variables = [variable for task in on for variable in _variables(task, sheets, forms)]
    return tuple(sorted(variables, key=lambda variable: (not variable.is_measured, variable.name)))


def _variables(task: PlannedTask, sheets: Sheets, forms: set[tuple[str, str]]) -> Iterator[KeptVariable]:
    is_measured, is_trigger = bool(_device(task)), _sheet(task, sheets, "trigger")
    for port in _outputs(task, sheets):
        shape = Shape.parse(port.shape)
        units = tuple(word.strip() for word in port.unit.split(","))
        is_wanted = is_measured or (port.shape, port.unit) in forms or (is_trigger and not shape.dims)
        is_plain = len(shape.dims) < 2 and (shape.type.is_whole or shape.type.is_real)
        if is_wanted and is_plain and (shape.type.is_whole or any(unit in FLOORS for unit in units)):
            (name,) = resolve((port.name,), dict(task.aliases))
            yield KeptVariable(name, units, shape.type.is_real, is_measured, task.name)


def _outputs(task: PlannedTask, sheets: Sheets) -> list[PortSheet]:
    sheet = sheets.get(task.digest)
    if sheet is not None:
        return [port for port in sheet.ports if port.kind == "OUTVAR"]
    return []


def _sheet(task: PlannedTask, sheets: Sheets, question: str) -> bool:
    sheet = sheets.get(task.digest)
    return sheet is not None and bool(getattr(sheet, question))


def _device(task: PlannedTask) -> str:
    return next((" ".join(words) for key, words in task.local if key == DEVICE), "")
