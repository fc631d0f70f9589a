import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.link.signal_journal import SignalJournal


@settings(max_examples=examples(60), deadline=None)
@given(st.lists(st.binary(max_size=9), max_size=40))
def test_signals_are_numbered_from_one_without_gaps_and_kept_within_bounds(bodies):  # R-F01
    journal = SignalJournal("epoch", keep=10, keep_bytes=40)
    assert [journal.append(body) for body in bodies] == list(range(1, len(bodies) + 1))
    kept = [seq for seq in range(1, len(bodies) + 1) if journal.reaches_back_to(seq - 1)]
    assert [journal.body(seq) for seq in kept] == bodies[len(bodies) - len(kept) :]
    assert len(kept) <= 10
    assert sum(len(journal.body(seq)) for seq in kept) <= 40
    assert not bodies or kept


def test_a_number_that_was_never_given_is_not_reached():
    journal = SignalJournal("epoch")
    journal.append(b"one")
    assert [seq for seq in range(4) if journal.reaches_back_to(seq)] == [0, 1]


def test_the_newest_signal_is_kept_however_long_it_is():
    journal = SignalJournal("epoch", keep_bytes=4)
    journal.append(b"short")
    journal.append(b"a long one")
    assert journal.body(2) == b"a long one"
    with pytest.raises(KeyError):
        journal.body(1)


def test_an_epoch_has_a_name():
    with pytest.raises(ValueError, match="expected an epoch"):
        SignalJournal("")
