"""The oracle of a simulated link: it knows what really happened and says what the link got wrong."""

from dataclasses import dataclass, field
from enum import Enum

from kit.link.sim_link import SimLink
from onika.link.channel import Channel
from onika.link.link_events import (
    EpochChanged,
    Greeted,
    LinkNotice,
    LinkStateChanged,
    ReadingReceived,
    ReplyReceived,
    RequestFailed,
    RequestFate,
    RequestReceived,
    SignalReceived,
)
from onika.link.lost import LossCause
from onika.link.state import LinkState
from onika.wire.packet import Bye, Hello, Packet, Welcome


class Who(Enum):
    """The two ends."""

    ENVIRONMENT = "environment"
    RUNTIME = "runtime"


@dataclass(slots=True, eq=False)
class _Story:
    """What one environment believes."""

    epoch: str = ""
    next: int = 0


@dataclass(slots=True, eq=False)
class _Guest:
    """The true story of one session of the runtime, as far as it is heard on its asking channel."""

    heard_ns: int
    is_there: bool = False
    has_left: bool = False


@dataclass(slots=True, eq=False)
class Wanted:
    """One request and its true story; all times are true time in ns."""

    label: str
    client: str
    body: bytes
    once: bool
    begin_by_ns: int
    cable: SimLink | None
    begun: int = 0
    outcomes: list[LinkNotice] = field(default_factory=list)
    is_abandoned: bool = False


