import pytest

from kit.engine.rendezvous_mistakes import MISTAKES
from kit.engine.rendezvous_sim import MS, RendezvousHistory

SEEDS_UNTIL_FOUND = 120


@pytest.mark.parametrize("name", MISTAKES)
def test_a_planted_mistake_is_found(name):  # R-F02
    histories = (RendezvousHistory(seed, 100 * MS, 2, MISTAKES[name]) for seed in range(SEEDS_UNTIL_FOUND))
    assert any(history.run().faults for history in histories), f"{name} was not found"
