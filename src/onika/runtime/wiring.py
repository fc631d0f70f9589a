"""The wiring of a subsystem: tasks meet in variables by aliased port names; declarations that disagree (law 7)."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

from onika.model.port import PortKind
from onika.model.rules.order import Ports
from onika.model.rules.reconfiguration import PlacedTask
from onika.wire.plan import PlannedTask
from onika.wire.sheet import ModuleSheet
from onika.words.fault import Fault, Place
from onika.words.reason import Reason
from onika.words.shape import Shape


@dataclass(frozen=True, slots=True)
class WiredPort:
    """A port bound by name; the shape's dimensions are aliased names too."""

    port: str
    kind: PortKind
    svar: str
    shape: Shape
    unit: str


@dataclass(frozen=True)
class WiredTask:
    """A task of a plan with its class sheet and its ports by aliased names, in the sheet's order."""

    task: PlannedTask
    sheet: ModuleSheet
    ports: tuple[WiredPort, ...]

    @property
    def name(self) -> str:
        """The task's name."""
        return self.task.name

    def svars(self, *kinds: PortKind) -> tuple[str, ...]:
        """The variables behind the ports of these kinds."""
        return tuple(port.svar for port in self.ports if port.kind in kinds)

    @cached_property
    def inconst(self) -> tuple[str, ...]:
        """What it reads at initialisation."""
        return self.svars(PortKind.INCONST, PortKind.INBOTH)

    @cached_property
    def outconst(self) -> tuple[str, ...]:
        """What it writes at initialisation."""
        return self.svars(PortKind.OUTCONST, PortKind.OUTBOTH)

    @cached_property
    def invar(self) -> tuple[str, ...]:
        """What it reads at every cycle."""
        return self.svars(PortKind.INVAR, PortKind.INBOTH)

    @cached_property
    def outvar(self) -> tuple[str, ...]:
        """What it writes at every cycle."""
        return self.svars(PortKind.OUTVAR, PortKind.OUTBOTH)

    @property
    def first_values(self) -> tuple[str, ...]:
        """What it reads at initialisation if somebody supplies it by then, else as it stands (reading 6)."""
        return self.svars(PortKind.INBOTH)

    @property
    def meeting(self) -> Ports:
        """Its variables alone, for the rules of order."""
        return Ports(self.name, self.inconst, self.outconst, self.invar, self.outvar)

    @property
    def placed(self) -> PlacedTask:
        """As reconfiguration sees it; what its shapes depend on counts as a constant that it reads."""
        dimensions = (name for port in self.ports for name in port.shape.names if name not in self.outconst)
        inconst = tuple(dict.fromkeys((*self.inconst, *dimensions)))
        ports = Ports(self.name, inconst, self.outconst, self.invar, self.outvar)
        return PlacedTask(ports, self.task.module, self.device if self.sheet.hardware else None)

    @property
    def device(self) -> str | None:
        """The device its LOCAL block names, as `world:device`."""
        return next((words[0] for key, words in self.task.local if key == "DEVICE" and words), None)


def wire(task: PlannedTask, sheet: ModuleSheet) -> WiredTask:
    """Bind a task's ports to state variables by its aliases."""
    aliases = dict(task.aliases)

    def bound(kind: str, name: str, text: str, unit: str) -> WiredPort:
        shape = Shape.parse(text)
        dims = tuple(aliases.get(dim, dim) if isinstance(dim, str) else dim for dim in shape.dims)
        return WiredPort(name, PortKind(kind), aliases.get(name, name), Shape(shape.type, dims), unit)

    return WiredTask(task, sheet, tuple(bound(port.kind, port.name, port.shape, port.unit) for port in sheet.ports))


def disagreements(tasks: Sequence[WiredTask]) -> list[Fault]:
    """Every variable that two tasks of one subsystem declare with another type, shape or unit."""
    first: dict[str, tuple[WiredTask, WiredPort]] = {}
    faults = []
    for task in tasks:
        for port in task.ports:
            other, wired = first.setdefault(port.svar, (task, port))
            if (wired.shape, wired.unit) != (port.shape, port.unit):
                faults.append(
                    Fault(
                        Place(task.task.place),
                        Reason.of(
                            "runtime.declared_unlike",
                            svar=port.svar,
                            shape=str(wired.shape),
                            unit=wired.unit,
                            name=other.name,
                            shape_2=str(port.shape),
                            unit_2=port.unit,
                        ),
                        Reason.of("words.application_not_run"),
                    )
                )
    return faults


def missing_constants(tasks: Sequence[WiredTask]) -> list[Fault]:
    """Every constant that a task needs and no task of the subsystem supplies; an INBOTH takes an OUTVAR too."""
    supplied = {svar for task in tasks for svar in task.outconst}
    written = supplied | {svar for task in tasks for svar in task.outvar}
    return [
        Fault(
            Place(task.task.place),
            Reason.of("runtime.constant_missing", svar=svar),
            Reason.of("words.application_not_run"),
        )
        for task in tasks
        for svar in task.inconst
        if svar not in (written if svar in task.first_values else supplied)
    ]


def upstream(tasks: Iterable[WiredTask], names: Iterable[str]) -> frozenset[str]:
    """Every variable from which these are made, cycle by cycle, and these themselves."""
    everyone = list(tasks)
    reached: set[str] = set()
    open_ = set(names)
    while open_:
        reached |= open_
        open_ = {svar for task in everyone if reached & set(task.outvar) for svar in task.invar} - reached
    return frozenset(reached)
