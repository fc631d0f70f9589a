"""What is asked of subsystems by hand, task by task, without an application (A04 to A06, A11 to A14, A16, law 22)."""

from typing import Any

from msgspec import Struct

from onika.wire.plan import Code, PlannedTask
from onika.wire.runtime_standing import Standing
from onika.wire.sheet import ModuleSheet
from onika.wire.world_source import WorldSource
from onika.words.reason import Reason


class Turn(Struct, frozen=True):
    """A task to turn ON, and its argument line."""

    task: str
    arguments: str = ""


class Change(Struct, frozen=True, tag=True):
    """One live edit of a subsystem, carried out whole or not at all; replied by Accepted, the outcome is an event.

    A task that is both in `kill` and in `spawn` is exchanged. The subsystem comes into being with its first task.
    """

    subsystem: str
    kill: tuple[str, ...] = ()
    spawn: tuple[PlannedTask, ...] = ()
    code: tuple[Code, ...] = ()
    off: tuple[str, ...] = ()
    on: tuple[Turn, ...] = ()
    rates: tuple[tuple[str, float], ...] = ()
    """Tasks and their new rates in hertz."""
    holds: bool = False
    """Whether all that is ON here may go OFF for a moment where a newcomer finds no gap between cycles otherwise."""
    worlds: tuple[WorldSource, ...] = ()
    """The files of the worlds in which newcomers have devices, of those that are files."""


class Clear(Struct, frozen=True, tag=True):
    """Bring a task out of ERROR; replied by Accepted, the outcome is an event."""

    subsystem: str
    task: str


class Reinit(Struct, frozen=True, tag=True):
    """Initialise a task anew, with other LOCAL lines where they are given, and after it all that need its constants.

    Where shapes change with them this is the transaction of law 12; replied by Accepted, the outcome is an event.
    """

    subsystem: str
    task: str
    local: tuple[tuple[str, tuple[str, ...]], ...] | None = None


class Swap(Struct, frozen=True, tag=True):
    """Exchange the code of a living task; replied by Accepted or by Prepared with faults, the outcome is an event."""

    subsystem: str
    task: str
    code: Code
    holds: bool = False
    """Whether all that is ON here may go OFF for a moment where the code finds no gap between cycles otherwise."""


class Get(Struct, frozen=True, tag=True):
    """Ask a module for something by name; replied by Value."""

    subsystem: str
    task: str
    name: str


class Set(Struct, frozen=True, tag=True):
    """Tell a module a new value of something by name; replied by Value."""

    subsystem: str
    task: str
    name: str
    value: str


class Write(Struct, frozen=True, tag=True):
    """Write a variable that no task of a subsystem writes, in SI units; replied by Done or Refused."""

    subsystem: str
    name: str
    values: tuple[float, ...]
    """All of its elements, row by row."""


class Push(Struct, frozen=True, tag=True):
    """What a person's pad says now; it is believed for a moment only (K07). Replied by Done or Refused."""

    axes: tuple[float, float, float, float, float, float]
    """Three of moving, three of turning, -1..1."""
    is_held: bool
    """Whether the dead-man is held."""
    button: bool = False
    scale: float = 1.0
    """What share of its speed the task gives, 0..1."""
    frame: str = "world"
    """Along whose axes it is meant: one of `model.pad.FRAMES`."""
    subsystem: str = ""
    """Empty: the one that this session holds in which a task that is ON listens to a pad."""
    source: str = ""
    """Whose hand it is, where a session speaks for several people: one of them leads at a time."""


class Status(Struct, frozen=True, tag=True):
    """Ask for the figures of every task; counters begin anew with it (A11, A17). Replied by Figures."""


class Survey(Struct, frozen=True, tag=True):
    """Ask what there is; replied by Standing."""


class Read(Struct, frozen=True, tag=True):
    """Ask for variables by name, all where no name is given; replied by Values."""

    subsystem: str
    names: tuple[str, ...] = ()


class Describe(Struct, frozen=True, tag=True):
    """Ask what the classes of modules declare; replied by Described. It lets everything else pass."""

    code: tuple[Code, ...]


class Solve(Struct, frozen=True, tag=True):
    """Ask the module of an arm for the joint values of poses; replied by Solved. It lets everything else pass."""

    code: Code
    local: tuple[tuple[str, tuple[str, ...]], ...]
    """The LOCAL lines of the arm's task, which say what arm it is and where it stands."""
    poses: tuple[tuple[float, ...], ...]
    """Each as the nine numbers of a Cartesian target."""


class Check(Struct, frozen=True, tag=True):
    """Check the memory of a subsystem's variables (A12); replied by Findings."""

    subsystem: str


class Close(Struct, frozen=True, tag=True):
    """End a subsystem with all its tasks; replied by Accepted, the outcome is an event."""

    subsystem: str


class Take(Struct, frozen=True, tag=True):
    """Become the holder of a subsystem: the one who may change it (law 27); replied by Done or Refused."""

    subsystem: str


class Release(Struct, frozen=True, tag=True):
    """Let another become the holder."""

    subsystem: str


RECORDED_HZ = 20.0
"""How often values are told to whoever records what several runtimes do: as often as a link carries them well."""


class Attend(Struct, frozen=True, tag=True):
    """What this session hears from now on, in place of what it heard before; runs of its own it always hears."""

    subsystems: tuple[str, ...] = ()
    """Their events; `*` means all."""
    readings: tuple[str, ...] = ()
    """Variables as `SUBSYSTEM/NAME` or `SUBSYSTEM/*`, shown under these keys on the stream."""
    worlds: tuple[str, ...] = ()
    """Worlds whose poses are shown, as `world:NAME`; and cameras as `WORLD:CAMERA`, their pictures as `world:` so."""
    hz: float = 10.0
    """How often readings are shown at most."""


