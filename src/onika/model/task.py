"""A task: a module together with its parameter file (dissertation §3.2.2, §A.1)."""

from dataclasses import dataclass, field
from enum import Enum
from functools import cached_property

from onika.model.port import PortKind
from onika.words.name import resolve


class TaskType(Enum):
    """When a task runs: on a grid of time, on an event from outside, or once per command."""

    PERIODIC = "periodic"
    SYNCHRONOUS = "synchronous"
    APERIODIC = "aperiodic"


@dataclass(frozen=True, slots=True)
class LocalLine:
    """One line of the LOCAL block: a parameter of the module and its words."""

    key: str
    words: tuple[str, ...]


@dataclass(frozen=True)  # without slots: what follows from it is asked for again and again, and kept
class Task:
    """What a `.rmod` file says; port lists hold coded names in the file's order.

    An INBOTH stands in `inconst` and in `invar`, an OUTBOTH in `outconst` and in `outvar` (reading 7).
    """

    name: str
    module: str
    description: str = ""
    aliases: tuple[tuple[str, str], ...] = ()
    inconst: tuple[str, ...] = ()
    outconst: tuple[str, ...] = ()
    invar: tuple[str, ...] = ()
    outvar: tuple[str, ...] = ()
    type: TaskType = TaskType.PERIODIC
    frequency: float | None = None
    gives_period: bool = field(default=False, compare=False)
    """Whether the file states PERIOD rather than FREQ; a matter of taste, not of meaning."""
    object_type: str | None = None
    """The job type of the OBJECT line, where this task takes a target."""
    more_targets: tuple[str, ...] = ()
    """The types of the targets it takes beyond that one, in the order of their values (requirement D13)."""
    local: tuple[LocalLine, ...] = ()

    def svars(self, names: tuple[str, ...]) -> tuple[str, ...]:
        """The state variables behind some of this task's coded names."""
        return resolve(names, dict(self.aliases))

    @cached_property
    def inputs(self) -> frozenset[str]:
        """Every state variable this task reads, by its aliased name."""
        return frozenset(self.svars(self.inconst + self.invar))

    @cached_property
    def outputs(self) -> frozenset[str]:
        """Every state variable this task writes, by its aliased name."""
        return frozenset(self.svars(self.outconst + self.outvar))

    @cached_property
    def given_while_running(self) -> frozenset[str]:
        """O_V of Equation (3): the variables of its pure OUTVARs."""
        return frozenset(self.svars(tuple(name for name in self.outvar if name not in self.outconst)))

    @cached_property
    def needed_at_start(self) -> frozenset[str]:
        """I_C of Equation (3): the variables of its pure INCONSTs."""
        return frozenset(self.svars(tuple(name for name in self.inconst if name not in self.invar)))

    def kinds(self) -> dict[str, PortKind]:
        """The kind of every coded name, as this file declares it."""
        kinds: dict[str, PortKind] = {}
        for name in self.inconst:
            kinds[name] = PortKind.INBOTH if name in self.invar else PortKind.INCONST
        for name in self.invar:
            kinds.setdefault(name, PortKind.INVAR)
        for name in self.outconst:
            kinds[name] = PortKind.OUTBOTH if name in self.outvar else PortKind.OUTCONST
        for name in self.outvar:
            kinds.setdefault(name, PortKind.OUTVAR)
        return kinds
