"""The link with one thing wrong, many times: mistakes for `sim_network` to find."""

from dataclasses import replace
from typing import Any

from kit.link.sim_programs import HONEST, Programs
from onika.link.carrier import Carrier
from onika.link.channel import Channel
from onika.link.client import ClientEnd
from onika.link.link_events import EpochChanged, ReplyReceived, RequestFate, Resumed, SignalReceived
from onika.link.link_terms import LOCAL, LinkTerms
from onika.link.lost import LinkLost
from onika.link.reply_log import ClientReplies, ReplyLog
from onika.link.runtime_port import ServerPort
from onika.link.server import ServerEnd
from onika.link.session import EnvironmentSession
from onika.link.session_channels import SessionChannels
from onika.link.sessions import Introduction, Sessions
from onika.link.signal_journal import SignalJournal
from onika.link.state import LinkEvent, LinkState
from onika.wire.packet import Ack, Hello, ReplyPacket, RequestPacket, SignalPacket, Welcome
from onika.words.reason import Reason


class AcceptsGaps(ClientEnd):
    def _signal(self, packet: SignalPacket) -> None:
        self._accepted = max(self._accepted, packet.seq - 1)
        super()._signal(packet)


class AcceptsSignalsTwice(ClientEnd):
    def _signal(self, packet: SignalPacket) -> None:
        if packet.seq <= self._accepted:
            self._notices.append(SignalReceived(packet.seq, packet.body))
        super()._signal(packet)


class AcknowledgesWhatItSkipped(ClientEnd):
    def _signal(self, packet: SignalPacket) -> None:
        super()._signal(packet)
        self._queues.signal(Ack(packet.seq))


class AsksBeforeTheWelcome(ClientEnd):
    def open(self, now_ns: int) -> None:
        super().open(now_ns)
        for number in list(self._wishes):
            self._send(number, now_ns)


class RepeatsMotionOnANewConnection(ClientEnd):
    def cut(self, why: LinkLost) -> None:
        if self.state not in (LinkState.APART, LinkState.ENDED):
            self._end(LinkEvent.CUT, why)

    def _end(self, event: LinkEvent, why: LinkLost) -> None:
        for wish in self._wishes.values():
            wish.once = False
        super()._end(event, why)


class CarriesRequestsIntoANewEpoch(ClientEnd):
    def _welcome(self, packet: Welcome, now_ns: int) -> None:
        wishes = dict(self._wishes)
        super()._welcome(packet, now_ns)
        if not self._wishes:
            self._wishes = wishes
            for number in list(wishes):
                self._send(number, now_ns)


class OverlooksTheNewEpoch(ClientEnd):
    def _welcome(self, packet: Welcome, now_ns: int) -> None:
        if self.epoch and not packet.resumed:
            self._liveness.greeted(now_ns)
            self._notices.append(Resumed(self.epoch))
            return
        super()._welcome(packet, now_ns)


class LosesRequestsAtACut(ClientEnd):
    def _drop_connection(self) -> None:
        super()._drop_connection()
        self._wishes.clear()


class TellsTheAnswerTwice(ClientEnd):
    def _reply(self, packet: ReplyPacket) -> None:
        is_unwanted = packet.number not in self._wishes and not packet.parts
        if is_unwanted and not packet.late:
            self._notices.append(ReplyReceived(packet.number, packet.body))
        super()._reply(packet)


class SettlesTooEarly(ClientEnd):
    def _send(self, number: int, now_ns: int) -> None:
        wishes, self._wishes = self._wishes, {number: self._wishes[number]}
        super()._send(number, now_ns)
        if number not in self._wishes:
            del wishes[number]
        self._wishes = wishes


class TrustsItsOwnClock(ClientEnd):
    def _welcome(self, packet: Welcome, now_ns: int) -> None:
        super()._welcome(packet, now_ns)
        self._clock_ahead_ns += 10**9


class CallsSentRequestsUnsent(ClientEnd):
    def _fail(self, fate: RequestFate, numbers: list[int]) -> None:
        super()._fail(RequestFate.UNSENT, numbers)


class SpeaksFirst(ServerEnd):
    def open(self, now_ns: int) -> None:
        super().open(now_ns)
        if self._acked < self._sent_to:
            self._queues.signal(SignalPacket(self._sent_to, self._journal.body(self._sent_to)))


class SaysWithoutJournal(ServerEnd):
    def signal(self, body: bytes, now_ns: int) -> int:
        if self._liveness.is_linked:
            return super().signal(body, now_ns)
        return self._journal.last


