"""The counter of loops."""

from hypothesis import given, settings, strategies as st

from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

CODE = shipped() / "generic" / "module" / "repeat.py"


def repeat():
    return Bench(CODE, frequency=250).init()


def once(bench, count):
    """Its job, done once: whether the loop goes on."""
    bench.on(str(count)).cycle()
    assert bench.state is State.OFF
    assert bench.finished.flow == 0
    return bench.finished.loop


def test_a_loop_goes_on_until_the_count_is_reached_and_then_begins_anew():  # R-E05, R-D13
    bench = repeat()
    assert [once(bench, 3) for _ in range(7)] == [True, True, False, True, True, False, True]


@settings(max_examples=20, deadline=None)
@given(st.integers(1, 6), st.integers(1, 6))
def test_loops_within_each_other_count_apart_where_their_numbers_differ(outer, inner):  # R-E05
    bench, rounds, within = repeat(), 1, 0
    while True:
        within += 1
        if once(bench, inner + 10):
            continue
        if not once(bench, outer):
            break
        rounds += 1
    assert (rounds, within) == (outer, outer * (inner + 10))


def test_how_far_it_is_can_be_asked_and_told():  # R-A14
    bench = repeat()
    once(bench, 3)
    once(bench, 3)
    assert bench.get("done") == 2
    bench.set("done", "0")
    assert [once(bench, 3) for _ in range(3)] == [True, True, False]


def test_a_number_that_is_none_asks_again():
    for count in ("0", "2.5", "three"):
        assert repeat().on(count).state is State.ASKING
