"""The witness of a simulated link: it knows what really happened and says what the link got wrong."""

from dataclasses import dataclass, field
from enum import Enum

from onika.link.happening import Asked, EpochChanged, Failed, Fate, Greeted, Happening, Read, Replied, Signalled, Turned
from onika.link.lost import Cause
from onika.link.state import LinkState
from onika.wire.packet import Bye, Hello, Packet


class Who(Enum):
    """The two ends."""

    ENVIRONMENT = "environment"
    RUNTIME = "runtime"


@dataclass(slots=True, eq=False)
class Connection:
    """One simulated connection, and how far its greeting is."""

    is_broken: bool = False
    heard_hello: bool = False
    heard_welcome: bool = False
    shown: int = 0


@dataclass(slots=True, eq=False)
class Wanted:
    """One request and its true story; all times are true time in ns."""

    label: str
    body: bytes
    once: bool
    begin_by_ns: int
    connection: Connection | None
    begun: int = 0
    outcomes: list[Happening] = field(default_factory=list)
    is_abandoned: bool = False


class Witness:
    """Collects `faults`; an empty list at the end means that all promises were kept."""

    def __init__(self) -> None:
        self.faults: list[str] = []
        self.begun = 0
        self.accepted = 0
        self._signals: dict[str, list[bytes]] = {}
        self._base: dict[str, tuple[str, int]] = {}
        self._wanted: dict[str, Wanted] = {}
        self._numbers: dict[tuple[str, int], Wanted] = {}
        self._client = ""
        self._epoch = ""
        self._next = 0

    def environment_starts(self, client: str) -> None:
        """A new environment, which knows nothing."""
        self._client, self._epoch, self._next = client, "", 0
        for wanted in self._wanted.values():
            wanted.is_abandoned = True

    def runtime_starts(self, epoch: str) -> None:
        """A new life of the runtime."""
        self._signals.setdefault(epoch, [])

    def signal(self, epoch: str, body: bytes) -> None:
        """The runtime wants this to arrive."""
        self._signals[epoch].append(body)

    def wants(self, wanted: Wanted, number: int) -> None:
        """The environment asks."""
        self._wanted[wanted.label] = wanted
        self._numbers[self._client, number] = wanted

    def sent(self, who: Who, connection: Connection, packet: Packet) -> None:
        """A packet left an end: nothing but the greeting may be said before it is complete."""
        if isinstance(packet, Bye):
            return
        if who is Who.RUNTIME:
            self._unless(connection.heard_hello, f"the runtime said {packet!r} before the hello")
        elif not isinstance(packet, Hello):
            self._unless(connection.heard_welcome, f"the environment said {packet!r} before the welcome")

    def happened(self, who: Who, happening: Happening, connection: Connection | None, now_ns: int) -> None:
        """An end told its owner something."""
        match happening:
            case Turned(_, why) if why is not None:
                fine = why.cause in (Cause.CLOSED, Cause.SILENT)
                self._unless(fine, f"an honest {who.value} ended the connection: {why}")
            case Greeted(client, False):
                epoch = next(reversed(self._signals))
                self._base[client] = (epoch, len(self._signals[epoch]))
            case EpochChanged(epoch):
                self._epoch_changed(epoch)
            case Signalled():
                self._signalled(happening)
            case Asked():
                self._asked(happening, connection, now_ns)
            case Replied(number) | Failed(number):
                self._outcome(happening, number)
            case Read(_, body) if connection is not None:
                self._unless(int(body) > connection.shown, f"reading {body!r} shown after {connection.shown}")
                connection.shown = int(body)

    def heard_last(self, who: Who, state: LinkState, silence_ns: int, suspect_ns: int, lost_ns: int) -> None:
        """How long an end has heard nothing, and what it makes of that."""
        if state is LinkState.LINKED:
            self._unless(silence_ns < suspect_ns, f"the {who.value} suspects nothing after {silence_ns} ns")
        if state in (LinkState.LINKED, LinkState.SUSPECT):
            self._unless(silence_ns < lost_ns, f"the {who.value} noticed no loss after {silence_ns} ns")

    def final(self, epoch: str, states: set[LinkState]) -> None:
        """The storm is over and there was time enough to make all good."""
        self._unless(states == {LinkState.LINKED}, f"no link at the end but {states}")
        self._unless(self._epoch == epoch, f"the environment believes in epoch {self._epoch!r}, it is {epoch!r}")
        said = len(self._signals[epoch])
        self._unless(self._next == said + 1, f"{said} signals said, {self._next - 1} accepted")
        for wanted in self._wanted.values():
            self._final(wanted)

    def _final(self, wanted: Wanted) -> None:
        if not wanted.is_abandoned:
            self._unless(bool(wanted.outcomes), f"request {wanted.label} got neither answer nor failure")
        for outcome in wanted.outcomes:
            if isinstance(outcome, Failed) and outcome.fate in (Fate.UNSENT, Fate.LATE):
                self._unless(not wanted.begun, f"request {wanted.label} was carried out, but: {outcome.fate.value}")

    def _epoch_changed(self, epoch: str) -> None:
        self._unless(epoch != self._epoch, f"needless new beginning in epoch {epoch!r}")
        self._epoch = epoch
        known, base = self._base.get(self._client, ("", 0))
        self._unless(known == epoch, f"new beginning in epoch {epoch!r}, greeted in {known!r}")
        self._next = base + 1

    def _signalled(self, happening: Signalled) -> None:
        self.accepted += 1
        self._unless(happening.seq == self._next, f"signal {happening.seq} accepted, {self._next} was next")
        said = self._signals.get(self._epoch, [])
        fine = 1 <= happening.seq <= len(said) and said[happening.seq - 1] == happening.body
        self._unless(fine, f"signal {happening.seq} of epoch {self._epoch!r} is not what was said")
        self._next = happening.seq + 1

    def _asked(self, asked: Asked, connection: Connection | None, now_ns: int) -> None:
        self.begun += 1
        wanted = self._wanted.get(asked.body.partition(b" ")[0].decode())
        if wanted is None or wanted.body != asked.body:
            self.faults.append(f"asked for {asked.body!r}, which nobody wanted")
            return
        wanted.begun += 1
        self._unless(wanted.begun == 1, f"request {wanted.label} was carried out {wanted.begun} times")
        late = wanted.begin_by_ns and now_ns > wanted.begin_by_ns
        self._unless(not late, f"request {wanted.label} was carried out {now_ns - wanted.begin_by_ns} ns too late")
        same = not wanted.once or wanted.connection is connection
        self._unless(same, f"request {wanted.label} was said again on another connection")

    def _outcome(self, outcome: Replied | Failed, number: int) -> None:
        wanted = self._numbers[self._client, number]
        wanted.outcomes.append(outcome)
        self._unless(len(wanted.outcomes) == 1, f"request {wanted.label} has outcomes {wanted.outcomes}")
        if isinstance(outcome, Replied):
            self._unless(wanted.begun == 1, f"request {wanted.label} was answered but never carried out")
            self._unless(outcome.body == b"re: " + wanted.body, f"request {wanted.label} got another's answer")

    def _unless(self, fine: bool, fault: str) -> None:
        if not fine:
            self.faults.append(fault)
