"""The simulator: honest programs keep their promises in two thousand storms, and every planted mistake is found."""

from collections.abc import Callable

import pytest

from kit.link.link_mistakes import MISTAKES
from kit.link.sim_network import NetworkHistory

HISTORIES = 50
SEEDS_UNTIL_FOUND = 120


def test_honest_programs_keep_every_promise_in_fifty_storms():  # R-F01
    reports = [NetworkHistory(seed).run() for seed in range(HISTORIES)]
    assert [(r.seed, r.faults) for r in reports if r.faults] == []
    assert sum(r.signals for r in reports) > 40 * HISTORIES
    assert sum(r.requests for r in reports) > 15 * HISTORIES


@pytest.mark.slow
def test_honest_programs_keep_every_promise_in_ten_thousand_more_storms():  # R-F01
    faults = [
        (r.seed, r.faults) for seed in range(HISTORIES, HISTORIES + 10_000) if (r := NetworkHistory(seed).run()).faults
    ]
    assert faults == []


def test_the_same_seed_gives_the_same_history_bit_for_bit():
    first = [NetworkHistory(seed).run() for seed in range(20)]
    again = [NetworkHistory(seed).run() for seed in range(20)]
    assert first == again
    assert len({report.digest for report in first}) == 20


def first_fault(run: Callable[[int], tuple[str, ...]]) -> tuple[int, str] | None:
    return next(((seed, faults[0]) for seed in range(SEEDS_UNTIL_FOUND) if (faults := run(seed))), None)


@pytest.mark.parametrize("name", MISTAKES)
def test_a_planted_mistake_is_found(name: str):  # R-F01
    failure = first_fault(lambda seed: NetworkHistory(seed, MISTAKES[name]).run().faults)
    assert failure is not None, f"{name} was not found in {SEEDS_UNTIL_FOUND} histories"
