"""The commands that the runner sends to an RTPU, one datagram each; the RTPU answers with news."""

import msgspec
from msgspec import Struct

from onika.wire.sheet import ModuleSheet
from onika.words.reason import Reason


class BoundPort(Struct, frozen=True):
    """A port of a task and the entry it is bound to; the shape is resolved."""

    port: str
    svar: str
    shape: str
    offset: int


class DeviceGrant(Struct, frozen=True):
    """A device that a task may use: where its rings lie, and the epoch of the claim."""

    segment: str
    name: str
    state: tuple[str, ...]
    command: tuple[str, ...]
    identity: dict[str, tuple[float, ...] | str]
    epoch: int
    state_offset: int
    command_offset: int | None
    picture: tuple[int, ...] = ()
    """Of a camera: height and width of its pictures in pixels."""
    picture_offset: int = 0


class Spawn(Struct, frozen=True, tag=True):
    """Bring a task to life and initialise it."""

    subsystem: str
    task: str
    module: str
    path: str
    source: str
    task_type: str
    frequency: float | None
    local: tuple[tuple[str, tuple[str, ...]], ...]
    ports: tuple[BoundPort, ...]
    rank: int
    seed: int
    device: DeviceGrant | None
    cost_ns: int = 0
    """What loading and `init` are expected to take; 0: carry it out at once, whatever is ON (law 21)."""
    init_ns: int = 0
    """The part of it that `init` takes; 0: nobody knows, as long as loading."""
    sandboxed_as: ModuleSheet | None = None
    """Where its module is in a sandbox that was begun for it: what it has to declare there, for it may lie (R-X16)."""

    @property
    def is_sandboxed(self) -> bool:
        """Whether its module is in a process that can do nothing but compute."""
        return self.sandboxed_as is not None


class Launch(Struct, frozen=True):
    """A task to turn ON, its argument line and, where it changes, its rate."""

    task: str
    arguments: str = ""
    frequency: float | None = None
    activation: int = 0
    """Comes back with all news of what follows, until the next Launch."""


class Switch(Struct, frozen=True, tag=True):
    """Turn tasks off and on with no cycle in between; then `forget` no longer steers anything (law 3)."""

    subsystem: str
    off: tuple[str, ...]
    forget: tuple[str, ...]
    on: tuple[Launch, ...]
    rates: tuple[tuple[str, float], ...] = ()


class Together(Struct, frozen=True, tag=True):
    """Switches of several subsystems as one: everything off, then everything on, first cycles at one instant."""

    switches: tuple[Switch, ...]


class Case(Struct, frozen=True):
    """What follows a finish with such a value, None: with any; `number`, from 1, comes back in the news of it."""

    choice: int | None
    loop: bool | None
    number: int
    switch: Switch


class PreparedSwitch(Struct, frozen=True, tag=True):
    """When this task finishes in this activation, carry out the switch of the first case that fits, at once.

    One is held for each subsystem, the last that came; without cases what was prepared is forgotten, and Unprepared
    says so. It is forgotten too with any Switch of the subsystem, with a Stop, a Quit or a Fail, and when a task of the
    subsystem is killed, fails or switches itself off: it counts on who is ON.
    """

    subsystem: str
    task: str
    activation: int
    cases: tuple[Case, ...]


class Appointment(Struct, frozen=True, tag=True):
    """Carry out these switches as one at a time that was agreed with other runtimes, if that is permitted by then.

    The permit, and the word that all others have begun, lie in shared memory (`ring.begin_words`). Without the latter
    every device that tasks of `subsystems` have is held so long after the time (law 34). Appointed and HeldAlone tell.
    """

    number: int
    at_ns: int
    hold_ns: int
    subsystems: tuple[str, ...]
    switches: tuple[Switch, ...] = ()


class CallOff(Struct, frozen=True, tag=True):
    """Forget an appointment; where it has begun already and `holds`, hold it at once, as if nothing were confirmed."""

    number: int
    holds: bool = False


class Rank(Struct, frozen=True, tag=True):
    """New places of living tasks in the order of data flow (law 1); no release is lost."""

    subsystem: str
    ranks: tuple[tuple[str, int], ...]


class Reinit(Struct, frozen=True, tag=True):
    """Initialise a task that is OFF anew: constants in, `reinit`, constants out (law 3)."""

    subsystem: str
    task: str


class Rebind(Struct, frozen=True, tag=True):
    """Bind ports of a living instance to other entries, and set its parameters where `local` is given (law 12).

    The task is OFF or in ERROR; ports that are not named stay as they are. No entry point is called: before it comes
    on again a Reinit has to follow (from ERROR a Clear, which initialises too).
    """

    subsystem: str
    task: str
    ports: tuple[BoundPort, ...]
    local: tuple[tuple[str, tuple[str, ...]], ...] | None = None


class Swap(Struct, frozen=True, tag=True):
    """Exchange the module of the living task of the spawn's name; its rate, state and activation stay (law 21)."""

    spawn: Spawn


class Answer(Struct, frozen=True, tag=True):
    """The user's answer to a task that is ASKING, as an argument line."""

    subsystem: str
    task: str
    line: str


class Clear(Struct, frozen=True, tag=True):
    """Bring a task out of ERROR."""

    subsystem: str
    task: str


class Get(Struct, frozen=True, tag=True):
    """Ask a module for something by name."""

    subsystem: str
    task: str
    name: str


class Set(Struct, frozen=True, tag=True):
    """Tell a module a new value of something by name."""

    subsystem: str
    task: str
    name: str
    value: str


class Kill(Struct, frozen=True, tag=True):
    """End a task."""

    subsystem: str
    task: str


class Report(Struct, frozen=True, tag=True):
    """Ask for the status of every task; counters begin anew with it (requirement A17)."""


class Load(Struct, frozen=True, tag=True):
    """Ask what the tasks cost; nothing begins anew with it (requirement X13)."""


class Stop(Struct, frozen=True, tag=True):
    """Everything off at once, devices in hold (law 27)."""


class Reset(Struct, frozen=True, tag=True):
    """After a Stop: tasks may be spawned and come on again."""


class Fail(Struct, frozen=True, tag=True):
    """Devices are gone for this reason: every task that has one and is ON goes to ERROR (law 17)."""

    cause: Reason


class Starve(Struct, frozen=True, tag=True):
    """A hardware task that is ON goes to ERROR: what it reads comes of a task elsewhere that has failed (law 4)."""

    subsystem: str
    task: str
    cause: Reason


class Quit(Struct, frozen=True, tag=True):
    """End the processing unit."""


Command = (
    Spawn
    | Switch
    | Together
    | PreparedSwitch
    | Appointment
    | CallOff
    | Rank
    | Reinit
    | Rebind
    | Swap
    | Answer
    | Clear
    | Get
    | Set
    | Kill
    | Report
    | Load
    | Stop
    | Reset
    | Fail
    | Starve
    | Quit
)

encode = msgspec.msgpack.Encoder().encode
decode = msgspec.msgpack.Decoder(Command).decode