class Scene(Struct, frozen=True, tag=True):
    """Ask for what a world consists of, to draw its poses; replied by Scenery."""

    world: str


class Touch(Struct, frozen=True, tag=True):
    """Touch a part of an open world, such as a panic button: 1 presses, 0 lets go; replied by Done or Refused."""

    world: str
    part: str
    value: float


class PutBack(Struct, frozen=True, tag=True):
    """Everything in open worlds goes to where it stood at the start (law 18); replied by WorldsPutBack or Refused.

    Refused while an application, or a task that is ON, drives a device of one of them.
    """

    worlds: tuple[str, ...] = ()
    """Those that are meant; none: all that are open."""


class Reset(Struct, frozen=True, tag=True):
    """After a Stop: allow motion again (law 27)."""


class AddUnit(Struct, frozen=True, tag=True):
    """Have one more processing unit, or a lost one anew and empty; replied by Done when it is up, or by Refused."""

    name: str


class Record(Struct, frozen=True, tag=True):
    """Record a subsystem that is held by hand into a file of this machine, or end that (X05).

    Replied by Done as soon as the file is begun, or finished, or by Refused; `Recording` tells everybody. Only the
    program that launched the runtime may ask it.
    """

    subsystem: str
    path: str = ""
    """Empty: its recording ends."""


class ListWorlds(Struct, frozen=True, tag=True):
    """Ask which worlds are installed, and which of them are simulated; replied by WorldList."""


class Advance(Struct, frozen=True, tag=True):
    """In virtual time: let so many seconds pass; replied by Done when they have."""

    seconds: float


class Renew(Struct, frozen=True, tag=True):
    """In virtual time: the runtime becomes as it was when it was started: worlds, clock, tables; replied by Done.

    What is prepared is forgotten. Refused while anything lives in it, and while another session is connected (X23).
    """

    shake: int | None = None
    """A seed from which the things of the worlds are put a little elsewhere."""
    world_values: dict[str, dict[str, float]] = {}
    """What is otherwise in a world, such as the friction, by world and name."""


LiveRequest = (
    Change
    | Clear
    | Reinit
    | Swap
    | Get
    | Set
    | Write
    | Push
    | Status
    | Survey
    | Read
    | Describe
    | Solve
    | Check
    | Close
    | Take
    | Release
    | Attend
    | Scene
    | Touch
    | PutBack
    | AddUnit
    | Record
    | ListWorlds
    | Reset
    | Advance
    | Renew
)


class Accepted(Struct, frozen=True, tag=True):
    """It is being carried out; the event Edited with this number tells the outcome."""

    number: int


class Value(Struct, frozen=True, tag=True):
    """What a module said."""

    value: Any


class Values(Struct, frozen=True, tag=True):
    """Variables by name; arrays as lists."""

    values: dict[str, Any]
    now_s: float
    types: dict[str, str] = {}
    """Their types with their dimensions, as in `double[6]`."""


class Described(Struct, frozen=True, tag=True):
    """What classes of modules declare, and why others cannot be read, each by the digest of the code."""

    sheets: dict[str, ModuleSheet]
    faults: dict[str, Reason] = {}


class Solved(Struct, frozen=True, tag=True):
    """Joint values for each pose, each nearest to those before it; none where there are none, with the reason."""

    joints: tuple[tuple[float, ...], ...]
    reasons: tuple[Reason, ...]


class WorldsPutBack(Struct, frozen=True, tag=True):
    """The answer to PutBack: these worlds are as at the start; of the others, what a person has to put where."""

    worlds: tuple[str, ...]
    by_hand: dict[str, Reason] = {}


class TaskFigure(Struct, frozen=True):
    """Figures of a task since they were last asked for (§A.5 STATINFO); times in milliseconds, utilisations 0 to 1."""

    subsystem: str
    task: str
    rmod: str
    rtpu: str
    tid: int
    type: str
    """P, Y or A."""
    crit: int
    state: str
    cycle: int
    miss: int
    ref_hz: float
    mez_hz: float
    ptime_s: float
    total_ms: float
    tick_ms: float
    least_use: float
    most_use: float
    mean_use: float
    least_ms: float
    most_ms: float
    mean_ms: float
    warn: int


class Figures(Struct, frozen=True, tag=True):
    """Figures of all tasks and loads of all processing units."""

    tasks: tuple[TaskFigure, ...]
    loads: dict[str, float]
    overloads: tuple[Reason, ...] = ()
    """Sentences about units that have or will have more to do than time (X13)."""
    cycles_us: dict[str, float] = {}
    """The mean time of a cycle in microseconds, by the digest of the code, wherever it was measured (X13)."""


class Findings(Struct, frozen=True, tag=True):
    """What a check of memory found, as sentences that name the variable and who could have written it; none: sound."""

    findings: tuple[Reason, ...]


class WorldList(Struct, frozen=True, tag=True):
    """The worlds that are installed: whether they are simulated, and why others cannot be used."""

    simulated: dict[str, bool]
    faults: dict[str, Reason] = {}


class Scenery(Struct, frozen=True, tag=True):
    """What a world consists of, once; poses follow as readings."""

    scene: dict[str, Any]


LiveResponse = (
    Accepted | Value | Values | Standing | WorldsPutBack | Figures | Findings | Scenery | WorldList | Described | Solved
)