class BelievesWhatWasSaidWasHeard(ServerEnd):
    def _hello(self, hello: Hello, now_ns: int) -> None:
        sent_to = self._sent_to if hello.epoch == self._journal.epoch else hello.seq
        super()._hello(Hello(hello.version, hello.client, hello.epoch, max(sent_to, hello.seq)), now_ns)


class ForgetsAnswersAtACut(ServerEnd):
    def _drop_connection(self) -> None:
        if self._client_replies is not None:
            self._client_replies.answers.clear()
        super()._drop_connection()


class NeverRepeatsAnAnswer(ServerEnd):
    def _request(self, client_replies: ClientReplies, request: RequestPacket, now_ns: int) -> None:
        if request.number not in client_replies.answers:
            super()._request(client_replies, request, now_ns)


class ForgetsWhatIsUnderWay(ServerEnd):
    def _request(self, client_replies: ClientReplies, request: RequestPacket, now_ns: int) -> None:
        client_replies.under_way.clear()
        super()._request(client_replies, request, now_ns)


class CarriesOutLateRequests(ServerEnd):
    def _request(self, client_replies: ClientReplies, request: RequestPacket, now_ns: int) -> None:
        super()._request(client_replies, request, 0)


class NeverNoticesSilence(ServerEnd):
    def tick(self, now_ns: int) -> None:
        self._liveness.note_arrival(now_ns)
        super().tick(now_ns)


class AlwaysBeginsAnew(ServerEnd):
    def _hello(self, hello: Hello, now_ns: int) -> None:
        super()._hello(Hello(hello.version, hello.client, "", 0), now_ns)


class NeverSaysAgain(ServerEnd):
    def _retry(self, now_ns: int) -> None:
        pass


class ShowsOldReadings(ServerEnd):
    def reading(self, key: str, body: bytes, now_ns: int) -> None:
        super().reading(key, body, now_ns)
        super().reading(key + "old", b"1", now_ns)


# -- planted in a session, or in what keeps the sessions


class SaysSignalsOnEveryChannel(EnvironmentSession):
    def _spoken_on(self, channel: Channel) -> SignalJournal:
        return self._journal


class GivesUpAtACut(EnvironmentSession):
    def is_lost(self, now_ns: int) -> bool:
        return super().is_lost(now_ns + 10**12)


class NeverGivesUp(EnvironmentSession):
    def is_lost(self, now_ns: int) -> bool:
        return False


class GivesUpAgainAndAgain(EnvironmentSession):
    def leave(self) -> bool:
        return self._is_present


class BeginsSignalsWhereTheyAreNow(EnvironmentSession):
    def attach(self, channel: Channel, carrier: Carrier, now_ns: int) -> None:
        super().attach(channel, carrier, now_ns)
        self._followers = ReplyLog()
        if channel is Channel.SIGNAL:
            self._ports[channel]._end._replies = ReplyLog()


class SignalsOnlyToThoseWhoAreThere(EnvironmentSession):
    def signal(self, body: bytes, now_ns: int) -> None:
        if self.ports:
            super().signal(body, now_ns)


class TakesASecondBookForEachConnection(EnvironmentSession):
    def attach(self, channel: Channel, carrier: Carrier, now_ns: int) -> None:
        self._ports.pop(channel, None)
        self._replies = ReplyLog()
        super().attach(channel, carrier, now_ns)

    def _open(self, channel: Channel) -> ServerPort:
        port = ServerPort(self._spoken_on(channel), self._replies, self._terms, channel, self._make)
        self._asking = port if channel.asks else self._asking
        return port


class OneSessionForEachUser(Sessions):
    def admit(self, new: Introduction, carrier: Carrier, now_ns: int) -> Reason:
        earlier = next((session for session in self.sessions if session.caller.user == new.caller.user), None)
        if earlier is not None:
            self._by_client[new.client] = earlier
        return super().admit(new, carrier, now_ns)


class ForgetsASessionAtACut(Sessions):
    def lost(self, now_ns: int) -> list[str]:
        for session in self.sessions:
            if not session.ports:
                self._forget(session)
        return super().lost(now_ns)


class GivesEveryLifeOfASessionTheSameName(Sessions):
    @property
    def _life(self) -> str:
        return self._epoch


