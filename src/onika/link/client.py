"""The environment's end of the link: it sends requests, and accepts signals once and in order. Sans-I/O (§5.8.2)."""

from dataclasses import dataclass

from onika.link import lost
from onika.link.body_parts import BodyAssembly, split
from onika.link.channel import Channel
from onika.link.link_events import (
    EpochChanged,
    LinkNotice,
    ReadingReceived,
    ReplyReceived,
    RequestFailed,
    RequestFate,
    Resumed,
    SignalReceived,
)
from onika.link.link_terms import LOCAL, LinkTerms
from onika.link.liveness import Liveness
from onika.link.readings import Readings
from onika.link.send_queues import SendQueues
from onika.link.state import LinkEvent, LinkState
from onika.wire.packet import (
    VERSION,
    Ack,
    Beat,
    Bye,
    Hello,
    Packet,
    Part,
    ReadingPacket,
    ReplyPacket,
    RequestPacket,
    SignalPacket,
    Welcome,
)
from onika.words.reason import NOTHING, Reason, as_reason, reason_of


@dataclass(slots=True)
class _PendingRequest:
    """A request that is not answered yet."""

    body: bytes
    once: bool
    urgent: bool
    begin_by_ns: int
    sent_ns: int | None = None


class ClientEnd:
    """One environment's session with one runtime over one connection after another.

    What it promises: signals of an epoch are accepted in order, each exactly once; every request is answered exactly
    once or reported as failed; on a new connection nothing is said before the greeting; in a new epoch nothing that
    was meant for the old one is said.
    """

    def __init__(self, client: str, terms: LinkTerms = LOCAL, channel: Channel = Channel.ALL) -> None:
        self.epoch = ""
        self._client = client
        self._terms = terms
        self._channel = channel
        self._notices: list[LinkNotice] = []
        self._liveness = Liveness(terms, self._notices)
        self._queues = SendQueues(Readings())
        self._assembly = BodyAssembly(terms.body_limit)
        self._wishes: dict[int, _PendingRequest] = {}
        self.request_count = 0
        self._accepted = 0
        self._ack_due = False
        self._hello_ns = 0
        self._reading = 0
        self._clock_ahead_ns = 0

    @property
    def state(self) -> LinkState:
        """How this end stands to the runtime."""
        return self._liveness.state

    def open(self, now_ns: int) -> None:
        """There is a new connection, in place of any old one: greet on it."""
        self._drop_connection()
        self._liveness.opened(now_ns)
        self._fail(RequestFate.LOST, [number for number, wish in self._wishes.items() if wish.once])
        self._greet(now_ns)

    def cut(self, why: lost.LinkLost) -> None:
        """The connection is gone or unusable."""
        if self.state not in (LinkState.APART, LinkState.ENDED):
            self._end(LinkEvent.CUT, why)
            if why.cause is lost.LossCause.GARBAGE:
                self._queues.last(Bye("garbage", why.reason))

    def follow(self, epoch: str) -> None:
        """To a channel that does not ask: the session it belongs to is in this epoch; in a new one it begins anew."""
        self._accepted, self.epoch = (self._accepted if epoch == self.epoch else 0), epoch

    def close(self, reason: Reason = NOTHING) -> None:
        """End the link for good; the good-bye is still to be sent."""
        if self.state is LinkState.ENDED:
            return
        linked = self._liveness.is_linked
        self._end(LinkEvent.CLOSED, lost.here(reason))
        if linked:
            self._queues.last(Bye("closed", reason))

    def request(
        self, body: bytes, now_ns: int, begin_within_ns: int = 0, once: bool = False, urgent: bool = False
    ) -> int:
        """Ask for something; its number.

        begin_within_ns  the runtime refuses it if it comes later than this (0: never too late)
        once             never said again on another connection: for what moves a robot
        urgent           passes other requests that wait to be sent
        """
        self.request_count += 1
        begin_by_ns = now_ns + begin_within_ns if begin_within_ns else 0
        self._wishes[self.request_count] = _PendingRequest(body, once, urgent, begin_by_ns)
        if len(body) > self._terms.body_limit:
            self._fail(RequestFate.TOO_LONG, [self.request_count])
        elif self._liveness.is_linked:
            self._send(self.request_count, now_ns)
        elif once or self.state is LinkState.ENDED:
            self._fail(RequestFate.UNSENT, [self.request_count])
        return self.request_count

    def forget(self, number: int) -> None:
        """The answer to this request is not wanted any more."""
        if self._wishes.pop(number, None) is not None:
            self._assembly.drop(number)

    def feed(self, packet: Packet, now_ns: int) -> None:
        """A packet came."""
        if self.state is LinkState.GREETING:
            self._feed_greeting(packet, now_ns)
        elif self._liveness.is_linked:
            self._liveness.note_arrival(now_ns)
            self._feed_linked(packet, now_ns)

    def tick(self, now_ns: int) -> None:
        """Time has passed; call when `due_ns` is over, after everything that came was fed."""
        silence = self._liveness.listen(now_ns)
        if silence is not None:
            self._end(LinkEvent.SILENT, silence)
            return
        beat = self._liveness.beat(now_ns)
        if beat is not None:
            self._queues.signal(beat)
        self._retry(now_ns)

    def due_ns(self, now_ns: int) -> int | None:
        """How long until `tick` has something to do; None: not before something else happens."""
        return self._liveness.due_ns(now_ns, may_retry=bool(self._wishes))

    def take_packets(self, now_ns: int, room: int) -> list[Packet]:
        """What is to be sent now, where the connection has room for about so many bytes."""
        if self._ack_due:
            self._ack_due = False
            self._queues.signal(Ack(self._accepted))
        return self._queues.take(room, now_ns)

    def take_notices(self) -> list[LinkNotice]:
        """What the owner has not been told yet, in order."""
        taken = self._notices.copy()
        self._notices.clear()
        return taken

    def _greet(self, now_ns: int) -> None:
        self._hello_ns = now_ns
        self._queues.signal(Hello(VERSION, self._client, self.epoch, self._accepted))

    def _feed_greeting(self, packet: Packet, now_ns: int) -> None:
        match packet:
            case Welcome():
                self._welcome(packet, now_ns)
            case Bye():
                self._bye(packet)
            case _:
                # a carrier that reorders may bring other packets first; they will be said again
                self._unexpected(packet)

    def _feed_linked(self, packet: Packet, now_ns: int) -> None:
        if not self._channel.carries(packet):
            self._garbage(Reason.of("link.no_place", packet=type(packet).__name__, channel=self._channel.value))
            return
        match packet:
            case SignalPacket():
                self._signal(packet)
            case ReplyPacket():
                self._reply(packet)
            case Part():
                self._part(packet)
            case ReadingPacket():
                self._read(packet)
            case Beat():
                self._clock_ahead_ns = packet.clock_ns - now_ns
            case Bye():
                self._bye(packet)
            case _:
                self._unexpected(packet)

    def _welcome(self, packet: Welcome, now_ns: int) -> None:
        if packet.version != VERSION:
            self._end(LinkEvent.REFUSED, lost.version(VERSION, packet.version))
            return
        if not self._channel.asks and packet.epoch != self.epoch:
            self.cut(lost.closed(Reason.of("link.runtime_anew")))
            return
        first, resumed = not self.epoch, packet.resumed and packet.epoch == self.epoch
        self._clock_ahead_ns = packet.clock_ns - now_ns
        self._liveness.greeted(now_ns)
        if resumed:
            self._notices.append(Resumed(self.epoch))
        else:
            if not first:
                self._fail(RequestFate.LOST, list(self._wishes))
            self.epoch = packet.epoch
            self._accepted = packet.seq
            self._notices.append(EpochChanged(self.epoch))
        for number in list(self._wishes):
            self._send(number, now_ns)

    def _signal(self, packet: SignalPacket) -> None:
        # only the very next one: a gap means that what lies between was never said on this connection
        if packet.seq == self._accepted + 1:
            self._accepted = packet.seq
            self._notices.append(SignalReceived(packet.seq, packet.body))
        self._ack_due = True

    def _reply(self, packet: ReplyPacket) -> None:
        if packet.number not in self._wishes:
            return
        body = self._assembly.complete(packet.number, packet.parts, packet.body)
        if body is None:
            return
        del self._wishes[packet.number]
        late = RequestFailed(packet.number, RequestFate.LATE)
        self._notices.append(late if packet.late else ReplyReceived(packet.number, body))

    def _part(self, packet: Part) -> None:
        if packet.number not in self._wishes:
            return
        try:
            self._assembly.put(packet)
        except ValueError as fault:
            self._garbage(reason_of(fault))

    def _read(self, packet: ReadingPacket) -> None:
        if packet.count > self._reading:
            self._reading = packet.count
            self._notices.append(ReadingReceived(packet.key, packet.body))

    def _bye(self, packet: Bye) -> None:
        is_refused = packet.cause == "version" and self.state is LinkState.GREETING
        end = LinkEvent.REFUSED if is_refused else LinkEvent.CUT
        self._end(end, lost.link_lost(packet.cause, as_reason(packet.reason)))

    def _unexpected(self, packet: Packet) -> None:
        if isinstance(packet, Hello | RequestPacket | Ack):
            self._garbage(Reason.of("link.not_of_runtime", packet=type(packet).__name__))

    def _garbage(self, detail: Reason) -> None:
        self.cut(lost.garbage(detail))

    def _send(self, number: int, now_ns: int) -> None:
        wish = self._wishes[number]
        if wish.begin_by_ns and now_ns > wish.begin_by_ns and wish.sent_ns is None:
            self._fail(RequestFate.UNSENT, [number])
            return
        wish.sent_ns = now_ns
        # the runtime's clock alone judges lateness; the last reading of it is behind by the way here, never ahead
        deadline_ns = max(1, wish.begin_by_ns + self._clock_ahead_ns) if wish.begin_by_ns else 0
        parts, last = split(number, wish.body, self._terms.piece)
        request = RequestPacket(number, next(iter(self._wishes)), deadline_ns, len(parts), last)
        self._queues.session(parts, request, wish.urgent)

    def _retry(self, now_ns: int) -> None:
        retry_ns = self._terms.retry_ns
        if not retry_ns:
            return
        if self.state is LinkState.GREETING and now_ns - self._hello_ns >= retry_ns:
            self._greet(now_ns)
        if self._liveness.is_linked:
            for number, wish in list(self._wishes.items()):
                if wish.sent_ns is not None and now_ns - wish.sent_ns >= retry_ns:
                    self._send(number, now_ns)

    def _fail(self, fate: RequestFate, numbers: list[int]) -> None:
        for number in numbers:
            del self._wishes[number]
            self._notices.append(RequestFailed(number, fate))

    def _end(self, event: LinkEvent, why: lost.LinkLost) -> None:
        self._drop_connection()
        self._liveness.turn(event, why)
        if self.state is LinkState.ENDED:
            self._fail(RequestFate.LOST, list(self._wishes))
        else:
            self._fail(RequestFate.LOST, [number for number, wish in self._wishes.items() if wish.once])

    def _drop_connection(self) -> None:
        self._queues.clear()
        self._assembly.clear()
        self._ack_due = False
        self._reading = 0
