"""What a user does in the running system."""

from typing import Literal

from onika.wire.act.act import Act, Names


class Connect(Act, frozen=True):
    """Connect a configuration with the runtime of a station: merge it with what runs there (C12, C18, F02).

    url         of a runtime that has no station yet, and gets one; empty: that of `station`
    station     empty: the first one; None: the one to which the configuration is assigned
    """

    doc: str
    url: str = ""
    token: str = ""
    subsystem: str = ""
    station: str | None = None


class Disconnect(Act, frozen=True):
    """Leave what runs as it is, and go on unconnected."""

    doc: str


class KeepAlive(Act, frozen=True):
    """Bring the tasks of one more configuration to life, OFF, beside those of a connected one (C32)."""

    doc: str
    path: str


class SwitchTo(Act, frozen=True):
    """Have the tasks of a configuration that is kept alive ON, and all others OFF, as one change."""

    doc: str
    name: str


class LetGo(Act, frozen=True):
    """Keep a configuration alive no more: tasks that no other one has are ended."""

    doc: str
    name: str
    discards: bool = False


class Turn(Act, frozen=True):
    """Turn tasks ON or OFF."""

    doc: str
    tasks: Names
    is_on: bool
    arguments: str = ""
    confirmed: bool = False


class Toggle(Act, frozen=True):
    """ON to OFF and back; a task in ERROR is cleared (C11)."""

    doc: str
    task: str


class Clear(Act, frozen=True):
    """Bring a task out of ERROR, and on again where that is wanted."""

    doc: str
    task: str
    turns_on: bool = False


class Reinit(Act, frozen=True):
    """Initialise a task anew, and all that need its constants."""

    doc: str
    task: str


class Renew(Act, frozen=True):
    """Exchange the code of a living task for what its file says now; on failure the old one stays (law 21)."""

    doc: str
    task: str
    holds: bool = False
    """Whether all tasks that are ON may go OFF for a moment, where there is no gap between cycles."""


class AskModule(Act, frozen=True):
    """Ask a module for something by name, as its code offers it (A05); replied with the value as text."""

    doc: str
    task: str
    name: str


class TellModule(Act, frozen=True):
    """Tell a module a new value of something by name (A05); replied with the value it has then, where it says so."""

    doc: str
    task: str
    name: str
    value: str


class WriteVariable(Act, frozen=True):
    """Write a variable of a running subsystem that no task writes, in SI units, row by row."""

    doc: str
    variable: str
    values: tuple[float, ...]


class Push(Act, frozen=True):
    """Lead a tool by a pad, as it is pushed now; believed for a moment only, so it is sent anew all the time (K07)."""

    axes: tuple[float, float, float, float, float, float]
    """Three of moving, three of turning, -1..1."""
    is_held: bool
    """Whether the dead-man is held."""
    button: bool = False
    scale: float = 1.0
    frame: Literal["world", "tool", "base"] = "world"
    subsystem: str = ""
    """Where several listen."""
    source: str = ""
    """The browser in which it is held."""


class CheckMemory(Act, frozen=True):
    """Check the memory of a running subsystem's variables (A12); replied with what is unsound, as sentences."""

    doc: str


class LogReadings(Act, frozen=True):
    """Ask for the present readings of a running subsystem as lines of a log (A12); replied with its text."""

    doc: str


class SampleVariables(Act, frozen=True):
    """Ask for values of variables at every cycle, as a scope shows them (C14); the value is a tuple of
    `view.SampledView`."""

    variables: tuple[str, ...]
    """As `DOC/NAME` or `@SUBSYSTEM/NAME`, at most 16."""
    after: tuple[int, ...] = ()
    """Of each the number of the last value that came; empty: all that are kept are wanted."""


class Answer(Act, frozen=True):
    """Answer what a task asks, in the words of an argument line (C13)."""

    doc: str
    """The configuration, or the application that runs; empty: a run that another began and that is held here."""
    task: str
    """By its name; a task of a run as `SUBSYSTEM/TASK`."""
    line: str
    station: str = ""
    """Of a run that another began."""


class Stop(Act, frozen=True):
    """Stop everything at every station: every drive holds (law 27). Always carried out first, never refused."""


class AddUnit(Act, frozen=True):
    """Have one more processing unit in the runtime, or a lost one anew; what was on it stays gone."""

    name: str
    station: str = ""


class RecordByHand(Act, frozen=True):
    """Record a configuration that lives into a file from now on, or end that; the value is the file (X05)."""

    doc: str
    is_on: bool = True


class FindRoom(Act, frozen=True):
    """Do once more what found no gap between the cycles of a unit last, and was taken back (law 21)."""

    doc: str
    unit: str = ""
    """Where the tasks live that found none; it is started if it does not live. Empty: in a moment of hold."""


class Reset(Act, frozen=True):
    """After a Stop: allow motion again, at one station or wherever all is stopped."""

    station: str = ""
    is_everywhere: bool = False


class Watch(Act, frozen=True):
    """What this browser wants to see from now on: variables as `DOC/NAME`, worlds by name, figures of tasks.

    A camera stands among the worlds, as `WORLD:CAMERA`. What is of another station than the first one names it:
    `@SUBSYSTEM@STATION/NAME`, `STATION/WORLD`, `STATION/WORLD:CAMERA`.

    Of a run, variables are `DOC/SUBSYSTEM/NAME`, or `DOC/NAME` for the first flow that has it.
    """

    variables: Names = ()
    worlds: Names = ()
    figures: bool = False
    hz: float = 30.0


class Scene(Act, frozen=True):
    """Ask for what a world consists of; replied with it."""

    world: str


class Meshes(Act, frozen=True):
    """Have meshes of a world made that a scene names; replied, when that is done, with the names of those there are."""

    world: str
    meshes: Names = ()
