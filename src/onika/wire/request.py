"""What the environment asks of a runtime, and the replies: every request gets exactly one."""

from typing import Self

import msgspec
from msgspec import Struct

from onika.wire.booking import BookingRequest, BookingResponse
from onika.wire.foresight import Foreseen, WhatIf
from onika.wire.holding import Company, HoldingRequest, Listening
from onika.wire.live import LiveRequest, LiveResponse
from onika.wire.plan import Code, Index, Plan, PlannedTask
from onika.wire.rendezvous_link import MeetingTerms, RendezvousRequest, RendezvousResponse
from onika.wire.samples import Sample, Sampled
from onika.wire.steer import Positions, SteerRequest
from onika.wire.world_source import WorldSource
from onika.words.fault import Fault, Place
from onika.words.reason import NOTHING, Reason


class FaultText(Struct, frozen=True):
    """A fault on its way: place, what was expected and found, what happens instead."""

    file: str
    line: int
    reason: Reason
    instead: Reason
    where: Reason = NOTHING
    """The flow and the action that it concerns, in words."""
    remedies: tuple[Reason, ...] = ()
    because: tuple[tuple[str, int], ...] = ()
    """The files and lines of the faults of which it is a consequence."""

    @classmethod
    def of(cls, fault: Fault) -> Self:
        """A fault as it travels."""
        because = tuple((place.file, place.line) for place in fault.because)
        at = fault.place
        return cls(at.file, at.line, fault.reason, fault.instead, fault.where, fault.remedies, because)

    @property
    def fault(self) -> Fault:
        """The fault that has come."""
        because = tuple(Place(file, line) for file, line in self.because)
        place = Place(self.file, self.line)
        return Fault(place, self.reason, self.instead, where=self.where, remedies=self.remedies, because=because)


class Prepare(Struct, frozen=True, tag=True):
    """Check a plan against its modules and take it as the next one to run; replied by Prepared."""

    plan: Plan
    targets: tuple["TargetValues", ...]


class TargetValues(Struct, frozen=True):
    """A target by its place in the plan, for the check of reach: its type in lower case, its values flat."""

    flow: Index
    action: Index
    kind: str
    values: tuple[float | int | str, ...]
    name: str = ""


class Resolved(Struct, frozen=True):
    """A joint target that another robot takes by way of its pose, since the flow is redirected (law 26)."""

    flow: int
    action: int
    target: str
    task: str
    """The robot's task that stands for `instead_of`."""
    instead_of: str
    were: tuple[float | int | str, ...]
    values: tuple[float | int | str, ...]


class Inspect(Struct, frozen=True, tag=True):
    """Check tasks against their modules without running anything; replied by Prepared."""

    tasks: tuple[PlannedTask, ...]
    code: tuple[Code, ...]
    worlds: tuple[WorldSource, ...] = ()
    """Worlds that are files, to be compiled too."""


class Recorded(Struct, frozen=True):
    """A request as it was made in a run that is repeated: at an instant, after so many turns of the clock at it."""

    at_ns: int
    """Since the run's start."""
    turn: int
    body: bytes
    """The request, as `encode` makes it."""


class Begin(Struct, frozen=True, tag=True):
    """Run the prepared plan; replied by Done or Refused, then told by events."""

    watch: tuple[str, ...] = ()
    """Addresses `[SUBSYSTEM/]NAME` of variables to read after the last finish."""
    settle_s: float = 0.5
    """How long to wait after the last finish before they are read."""
    seed: int = 0
    answers: tuple[tuple[str, str, str], ...] = ()
    """For tasks that ask: the task, the name of an input, its values."""
    may_ask: bool = False
    """Whether somebody is there to answer; else a question without an answer aborts."""
    on_loss: str = "stop"
    """When the session that began it is lost: `stop`, `finish` the current actions and pause, or `run` on."""
    on_error: str = "abort"
    """When a task that is not passive fails: `abort`, or `wait` until somebody says Recover, Skip or Abort."""
    is_held: bool = False
    """In virtual time: whether the clock stands until `steer.Onward` lets it go on."""
    record: str = ""
    """The file of a recording on this machine; empty: none is made."""
    repeat: tuple[Recorded, ...] = ()
    """In virtual time: what is asked by itself, in the order in which it was once."""
    meets: MeetingTerms | None = None
    """Where the flows meet those of other runtimes, which were linked before: the terms; None: all run here."""
    repeat_until_ns: int = 0
    """Up to when nobody else may ask anything but to end it; -1: to the end."""


class Reply(Struct, frozen=True, tag=True):
    """The user's answer to an asking task, as an argument line."""

    subsystem: str
    task: str
    line: str


class Abort(Struct, frozen=True, tag=True):
    """End the run: tasks off, devices in hold."""

    cause: Reason
    subsystem: str = ""
    """Of the application that runs there; empty: all that this session may end."""


class Stop(Struct, frozen=True, tag=True):
    """Stop everything: every drive in hold, latched; the run ends with this cause (law 27)."""

    cause: Reason


class Snapshot(Struct, frozen=True, tag=True):
    """Ask for the worlds as they stand, to be drawn elsewhere; replied by Worlds."""


class Quit(Struct, frozen=True, tag=True):
    """End the runtime."""


class Prepared(Struct, frozen=True, tag=True):
    """All that is wrong with a plan or with tasks (nothing: it can run), and what is only worth knowing."""

    faults: tuple[FaultText, ...]
    notes: tuple[Reason, ...] = ()
    resolved: tuple[Resolved, ...] = ()
    worlds: dict[str, bool] = {}
    """The worlds that it drives: whether they are simulated."""


class Done(Struct, frozen=True, tag=True):
    """Carried out."""


class Refused(Struct, frozen=True, tag=True):
    """Not carried out, for this reason."""

    reason: Reason


class Worlds(Struct, frozen=True, tag=True):
    """Snapshots of worlds by name."""

    snapshots: dict[str, bytes]
    standings: dict[str, tuple[Reason, ...]] = {}
    """What a world says in sentences of how it stands, where it says so."""
    watched: dict[str, bool] = {}
    """In a forecast: of each open world whether it says what happens there that no program means."""


_RunRequest = Prepare | Inspect | Begin | Reply | Abort | Stop | Snapshot | Quit
_OfOthers = HoldingRequest | BookingRequest | RendezvousRequest
Request = _RunRequest | SteerRequest | LiveRequest | _OfOthers | WhatIf | Sample
Response = (
    Prepared
    | Done
    | Refused
    | Worlds
    | Positions
    | Company
    | Listening
    | BookingResponse
    | LiveResponse
    | RendezvousResponse
    | Foreseen
    | Sampled
)

encode = msgspec.msgpack.Encoder().encode
decode_request = msgspec.msgpack.Decoder(Request).decode
decode_response = msgspec.msgpack.Decoder(Response).decode
