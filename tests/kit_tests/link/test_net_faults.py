from random import Random

import pytest

from kit.link.event_scheduler import EventScheduler
from kit.link.net_faults import FaultyNet, NetFaults


def test_half_of_all_weather_is_reliable_and_the_rest_loses_at_most_three_in_ten():
    drawn = [NetFaults.draw(Random(seed)) for seed in range(400)]
    assert 140 < sum(faults.is_reliable for faults in drawn) < 260
    assert max(faults.loss for faults in drawn) <= 0.3
    assert {faults.delay_ns for faults in drawn} == {1_000_000, 20_000_000, 80_000_000}


def test_the_same_seed_draws_the_same_weather():
    assert NetFaults.draw(Random(3)) == NetFaults.draw(Random(3))


class Plug:
    free_ns = 0


@pytest.mark.parametrize("is_reliable", [True, False])
def test_a_reliable_network_brings_all_in_order_and_another_only_when_it_is_calm(is_reliable):
    time = EventScheduler(1)
    sky, plug, came = FaultyNet(NetFaults(is_reliable, 0.3, 0.2, 0.3, 1_000_000), time), Plug(), []
    for number in range(200):
        sky.carry(plug, 0, lambda number=number: came.append(number))
    while time.step(10**12):
        pass
    assert (came == list(range(200))) is is_reliable
    sky.is_calm = True
    came.clear()
    for number in range(200):
        sky.carry(plug, 0, lambda number=number: came.append(number))
    while time.step(10**13):
        pass
    assert sorted(came) == list(range(200))


@pytest.mark.parametrize(("is_reliable", "arrivals"), [(True, [5_000_000]), (False, [])])
def test_over_a_blind_line_nothing_comes_unless_it_waits(is_reliable, arrivals):
    time, came = EventScheduler(1), []
    FaultyNet(NetFaults(is_reliable, 0, 0, 0, 1_000_000), time).carry(
        Plug(), 5_000_000, lambda: came.append(time.now_ns)
    )
    while time.step(10**12):
        pass
    assert came == arrivals
