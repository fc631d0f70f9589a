"""Two runtimes' ends of a rendezvous, with real datagrams on this machine; time is handed in."""

import select
import socket

import pytest

from onika.engine.rendezvous_exchange import RendezvousExchange
from onika.engine.rendezvous_orders import AllMet, Appoint, Confirm, Permit
from onika.engine.rendezvous_terms import EVERY_NS, RendezvousTerms
from onika.link.datagrams.pact import Pact
from onika.link.datagrams.rendezvous_channel import Correspondent, RendezvousChannel, RendezvousSocket

MS = 1_000_000
TERMS = RendezvousTerms(MS, MS)
RUN, EPOCHS = bytes(16), {0: 70, 1: 71}
NOW = 10**9


@pytest.fixture
def channels():
    """The channels of runtimes 0 and 1."""
    sockets = [RendezvousSocket(), RendezvousSocket()]
    addresses = [Correspondent("127.0.0.1", here.port, here.pact) for here in sockets]
    made = []
    for site, here in enumerate(sockets):
        exchange = RendezvousExchange(RUN, site, EPOCHS, [(0, 1)], TERMS)
        made.append(RendezvousChannel(here, exchange, {1 - site: addresses[1 - site]}))
    yield made
    for channel in made:
        channel.close()


def pass_on(channels, now_ns):
    """All say what they have to say, and hear it; what each is ordered to do."""
    for channel in channels:
        channel.speak(now_ns)
    orders = []
    for channel in channels:
        select.select([channel], [], [], 1)
        orders.append([order for _, order in channel.receive(now_ns)])
    return orders


def test_two_runtimes_meet_by_datagrams(channels):  # R-E04, R-F02
    meetings = [channel.exchange.meetings[0] for channel in channels]
    for meeting in meetings:
        meeting.come(NOW)
    assert pass_on(channels, NOW) == [[Appoint(1, NOW + TERMS.lead_ns)], []]
    assert pass_on(channels, NOW + EVERY_NS)[1] == [Appoint(1, NOW + TERMS.lead_ns)]
    commit_ns = NOW + TERMS.lead_ns - TERMS.commit_ns
    assert channels[0].due_ns() <= commit_ns
    pass_on(channels, commit_ns - 1)
    assert [channel.look(commit_ns) for channel in channels] == [[], []]
    assert pass_on(channels, commit_ns) == [[Permit(1)], [Permit(1)]]
    begin_ns = NOW + TERMS.lead_ns
    for meeting in meetings:
        meeting.begun(1, begin_ns)
    assert pass_on(channels, begin_ns) == [[Confirm(1), AllMet()], [Confirm(1), AllMet()]]


def test_it_speaks_every_20_ms_and_at_each_change(channels):
    first, second = channels
    first.speak(NOW)
    first.speak(NOW + EVERY_NS - 1)
    assert first.due_ns() == NOW + EVERY_NS
    first.exchange.meetings[0].come(NOW)
    first.speak(NOW + EVERY_NS - 1)
    first.speak(NOW + 2 * EVERY_NS - 1)
    select.select([second], [], [], 1)
    second.receive(NOW)
    assert second._here.socket.fileno() == second.fileno()
    assert first._counts == {1: 3}


def test_what_a_stranger_says_does_not_count(channels):  # R-X12
    first, second = channels
    second.exchange.meetings[0].come(NOW)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        for pact in (Pact.drawn(), Pact(first._here.pact.name, bytes(32))):
            stranger.sendto(pact.seal(1, b"anything"), ("127.0.0.1", first._here.port))
        stranger.sendto(first._here.pact.seal(1, b"no report"), ("127.0.0.1", first._here.port))
    select.select([first], [], [], 1)
    assert first.receive(NOW) == []
    assert first.exchange.silent_ns(1, NOW) is None


def test_who_is_gone_harms_nobody(channels):
    first, second = channels
    second.close()
    for number in range(3):
        first.speak(NOW + number * EVERY_NS)
        assert first.receive(NOW) == []
