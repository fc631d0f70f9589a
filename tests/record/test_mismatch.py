import math

import pytest
from hypothesis import HealthCheck, given, settings, strategies as st

from kit.examples import examples
from kit.record.recording_builder import RecordingBuilder
from onika.record.mismatch import mismatches
from onika.record.series import Series
from onika.record.tolerance import Tolerance

NS = 1_000_000_000
COURSES = st.dictionaries(
    st.integers(0, 30), st.sampled_from([0.0, 1.0, 1.5, 4.0, math.nan, math.inf]), min_size=1, max_size=12
)

ROOMS = st.sampled_from([0.0, 0.6, 9.0])


def series(path, type_, course):
    tape = RecordingBuilder(path)
    tape.variable("X", type_, *course)
    return Series.all_of(tape.end())["flow0/X"]


def plainly(ours, other, tolerance, begin, end):
    """The same, value for value."""
    slack = round(tolerance.seconds * 1e9)
    for at, value in ours:
        if begin <= at < end:
            before = [v for t, v in other if t <= at - slack][-1:]
            near = before + [v for t, v in other if at - slack < t <= at + slack]
            numbers = [v for v in near if not math.isnan(v)]
            low, high = (min(numbers), max(numbers)) if numbers else (math.nan, math.nan)
            is_like = any(map(math.isnan, near)) if math.isnan(value) else tolerance.covers(value, low, high)
            if not near or not is_like:
                return at
    return None


@given(ours=COURSES, other=COURSES, room=ROOMS, seconds=st.integers(0, 6), at=st.integers(0, 9))
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture], max_examples=examples(40), deadline=None)
def test_the_first_value_that_is_far_is_found_as_it_is_by_hand(tmp_path, ours, other, room, seconds, at):  # R-X05
    courses = [sorted((float(k), value) for k, value in each.items()) for each in (ours, other)]
    both = [series(tmp_path / f"{n}.mcap", "double", each) for n, each in enumerate(courses)]
    tolerance, begin, end = Tolerance(room, 0.0, float(seconds)), at * NS, (at + 15) * NS
    pair = mismatches(*both, tolerance, begin, end)
    plain = [[(round(k * NS), value) for k, value in each] for each in courses]
    assert [None if each is None else each.at_ns for each in pair] == [
        plainly(plain[0], plain[1], tolerance, begin, end),
        plainly(plain[1], plain[0], tolerance, begin, end),
    ]


@pytest.mark.parametrize(
    ("type_", "ours", "other", "value", "near"),
    [("int", 1, 2, 1, 2), ("double", 1, 2, 1.0, 2.0), ("char", 65, 66, "A", "B")],
)
def test_values_are_told_as_what_they_are(tmp_path, type_, ours, other, value, near):
    both = [series(tmp_path / f"{n}.mcap", type_, [(1.0, each)]) for n, each in enumerate((ours, other))]
    mine, its = mismatches(*both, Tolerance(), 0, 2 * NS)
    assert (mine.at_ns, mine.place, mine.value, mine.near) == (NS, 0, value, near)
    assert (type(mine.value), its.value) == (type(value), near)


def test_before_its_first_value_the_other_one_has_nothing(tmp_path):
    both = [series(tmp_path / f"{n}.mcap", "int", [(float(n), 1)]) for n in (0, 1)]
    mine, its = mismatches(*both, Tolerance(), 0, 2 * NS)
    assert (mine.near, its) == (None, None)


def test_words_are_compared_too(tmp_path):
    first = series(tmp_path / "a.mcap", "char", [(0.0, 65), (1.0, 66), (2.0, 67)])
    other = series(tmp_path / "b.mcap", "char", [(0.0, 65), (1.25, 66), (2.0, 67)])
    assert mismatches(first, other, Tolerance(), 0, 9 * NS)[0].at_ns == NS
    assert mismatches(first, other, Tolerance(seconds=0.25), 0, 9 * NS) == (None, None)
    assert mismatches(first, other, Tolerance(), 2 * NS, 9 * NS) == (None, None)


def test_of_several_values_in_one_instant_each_is_like_itself(tmp_path):  # R-X05
    both = [(0.0, 1.0), (0.0, 2.0), (1.0, 3.0)]
    ours, other = series(tmp_path / "a", "double", both), series(tmp_path / "b", "double", [*both, (2.0, 4.0)])
    pair = mismatches(ours, other, Tolerance(), 0, 3 * NS)
    assert [each and (each.at_ns, each.value) for each in pair] == [None, (2 * NS, 4.0)]
    words = [(0.0, b"left"), (0.0, b"right"), (1.0, b"up")]
    ours, other = series(tmp_path / "a", "string", words), series(tmp_path / "b", "string", [*words, (2.0, b"down")])
    assert [each and each.at_ns for each in mismatches(ours, other, Tolerance(), 0, 3 * NS)] == [None, 2 * NS]
