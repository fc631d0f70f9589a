"""The simulator: an honest link keeps its promises in a thousand storms, and every planted mistake is found."""

from collections.abc import Callable
from dataclasses import dataclass

import pytest

from onika.link.client import ClientEnd
from onika.link.happening import Fate, Replied, Resumed, Signalled
from onika.link.lost import LinkLost
from onika.link.replies import Account
from onika.link.server import ServerEnd
from onika.link.state import LinkEvent
from onika.testing.network import History, MakeClient, MakeEpoch, MakeServer, name_epoch
from onika.wire.packet import Ack, Hello, Reply, Request, Signal, Welcome

HISTORIES = 1000
SEEDS_UNTIL_FOUND = 60


def test_an_honest_link_keeps_every_promise_in_a_thousand_storms():  # R-F01
    reports = [History(seed).run() for seed in range(HISTORIES)]
    assert [(r.seed, r.faults) for r in reports if r.faults] == []
    assert sum(r.signals for r in reports) > 40 * HISTORIES
    assert sum(r.requests for r in reports) > 15 * HISTORIES


def test_the_same_seed_gives_the_same_history_bit_for_bit():
    first = [History(seed).run() for seed in range(20)]
    again = [History(seed).run() for seed in range(20)]
    assert first == again
    assert len({report.digest for report in first}) == 20


# -- planted mistakes, each the link with one thing wrong


class AcceptsGaps(ClientEnd):
    def _signal(self, packet: Signal) -> None:
        self._accepted = max(self._accepted, packet.seq - 1)
        super()._signal(packet)


class AcceptsSignalsTwice(ClientEnd):
    def _signal(self, packet: Signal) -> None:
        if packet.seq <= self._accepted:
            self._happenings.append(Signalled(packet.seq, packet.body))
        super()._signal(packet)


class AcknowledgesWhatItSkipped(ClientEnd):
    def _signal(self, packet: Signal) -> None:
        super()._signal(packet)
        self._lanes.signal(Ack(packet.seq))


class AsksBeforeTheWelcome(ClientEnd):
    def open(self, now_ns: int) -> None:
        super().open(now_ns)
        for number in list(self._wishes):
            self._send(number, now_ns)


class RepeatsMotionOnANewConnection(ClientEnd):
    def cut(self, why: LinkLost) -> None:
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
            for number in wishes:
                self._send(number, now_ns)


class OverlooksTheNewEpoch(ClientEnd):
    def _welcome(self, packet: Welcome, now_ns: int) -> None:
        if self.epoch and not packet.resumed:
            self._pulse.greeted(now_ns)
            self._happenings.append(Resumed(self.epoch))
            return
        super()._welcome(packet, now_ns)


class LosesRequestsAtACut(ClientEnd):
    def _drop_connection(self) -> None:
        super()._drop_connection()
        self._wishes.clear()


class TellsTheAnswerTwice(ClientEnd):
    def _reply(self, packet: Reply) -> None:
        known = packet.number not in self._wishes and not packet.parts
        if known and not packet.late:
            self._happenings.append(Replied(packet.number, packet.body))
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
    def _fail(self, fate: Fate, numbers: list[int]) -> None:
        super()._fail(Fate.UNSENT, numbers)


class SpeaksFirst(ServerEnd):
    def open(self, now_ns: int) -> None:
        super().open(now_ns)
        if self._acked < self._said:
            self._lanes.signal(Signal(self._said, self._journal.body(self._said)))


class SaysWithoutJournal(ServerEnd):
    def signal(self, body: bytes, now_ns: int) -> int:
        if self._pulse.is_linked:
            return super().signal(body, now_ns)
        return self._journal.last


class BelievesWhatWasSaidWasHeard(ServerEnd):
    def _hello(self, hello: Hello, now_ns: int) -> None:
        said = self._said if hello.epoch == self._journal.epoch else hello.seq
        super()._hello(Hello(hello.version, hello.client, hello.epoch, max(said, hello.seq)), now_ns)


class ForgetsAnswersAtACut(ServerEnd):
    def _drop_connection(self) -> None:
        if self._account is not None:
            self._account.answers.clear()
        super()._drop_connection()


class NeverRepeatsAnAnswer(ServerEnd):
    def _request(self, account: Account, request: Request, now_ns: int) -> None:
        if request.number not in account.answers:
            super()._request(account, request, now_ns)


class ForgetsWhatIsUnderWay(ServerEnd):
    def _request(self, account: Account, request: Request, now_ns: int) -> None:
        account.under_way.clear()
        super()._request(account, request, now_ns)


class CarriesOutLateRequests(ServerEnd):
    def _request(self, account: Account, request: Request, now_ns: int) -> None:
        super()._request(account, request, 0)


class NeverNoticesSilence(ServerEnd):
    def tick(self, now_ns: int) -> None:
        self._pulse.heard(now_ns)
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


@dataclass(frozen=True)
class Mistake:
    client: MakeClient = ClientEnd
    server: MakeServer = ServerEnd
    epoch: MakeEpoch = name_epoch


def same_epoch_in_every_life(_life: int) -> str:
    return "epoch"


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
)
MISTAKES: dict[str, Mistake] = {
    **{kind.__name__: Mistake(client=kind) for kind in CLIENTS},
    **{kind.__name__: Mistake(server=kind) for kind in SERVERS},
    "SameEpochInEveryLife": Mistake(epoch=same_epoch_in_every_life),
}


def first_fault(run: Callable[[int], tuple[str, ...]]) -> tuple[int, str] | None:
    return next(((seed, faults[0]) for seed in range(SEEDS_UNTIL_FOUND) if (faults := run(seed))), None)


@pytest.mark.parametrize("name", MISTAKES)
def test_a_planted_mistake_is_found(name: str):  # R-F01
    planted = MISTAKES[name]
    found = first_fault(lambda seed: History(seed, planted.client, planted.server, planted.epoch).run().faults)
    assert found is not None, f"{name} was not found in {SEEDS_UNTIL_FOUND} histories"
