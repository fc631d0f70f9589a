import pytest

from kit.engine.rendezvous_oracle import RendezvousOracle
from onika.engine.rendezvous_terms import LATE_NS, RendezvousTerms
from onika.runtime.execution.appointments import SHARED_LATE_NS

MS = 1_000_000
TERMS = RendezvousTerms(MS, MS)


@pytest.fixture
def oracle():
    oracle = RendezvousOracle(range(2), TERMS)
    oracle.comes(0, 1)
    return oracle


def test_who_begins_before_all_are_there_is_complained_of(oracle):
    oracle.begins_at(0, 1, 1, 0)
    assert oracle.faults == ["R1: 0 begins visit 1, [1] are not there"]


@pytest.mark.parametrize(("apart_ns", "count"), [(2 * MS + SHARED_LATE_NS, 0), (2 * MS + SHARED_LATE_NS + 1, 1)])
def test_who_begin_together_begin_within_the_error_of_their_clocks(oracle, apart_ns, count):
    oracle.comes(1, 1)
    oracle.begins_at(0, 1, 1, 0)
    oracle.begins_at(1, 1, 1, apart_ns)
    oracle.goes_on(0, 1)
    oracle.final(10**9, [])
    assert (len(oracle.faults), oracle.met, oracle.alone) == (count, 1, 0)


@pytest.mark.parametrize(("held_ns", "count"), [(TERMS.alone_ns + 2 * LATE_NS, 0), (TERMS.alone_ns + 11 * MS, 1)])
def test_who_begins_alone_is_held_in_time(oracle, held_ns, count):
    oracle.comes(1, 1)
    oracle.begins_at(0, 1, 1, 0)
    oracle.holds(0, held_ns)
    oracle.final(10**9, [])
    assert (len(oracle.faults), oracle.alone, oracle.longest_alone_ns) == (count, 1, held_ns)


def test_nobody_goes_on_behind_what_another_has_not_begun(oracle):
    oracle.comes(1, 1)
    oracle.begins_at(0, 1, 1, 0)
    oracle.goes_on(0, 1)
    assert oracle.faults == ["R4: 0 goes on behind visit 1, [1] have not begun"]


def test_whom_a_user_let_pass_has_been_there_and_who_does_not_come_to_his_end_is_named(oracle):
    oracle.passes(1, 1)
    oracle.begins_at(0, 1, 1, 0)
    oracle.goes_on(0, 1)
    oracle.final(10**9, [1])
    assert oracle.faults == ["R5: 1 has not come to its end"]


def test_who_has_crashed_is_held(oracle):
    oracle.comes(1, 1)
    oracle.begins_at(0, 1, 1, 0)
    oracle.crashes(0, 5 * MS)
    oracle.final(10**9, [])
    assert (oracle.faults, oracle.longest_alone_ns) == ([], 5 * MS)


def test_who_was_held_and_begins_uncleared_is_complained_of(oracle):
    oracle.comes(1, 1)
    oracle.is_alone(0)
    oracle.clears(0)
    oracle.begins_at(0, 1, 1, 0)
    assert oracle.faults == []
    oracle.is_alone(0)
    oracle.begins_at(0, 1, 2, 0)
    assert oracle.faults == ["R3: 0 begins visit 1 and was not cleared"]