class ServesANewProgramUnderAnOldNameAsTheOldOne(Sessions):
    def admit(self, new: Introduction, carrier: Carrier, now_ns: int) -> Reason:
        session = self._by_client.get(new.client)
        epoch = session.epoch if session is not None and session.has_requested else new.epoch
        return super().admit(Introduction(new.channel, new.client, epoch, new.caller), carrier, now_ns)


class LeavesTheOthersInTheOldEpoch(SessionChannels):
    def _lead(self, now_ns: int) -> None:
        for channel_end in self._channel_ends.values():
            if not channel_end.end.epoch:
                channel_end.end.follow(self.epoch)


class DoesNotTryAgain(SessionChannels):
    def failed(self, channel: Channel, now_ns: int) -> None:
        super().failed(channel, now_ns)
        self._channel_ends[channel].is_connecting = True


class TellsOfEveryChannelsBeginning(SessionChannels):
    def _gather(self, now_ns: int) -> None:
        for channel_end in self._channel_ends.values():
            greeted = [notice for notice in channel_end.end._notices if isinstance(notice, Resumed)]
            if channel_end is not self._first and greeted:
                self._notices.append(EpochChanged(channel_end.end.epoch))
        super()._gather(now_ns)


class MixesTheChannels(ClientEnd):
    def _signal(self, packet: SignalPacket) -> None:
        super()._signal(packet)
        self._queues.session((), RequestPacket(1, 1, 0, 0, b"0 "))


class AnswersOnTheChannelOfSignals(ServerEnd):
    def signal(self, body: bytes, now_ns: int) -> int:
        self._queues.session((), ReplyPacket(1, False, 0, b"re: "))
        return super().signal(body, now_ns)


def same_epoch_in_every_life(_life: int) -> str:
    return "epoch"


def sessions_of(kind: type[EnvironmentSession]) -> type[Sessions]:
    class Kept(Sessions):
        def __init__(self, epoch: str, terms: LinkTerms = LOCAL, **options: Any) -> None:
            super().__init__(epoch, terms, **options, session=kind)

    return Kept


CLIENTS: tuple[type[ClientEnd], ...] = (
    AcceptsGaps,
    AcceptsSignalsTwice,
    AcknowledgesWhatItSkipped,
    AsksBeforeTheWelcome,
    RepeatsMotionOnANewConnection,
    CarriesRequestsIntoANewEpoch,
    OverlooksTheNewEpoch,
    LosesRequestsAtACut,
    TellsTheAnswerTwice,
    SettlesTooEarly,
    TrustsItsOwnClock,
    CallsSentRequestsUnsent,
    MixesTheChannels,
)
SERVERS: tuple[type[ServerEnd], ...] = (
    SpeaksFirst,
    SaysWithoutJournal,
    BelievesWhatWasSaidWasHeard,
    ForgetsAnswersAtACut,
    NeverRepeatsAnAnswer,
    ForgetsWhatIsUnderWay,
    CarriesOutLateRequests,
    NeverNoticesSilence,
    AlwaysBeginsAnew,
    NeverSaysAgain,
    ShowsOldReadings,
    AnswersOnTheChannelOfSignals,
)
SESSIONS: tuple[type[EnvironmentSession], ...] = (
    SaysSignalsOnEveryChannel,
    GivesUpAtACut,
    NeverGivesUp,
    GivesUpAgainAndAgain,
    BeginsSignalsWhereTheyAreNow,
    SignalsOnlyToThoseWhoAreThere,
    TakesASecondBookForEachConnection,
)
GUESTS: tuple[type[Sessions], ...] = (
    OneSessionForEachUser,
    ForgetsASessionAtACut,
    GivesEveryLifeOfASessionTheSameName,
    ServesANewProgramUnderAnOldNameAsTheOldOne,
)
BUNDLES: tuple[type[SessionChannels], ...] = (
    LeavesTheOthersInTheOldEpoch,
    DoesNotTryAgain,
    TellsOfEveryChannelsBeginning,
)
MISTAKES: dict[str, Programs] = {
    **{kind.__name__: replace(HONEST, client=kind) for kind in CLIENTS},
    **{kind.__name__: replace(HONEST, server=kind) for kind in SERVERS},
    **{kind.__name__: replace(HONEST, sessions=sessions_of(kind)) for kind in SESSIONS},
    **{kind.__name__: replace(HONEST, sessions=kind) for kind in GUESTS},
    **{kind.__name__: replace(HONEST, session_channels=kind) for kind in BUNDLES},
    "SameEpochInEveryLife": replace(HONEST, epoch=same_epoch_in_every_life),
}