class LinkOracle:
    """Collects `faults`; an empty list at the end means that all promises were kept."""

    def __init__(self) -> None:
        self.faults: list[str] = []
        self.begun = 0
        self.accepted = 0
        self._signals: dict[str, list[bytes]] = {}
        self._wanted: dict[str, Wanted] = {}
        self._numbers: dict[tuple[str, int], Wanted] = {}
        self._stories: dict[str, _Story] = {}
        self._sessions: dict[str, _Guest] = {}
        self._clients: dict[str, str] = {}
        self._anew: set[str] = set()

    # -- what really happens

    def environment_starts(self, client: str) -> None:
        """A new environment, which knows nothing."""
        self._stories[client] = _Story()

    def environment_ends(self, client: str) -> None:
        """The environment is no more; whoever comes under its name knows nothing of it."""
        for wanted in self._wanted.values():
            wanted.is_abandoned |= wanted.client == client

    def comes_anew(self, client: str) -> None:
        """A new one comes under an old name, in whose sessions nothing is promised to the old one any more."""
        self._anew.add(client)
        for name, other in self._clients.items():
            if other == client and name in self._sessions:
                self._sessions[name].has_left = True

    def house_ends(self) -> None:
        """The runtime is no more, and so are its sessions."""
        self._sessions.clear()

    def leaves(self, client: str) -> None:
        """The environment said good-bye; whether that arrives is another question."""
        for name, other in self._clients.items():
            if other == client and name in self._sessions:
                self._sessions[name].has_left = True

    def session(self, name: str, epoch: str, client: str) -> None:
        """The runtime took a connection to this session."""
        self._signals.setdefault(epoch, [])
        self._clients[name] = client

    def called(self, name: str, now_ns: int) -> None:
        """A packet came on the asking channel of this session."""
        self._sessions.setdefault(name, _Guest(now_ns)).heard_ns = now_ns

    def signal(self, epoch: str, body: bytes) -> None:
        """The runtime wants this to arrive."""
        self._signals.setdefault(epoch, []).append(body)

    def wants(self, wanted: Wanted, number: int) -> None:
        """An environment asks."""
        self._wanted[wanted.label] = wanted
        self._numbers[wanted.client, number] = wanted

    def sent(self, who: Who, cable: SimLink, packet: Packet) -> None:
        """A packet left an end: nothing but the greeting may be said before it is complete, and all in its place."""
        self._unless(cable.channel.carries(packet), f"{packet!r} has no place on the {cable.channel.value} channel")
        if isinstance(packet, Bye):
            return
        if who is Who.RUNTIME:
            if isinstance(packet, Welcome) and cable.heard_hello:
                cable.is_welcomed = True
                length = len(self._signals[packet.epoch]) if cable.channel is Channel.ALL else 0
                cable.beginning = cable.beginning or (packet.epoch, length)
            self._unless(cable.is_welcomed, f"the runtime said {packet!r} before the greeting")
        elif not isinstance(packet, Hello):
            self._unless(cable.heard_welcome, f"the environment said {packet!r} before the welcome")

    # -- what the programs are told

    def heard(self, client: str, notice: LinkNotice, asking: SimLink | None, stream: SimLink | None = None) -> None:
        """An environment is told something by its link, whose channels have these connections."""
        stream = stream or asking
        match notice:
            case LinkStateChanged(_, why) if why is not None:
                fine = why.cause in (LossCause.CLOSED, LossCause.SILENT)
                self._unless(fine, f"an honest environment ended the connection: {why}")
            case EpochChanged(epoch):
                self._epoch_changed(client, epoch, asking)
            case SignalReceived():
                self._signalled(self._stories[client], notice)
            case ReplyReceived(number) | RequestFailed(number):
                self._outcome(notice, client, number)
            case ReadingReceived(_, body) if stream is not None:
                self._unless(int(body) > stream.shown, f"reading {body!r} shown after {stream.shown}")
                stream.shown = int(body)

    def served(self, name: str, notice: LinkNotice, cable: SimLink | None, now_ns: int) -> None:
        """The runtime is told something by a session's link."""
        match notice:
            case LinkStateChanged(_, why) if why is not None:
                fine = why.cause in (LossCause.CLOSED, LossCause.SILENT, LossCause.HERE)
                self._unless(fine, f"an honest runtime ended the connection: {why}")
            case Greeted() if cable is not None and cable.channel.asks:
                self._sessions.setdefault(name, _Guest(now_ns)).is_there = True
            case RequestReceived():
                self._asked(notice, cable, now_ns)

    def given_up(self, name: str, now_ns: int, lost_ns: int) -> None:
        """The runtime gives a session up: once, and only for a reason."""
        session = self._sessions.get(name)
        if session is None or not session.is_there:
            self.faults.append(f"session {name} was given up, but it was not there")
            return
        silence_ns = now_ns - session.heard_ns
        fine = session.has_left or self._clients[name] in self._anew or silence_ns >= lost_ns
        self._unless(fine, f"session {name} was given up {silence_ns} ns after it was heard")
        session.is_there = False

    def stands(self, now_ns: int, lost_ns: int) -> None:
        """All sessions that are there were heard of late."""
        for name, session in self._sessions.items():
            silence_ns = now_ns - session.heard_ns
            fine = not session.is_there or silence_ns < lost_ns
            self._unless(fine, f"session {name} was not given up after {silence_ns} ns of silence")

    def heard_last(self, who: Who, state: LinkState, silence_ns: int, suspect_ns: int, lost_ns: int) -> None:
        """How long an end has heard nothing, and what it makes of that."""
        if state is LinkState.LINKED:
            self._unless(silence_ns < suspect_ns, f"the {who.value} suspects nothing after {silence_ns} ns")
        if state in (LinkState.LINKED, LinkState.SUSPECT):
            self._unless(silence_ns < lost_ns, f"the {who.value} noticed no loss after {silence_ns} ns")

    # -- the end

    def final(self, client: str, epoch: str, state: LinkState) -> None:
        """The storm is over and there was time enough to make all good for this environment."""
        story = self._stories[client]
        self._unless(state is LinkState.LINKED, f"no link of {client} at the end but {state}")
        self._unless(story.epoch == epoch, f"{client} believes in epoch {story.epoch!r}, it is {epoch!r}")
        length = len(self._signals.get(epoch, ()))
        self._unless(story.next == length + 1, f"{length} signals said to {client}, {story.next - 1} accepted")

    def final_requests(self) -> None:
        """Every request has come to an end, and to a true one."""
        for wanted in self._wanted.values():
            if not wanted.is_abandoned:
                self._unless(bool(wanted.outcomes), f"request {wanted.label} got neither answer nor failure")
            for outcome in wanted.outcomes:
                if isinstance(outcome, RequestFailed) and outcome.fate in (RequestFate.UNSENT, RequestFate.LATE):
                    self._unless(
                        not wanted.begun, f"request {wanted.label} was carried out, but: {outcome.fate.reason}"
                    )

    def _epoch_changed(self, client: str, epoch: str, asking: SimLink | None) -> None:
        story = self._stories[client]
        self._unless(epoch != story.epoch, f"needless new beginning in epoch {epoch!r}")
        greeted, base = (asking and asking.beginning) or ("", 0)
        self._unless(greeted == epoch, f"new beginning in epoch {epoch!r}, greeted in {greeted!r}")
        story.epoch, story.next = epoch, base + 1

    def _signalled(self, story: _Story, notice: SignalReceived) -> None:
        self.accepted += 1
        self._unless(notice.seq == story.next, f"signal {notice.seq} accepted, {story.next} was next")
        signals = self._signals.get(story.epoch, [])
        fine = 1 <= notice.seq <= len(signals) and signals[notice.seq - 1] == notice.body
        self._unless(fine, f"signal {notice.seq} of epoch {story.epoch!r} is not what was said")
        story.next = notice.seq + 1

    def _asked(self, arrival: RequestReceived, cable: SimLink | None, now_ns: int) -> None:
        self.begun += 1
        wanted = self._wanted.get(arrival.body.partition(b" ")[0].decode())
        if wanted is None or wanted.body != arrival.body:
            self.faults.append(f"asked for {arrival.body!r}, which nobody wanted")
            return
        wanted.begun += 1
        self._unless(wanted.begun == 1, f"request {wanted.label} was carried out {wanted.begun} times")
        self._unless(arrival.client == wanted.client, f"request {wanted.label} came as one of {arrival.client}")
        late = wanted.begin_by_ns and now_ns > wanted.begin_by_ns
        self._unless(not late, f"request {wanted.label} was carried out {now_ns - wanted.begin_by_ns} ns too late")
        same = not wanted.once or wanted.cable is cable
        self._unless(same, f"request {wanted.label} was said again on another connection")

    def _outcome(self, outcome: ReplyReceived | RequestFailed, client: str, number: int) -> None:
        wanted = self._numbers[client, number]
        wanted.outcomes.append(outcome)
        self._unless(len(wanted.outcomes) == 1, f"request {wanted.label} has outcomes {wanted.outcomes}")
        if isinstance(outcome, ReplyReceived):
            self._unless(wanted.begun == 1, f"request {wanted.label} was answered but never carried out")
            self._unless(outcome.body == b"re: " + wanted.body, f"request {wanted.label} got another's answer")

    def _unless(self, fine: bool, fault: str) -> None:
        if not fine:
            self.faults.append(fault)
