import weakref

import pytest

from onika.host.units.garbage import MOST, Garbage


def gone():
    """A class that nobody refers to but itself."""
    kind = type("Gone", (), {})
    kind.itself = kind
    return weakref.ref(kind)


def test_nothing_is_collected_before_something_has_ended():
    assert not Garbage().collect(None)


def test_what_has_ended_is_collected_where_nothing_is_due():
    garbage, kind = Garbage(), gone()
    garbage.note()
    assert garbage.collect(None)
    assert kind() is None
    assert not garbage.collect(None)


@pytest.mark.parametrize("gap_ns", [-1, 0, 1000])
def test_between_two_cycles_that_follow_closely_it_waits(gap_ns):  # law 21
    garbage = Garbage()
    garbage.note()
    assert not garbage.collect(gap_ns)
    assert garbage.collect(60_000_000_000)


def test_too_much_does_not_wait_for_ever():
    garbage = Garbage()
    for _ in range(MOST - 1):
        garbage.note()
    assert not garbage.collect(0)
    garbage.note()
    assert garbage.collect(0)
