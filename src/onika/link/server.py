"""The runtime's end of the link: it sends signals and answers requests. No I/O, no clock (§5.8.2)."""

from dataclasses import dataclass

from onika.link import lost
from onika.link.body_parts import BodyAssembly, split
from onika.link.channel import Channel
from onika.link.link_events import Greeted, LinkNotice, RequestReceived
from onika.link.link_quality import LinkQuality
from onika.link.link_terms import LOCAL, LinkTerms
from onika.link.liveness import Liveness
from onika.link.readings import Readings
from onika.link.reply_log import ClientReplies, ReplyLog, StoredReply
from onika.link.send_queues import SendQueues
from onika.link.signal_journal import SignalJournal
from onika.link.state import LinkEvent, LinkState
from onika.wire.packet import (
    VERSION,
    Ack,
    Beat,
    Bye,
    Hello,
    Packet,
    Part,
    ReplyPacket,
    RequestPacket,
    SignalPacket,
    Welcome,
)
from onika.words.reason import NOTHING, Reason, as_reason, reason_of


@dataclass(frozen=True, slots=True)
class _Ticket:
    client_replies: ClientReplies
    number: int


class ServerEnd:
    """A runtime's session with one environment at a time, over one connection after another.

    Several ends may share a journal and a reply log: then several environments hear the same signals.
    What it promises: a signal is in the journal before it is said, and said again until it is acknowledged; a request
    is handed over at most once, whatever the connections do; on a new connection nothing is said before the greeting.
    """

    def __init__(
        self, journal: SignalJournal, replies: ReplyLog, terms: LinkTerms = LOCAL, channel: Channel = Channel.ALL
    ) -> None:
        self._journal = journal
        self._replies = replies
        self._terms = terms
        self._channel = channel
        self._notices: list[LinkNotice] = []
        self._liveness = Liveness(terms, self._notices)
        self._readings = Readings(terms.reading_age_ns)
        self._queues = SendQueues(self._readings)
        self._assembly = BodyAssembly(terms.body_limit)
        self._client_replies: ClientReplies | None = None
        self._welcome: Welcome | None = None
        self._tickets: dict[int, _Ticket] = {}
        self._last_ticket = 0
        self._sent_to = 0
        self._acked = 0
        self._progress_ns = 0
        self.link_quality = LinkQuality()
        """Of the present connection, or the last one."""

    @property
    def state(self) -> LinkState:
        """How this end stands to the environment."""
        return self._liveness.state

    @property
    def heard_ns(self) -> int:
        """When the environment was heard last, on this side's clock."""
        return self._liveness.heard_ns

    def open(self, now_ns: int) -> None:
        """There is a new connection, in place of any old one; the environment speaks first."""
        self._drop_connection()
        self.link_quality = LinkQuality()
        self._liveness.opened(now_ns)

    def cut(self, why: lost.LinkLost) -> None:
        """The connection is gone or unusable."""
        if self.state not in (LinkState.APART, LinkState.ENDED):
            self._end(LinkEvent.CUT, why)
            if why.cause is lost.LossCause.GARBAGE:
                self._queues.last(Bye("garbage", why.reason))

    def close(self, reason: Reason = NOTHING) -> None:
        """End the link for good; signals and answers so far and the good-bye are still to be sent."""
        if self.state is LinkState.ENDED:
            return
        if self._liveness.is_linked:
            self._queues.last(Bye("closed", reason))
        self._liveness.turn(LinkEvent.CLOSED, lost.here(reason))

    def signal(self, body: bytes, now_ns: int) -> int:
        """Say something that must arrive, once and in order; its number. Legal in every state."""
        if len(body) > self._terms.single:
            raise ValueError(f"expected a signal of {self._terms.single} bytes at most, found {len(body)}")
        seq = self._journal.append(body)
        self._say(now_ns)
        return seq

    def reply(self, ticket: int, body: bytes) -> None:
        """Answer a request, once; raises KeyError for a ticket that was never given or is answered already."""
        if len(body) > self._terms.body_limit:
            raise ValueError(f"expected a reply of {self._terms.body_limit} bytes at most, found {len(body)}")
        request = self._tickets.pop(ticket)
        self._answer(request.client_replies, request.number, StoredReply(body))

    def reading(self, key: str, body: bytes, now_ns: int) -> None:
        """Show the newest value under a key, if there is somebody to see it and room on the way."""
        if len(body) > self._terms.single:
            raise ValueError(f"expected a reading of {self._terms.single} bytes at most, found {len(body)}")
        if self._liveness.is_linked:
            self._readings.put(key, body, now_ns)

    def feed(self, packet: Packet, now_ns: int) -> None:
        """A packet came."""
        if self.state is LinkState.GREETING:
            self._feed_greeting(packet, now_ns)
        elif self._client_replies is not None:
            self._liveness.note_arrival(now_ns)
            self._feed_linked(self._client_replies, packet, now_ns)

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
        self._say(now_ns)

    def due_ns(self, now_ns: int) -> int | None:
        """How long until `tick` has something to do; None: not before something else happens."""
        return self._liveness.due_ns(now_ns, may_retry=self._acked < self._sent_to)

    def take_packets(self, now_ns: int, room: int) -> list[Packet]:
        """What is to be sent now, where the connection has room for about so many bytes."""
        return self._queues.take(room, now_ns)

    def take_notices(self) -> list[LinkNotice]:
        """What the owner has not been told yet, in order."""
        taken = self._notices.copy()
        self._notices.clear()
        return taken

    def _feed_greeting(self, packet: Packet, now_ns: int) -> None:
        match packet:
            case Hello():
                self._hello(packet, now_ns)
            case Bye():
                self._bye(packet)
            case _:
                self._garbage(Reason.of("link.begins_unfit", packet=type(packet).__name__))

    def _feed_linked(self, client_replies: ClientReplies, packet: Packet, now_ns: int) -> None:
        if not self._channel.carries(packet):
            self._garbage(Reason.of("link.no_place", packet=type(packet).__name__, channel=self._channel.value))
            return
        match packet:
            case RequestPacket():
                self._request(client_replies, packet, now_ns)
            case Part():
                self._part(client_replies, packet)
            case Ack():
                self._ack(packet, now_ns)
            case Hello():
                self._hello_again(client_replies, packet)
            case Bye():
                self._bye(packet)
            case Beat():  # it was heard, that is all it is for
                self.link_quality = self.link_quality.after(packet, now_ns)
            case _:
                self._garbage(Reason.of("link.not_of_environment", packet=type(packet).__name__))

    def _hello(self, hello: Hello, now_ns: int) -> None:
        if hello.version != VERSION:
            self._end(LinkEvent.CUT, lost.version(VERSION, hello.version))
            refusal = Reason.of("link.version_refused", mine=VERSION, theirs=hello.version)
            self._queues.last(Bye("version", refusal.text))  # a sentence: every version of the link reads it
            return
        client_replies = self._replies.find(hello.client)
        same_epoch = hello.epoch == self._journal.epoch
        resumed = client_replies is not None and same_epoch and self._journal.reaches_back_to(hello.seq)
        if client_replies is not None and resumed:
            self._replies.renew(hello.client)
            self._client_replies, self._acked = client_replies, hello.seq
        else:
            self._client_replies, self._acked = self._replies.begin(hello.client), self._journal.last
        self._sent_to = self._acked
        self._progress_ns = now_ns
        self._welcome = Welcome(VERSION, self._journal.epoch, self._acked, resumed, now_ns)
        self._queues.signal(self._welcome)
        self._liveness.greeted(now_ns)
        self._notices.append(Greeted(hello.client, resumed))
        self._say(now_ns)

    def _hello_again(self, client_replies: ClientReplies, hello: Hello) -> None:
        if hello.client != client_replies.client:
            self._garbage(Reason.of("link.second_greeting"))
        elif self._welcome is not None:
            # it may have been lost: the same once more, for what was said since goes on from there
            self._queues.signal(self._welcome)

    def _request(self, client_replies: ClientReplies, request: RequestPacket, now_ns: int) -> None:
        client_replies.settle(request.done_below)
        if len(client_replies.under_way) + len(
            client_replies.answers
        ) >= self._terms.unsettled and client_replies.is_new(request.number):
            self._garbage(Reason.of("link.unsettled", limit=self._terms.unsettled))
            return
        if request.number in client_replies.answers:
            self._repeat(client_replies, request.number)
        if not client_replies.is_new(request.number):
            return
        body = self._assembly.complete(request.number, request.parts, request.body)
        if body is None:
            return
        client_replies.under_way.add(request.number)
        if request.deadline_ns and now_ns > request.deadline_ns:
            self._answer(client_replies, request.number, StoredReply(b"", late=True))
            return
        self._last_ticket += 1
        self._tickets[self._last_ticket] = _Ticket(client_replies, request.number)
        self._notices.append(RequestReceived(self._last_ticket, client_replies.client, body))

    def _answer(self, client_replies: ClientReplies, number: int, answer: StoredReply) -> None:
        if (
            client_replies.answer(number, answer)
            and client_replies is self._client_replies
            and self._liveness.is_linked
        ):
            self._repeat(client_replies, number)

    def _repeat(self, client_replies: ClientReplies, number: int) -> None:
        answer = client_replies.answers[number]
        parts, last = split(number, answer.body, self._terms.piece)
        self._queues.session(parts, ReplyPacket(number, answer.late, len(parts), last))

    def _part(self, client_replies: ClientReplies, part: Part) -> None:
        if not client_replies.is_new(part.number):
            return
        try:
            self._assembly.put(part)
        except ValueError as fault:
            self._garbage(reason_of(fault))

    def _ack(self, ack: Ack, now_ns: int) -> None:
        if ack.seq > self._journal.last:
            self._garbage(Reason.of("link.acknowledged_ahead", number=ack.seq, last=self._journal.last))
        elif ack.seq > self._acked:
            self._acked = ack.seq
            self._sent_to = max(self._sent_to, ack.seq)
            self._progress_ns = now_ns
            self._say(now_ns)

    def _say(self, now_ns: int) -> None:
        """Say what is in the journal and not said yet, as far as the window allows."""
        if not self._liveness.is_linked:
            return
        if self._sent_to == self._acked:
            self._progress_ns = now_ns
        if not self._journal.reaches_back_to(self._sent_to):
            why = Reason.of("link.signal_forgotten", number=self._sent_to + 1)
            self._end(LinkEvent.CUT, lost.behind(why))
            self._queues.last(Bye("behind", why))
            return
        while self._sent_to < self._journal.last and self._sent_to - self._acked < self._terms.window:
            self._sent_to += 1
            self._queues.signal(SignalPacket(self._sent_to, self._journal.body(self._sent_to)))

    def _retry(self, now_ns: int) -> None:
        retry_ns = self._terms.retry_ns
        overdue = retry_ns and now_ns - self._progress_ns >= retry_ns
        if overdue and self._liveness.is_linked and self._acked < self._sent_to:
            self._sent_to = self._acked
            self._progress_ns = now_ns

    def _bye(self, packet: Bye) -> None:
        if packet.cause == "closed" and self._client_replies is not None:
            self._replies.close(self._client_replies.client)
        self._end(LinkEvent.CUT, lost.closed(as_reason(packet.reason)))

    def _garbage(self, detail: Reason) -> None:
        self.cut(lost.garbage(detail))

    def _end(self, event: LinkEvent, why: lost.LinkLost) -> None:
        self._drop_connection()
        self._liveness.turn(event, why)

    def _drop_connection(self) -> None:
        self._queues.clear()
        self._assembly.clear()
        self._client_replies = None
        self._welcome = None
