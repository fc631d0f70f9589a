from kit.engine.rendezvous_net import MS, STORM_NS, RendezvousNet, SimClock
from kit.link.event_scheduler import EventScheduler


def arrivals(seed, begin_ns):
    """When datagrams arrive that are sent every 10 ms from that time on."""
    time = EventScheduler(seed)
    net, came = RendezvousNet(time, 20 * MS), []
    for number in range(500):
        time.at(begin_ns + number * 10 * MS, lambda: net.send(0, 1, lambda: came.append(time.now_ns)))
    while time.step(2 * STORM_NS):
        pass
    return came


def test_in_the_storm_datagrams_get_lost_and_in_the_calm_none_does():
    assert min(len(arrivals(seed, 0)) for seed in range(6)) < 450
    assert {len(arrivals(seed, STORM_NS)) for seed in range(6)} == {500}


def test_a_clock_that_drifts_shows_what_it_was_waited_for():
    time = EventScheduler(3)
    clock, shown = SimClock(time), []
    clock.at(clock.now_ns + 10**9, lambda: shown.append(clock.now_ns))
    target = clock.now_ns + 10**9
    while time.step(STORM_NS):
        pass
    assert 0 <= shown[0] - target < 21_000  # twenty millionths of a second at most
