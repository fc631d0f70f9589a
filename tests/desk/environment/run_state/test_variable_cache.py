import numpy as np

from onika.desk.environment.run_state.variable_cache import VariableCache
from onika.record.downsampled import Samples


def samples(count):
    return Samples(np.zeros(count, np.int64), np.zeros((count, 1)))


def test_what_was_wanted_longest_ago_is_forgotten_first():
    kept = VariableCache(most=3 * samples(10).bytes)
    for name in "abc":
        kept.put(name, samples(10))
    assert kept.get("a") is not None
    kept.put("d", samples(10))
    assert [name for name in "abcd" if kept.get(name) is not None] == ["a", "c", "d"]


def test_the_newest_is_kept_however_large_it_is():
    kept = VariableCache(most=1)
    kept.put("a", samples(10))
    assert kept.get("a") is not None
