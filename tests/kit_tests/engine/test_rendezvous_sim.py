"""Flows of several runtimes meet under every fault: the real protocol keeps its promises in ten thousand histories."""

import pytest

from kit.engine.rendezvous_sim import MS, RendezvousHistory

WAYS = [(2, MS // 2), (2, 100 * MS), (3, 100 * MS), (4, MS // 2)]
"""Runtimes, and ns one way."""


@pytest.mark.parametrize(("sites", "one_way_ns"), WAYS)
def test_every_promise_is_kept_in_some_histories(sites, one_way_ns):  # R-F02
    oracles = [RendezvousHistory(seed, one_way_ns, sites).run() for seed in range(90 // (sites - 1) ** 2)]
    assert [(seed, oracle.faults) for seed, oracle in enumerate(oracles) if oracle.faults] == []
    assert sum(oracle.met for oracle in oracles) > 3 * len(oracles)


@pytest.mark.slow
@pytest.mark.parametrize(("sites", "one_way_ns"), WAYS)
def test_every_promise_is_kept_in_ten_thousand_histories(sites, one_way_ns):  # R-F02
    faults, alone, longest_ns = [], 0, 0
    for seed in range(10_000 if sites == 2 else 2_000):
        oracle = RendezvousHistory(seed, one_way_ns, sites).run()
        faults += [(seed, fault) for fault in oracle.faults]
        alone += oracle.alone
        longest_ns = max(longest_ns, oracle.longest_alone_ns)
    assert faults == []
    assert alone > 20
    assert longest_ns <= RendezvousHistory(0, one_way_ns, sites).terms.alone_ns + 2 * MS


def test_the_same_seed_gives_the_same_history():
    first, again = (RendezvousHistory(7, 100 * MS).run() for _ in range(2))
    assert first.begins == again.begins
    assert first.begins != RendezvousHistory(8, 100 * MS).run().begins
