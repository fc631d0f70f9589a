"""A plan: an application compiled to what a runtime needs to execute it, without any file (decision 7)."""

from typing import Annotated

from msgspec import Meta, Struct

from onika.wire.world_source import WorldSource

Index = Annotated[int, Meta(ge=-1, le=2**31 - 1)]
"""The number of an action, a flow, an instruction or a line, from 0; -1 where none of them is meant."""


class Do(Struct, frozen=True, tag=True):
    """Carry out an action; what it returns is the value that what follows looks at."""

    action: Index


class Meet(Struct, frozen=True, tag=True):
    """Wait until all flows in whose programs this tag stands are there; then all go on together."""

    tag: str
    """Unique for each instance of a parallel application; its last word behind a blank is the one of the file."""


class Rest(Struct, frozen=True, tag=True):
    """A breakpoint after an action: pause if the condition holds; empty: always."""

    action: Index
    condition: str = ""


class Choose(Struct, frozen=True, tag=True):
    """Go to one of several places: by the value, or where the first condition holds, else the last (D10, D13)."""

    to: tuple[Index, ...]
    conditions: tuple[str, ...] = ()
    name: str = ""


class Again(Struct, frozen=True, tag=True):
    """The end of a bottom-test loop: back to `to` while the value, or the condition, says so."""

    loop: str
    to: Index
    condition: str = ""


class Unless(Struct, frozen=True, tag=True):
    """The top of a top-test loop, behind its test: on to `to` unless the value, or the condition, says go on."""

    loop: str
    to: Index
    condition: str = ""


class Jump(Struct, frozen=True, tag=True):
    """Go to `to`; where it closes the top-test loop `loop`, not while that is being left."""

    to: Index
    loop: str = ""


class Fork(Struct, frozen=True, tag=True):
    """Begin other flows, each at a place of its own program, and go on (a nested parallel application, D13)."""

    flows: tuple[tuple[Index, Index], ...]
    name: str = ""


class Join(Struct, frozen=True, tag=True):
    """Wait until these flows have come to their Halt."""

    flows: tuple[Index, ...]


class Halt(Struct, frozen=True, tag=True):
    """The end of a program, or of one stretch of a flow that is begun by another."""


Instruction = Do | Meet | Rest | Choose | Again | Unless | Jump | Fork | Join | Halt


class Code(Struct, frozen=True):
    """The file of a module, named by its content."""

    digest: str
    """SHA-256 of the source in hexadecimal."""
    module: str
    path: str
    """Where the environment read it; for messages and tracebacks."""
    source: str
    is_sandboxed: bool = False
    """Whether it is of a library of others that has no rights here: it may compute, and nothing else (R-X16)."""


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
    line: Index = 0
    """Where the job stands in that file."""
    lacks_tasks: bool = False
    """Whether the configuration has tasks that could not be planned; their faults are told elsewhere."""
    marker: bool = False
    synch_tag: str | None = None
    is_noop: bool = False
    """Whether it does nothing and takes no time (requirement D11); it has no tasks."""
    within: tuple[str, ...] = ()
    """The nested applications and branches it stands in, outermost first."""
    spot: tuple[Index, ...] = ()
    """Its line in its file, behind those of the icons that run the applications around it, outermost first."""


class PlannedFlow(Struct, frozen=True):
    """The actions of a flow on one subsystem, the union of their tasks, and the program in which they follow."""

    subsystem: str
    tasks: tuple[PlannedTask, ...]
    actions: tuple[PlannedAction, ...]
    program: tuple[Instruction, ...] = ()
    """Empty: the actions one after the other, each with its tag and its breakpoint."""
    parent: Index | None = None
    """The flow that begins this one again and again, where it belongs to a nested parallel application."""
    replaced: tuple[tuple[str, PlannedTask], ...] = ()
    """Of a redirected flow: the names of tasks that stand for others, each with the task that it stands for."""
    worlds: tuple[tuple[str, str], ...] = ()
    """The worlds that its tasks' files name, each with the one that is driven: another one where it is redirected."""


class Plan(Struct, frozen=True, omit_defaults=True):
    """Everything a runtime needs to run an application."""

    application: str
    flows: tuple[PlannedFlow, ...]
    code: tuple[Code, ...]
    worlds: tuple[WorldSource, ...] = ()
    """The files of the worlds in which its tasks have devices, of those that are files."""
