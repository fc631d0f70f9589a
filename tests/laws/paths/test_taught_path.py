"""A taught path and its file."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.laws.paths.taught_path import TaughtPath, path_of_text, path_text

FAST = np.full(2, 1e6)
rows = st.lists(st.tuples(st.floats(-3, 3), st.floats(-3, 3)), min_size=2, max_size=20).map(np.array)


@settings(max_examples=examples(60), deadline=None)
@given(rows)
def test_a_path_passes_every_row_at_its_time_and_begins_and_ends_at_rest(table):
    times = np.cumsum(np.linspace(0.1, 0.3, len(table)))
    path = TaughtPath(times, table, FAST)
    for t, row in zip(times, table, strict=True):
        assert path.at(t - times[0])[0] == pytest.approx(row, abs=1e-9)
    assert path.at(0.0)[1] == pytest.approx([0.0, 0.0])
    assert path.at(path.duration)[1] == pytest.approx([0.0, 0.0], abs=1e-9)


def test_a_straight_ramp_is_gone_along_at_its_speed():
    times = np.linspace(0, 2, 21)
    path = TaughtPath(times, np.outer(times, [1.0, -0.5]), FAST)
    assert path.at(1.05)[0] == pytest.approx([1.05, -0.525])
    assert path.at(1.05)[1] == pytest.approx([1.0, -0.5])


def test_a_path_that_was_taught_too_fast_is_stretched():
    times = np.linspace(0, 1, 11)
    path = TaughtPath(times, np.outer(times, [1.0, 0.0]), np.array([0.25, 1.0]))
    assert path.duration >= 4.0
    speeds = [abs(path.at(t)[1][0]) for t in np.linspace(0, path.duration, 1000)]
    assert max(speeds) == pytest.approx(0.25, rel=0.02)


def test_a_row_beyond_the_range_is_told_with_its_joint():
    path = TaughtPath(np.array([0.0, 1.0]), np.array([[0.0, 0.0], [0.0, 2.0]]), FAST)
    path.check_range([-1, -1], [1, 2])
    with pytest.raises(ValueError, match=r"joint 2 would stand at 2\.000 rad"):
        path.check_range([-1, -1], [1, 1])


@given(rows)
def test_a_path_is_read_as_it_was_written(table):
    times = np.arange(len(table)) * 0.02
    again, read = path_of_text(path_text(times, table), 2)
    assert again == pytest.approx(times)
    assert read == pytest.approx(table, abs=1e-7)


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "expected two rows at least, found 0"),
        ("t,q1,q2\n0,1,2\n", "expected two rows at least, found 1"),
        ("t,q1,q2\n0,1,2\n1,2\n", "line 3: expected a time and 2 joint positions"),
        ("t,q1,q2\n0,1,2\n1,2,x\n", "line 3: expected a time and 2 joint positions"),
        ("t,q1,q2\n0,1,nan\n1,2,3\n", "line 2: expected a time and 2 joint positions"),
        ("t,q1,q2\n0,1,2\n1,2,3\n1,2,3\n", "line 4: expected a time after the one before it"),
    ],
)
def test_a_file_that_is_no_path_is_told_with_its_line(text, sentence):
    with pytest.raises(ValueError, match=sentence):
        path_of_text(text, 2)
