"""A plan: an application compiled to what a runtime needs to execute it, without any file (house decision 2)."""

from msgspec import Struct


class Code(Struct, frozen=True):
    """The file of a module, named by its content."""

    digest: str
    """SHA-256 of the source in hexadecimal."""
    module: str
    path: str
    """Where the environment read it; for messages and tracebacks."""
    source: str


class PlannedTask(Struct, frozen=True):
    """A task of a flow as its `.rmod` describes it."""

    name: str
    module: str
    digest: str
    place: str
    """Its `.rmod` file, for messages."""
    rtpu: str
    frequency: float | None
    type: str
    aliases: tuple[tuple[str, str], ...]
    inconst: tuple[str, ...]
    outconst: tuple[str, ...]
    invar: tuple[str, ...]
    outvar: tuple[str, ...]
    local: tuple[tuple[str, tuple[str, ...]], ...]


class PlannedAction(Struct, frozen=True):
    """A job, or a job and its target: which tasks are ON and what their trigger is told."""

    name: str
    job: str
    target: str | None
    place: str
    """The application's file, for messages."""
    tasks: tuple[str, ...]
    """In the order of the configuration's file."""
    rates: tuple[tuple[str, float], ...]
    arguments: str
    """The target's values as the trigger's argument line; empty without a target."""
    line: int = 0
    """Where the job stands in that file."""
    lacks_tasks: bool = False
    """Whether the configuration has tasks that could not be planned; their faults are told elsewhere."""
    marker: bool = False
    synch_tag: str | None = None


class PlannedFlow(Struct, frozen=True):
    """A sequence of actions on one subsystem, and the union of their tasks."""

    subsystem: str
    tasks: tuple[PlannedTask, ...]
    actions: tuple[PlannedAction, ...]


class Plan(Struct, frozen=True):
    """Everything a runtime needs to run an application."""

    application: str
    flows: tuple[PlannedFlow, ...]
    code: tuple[Code, ...]
