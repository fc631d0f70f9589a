import numpy as np
import pytest

from onika.record.even_samples import ElementCourse, even_samples
from onika.words.reason import reason_of

MS = 1_000_000


def course(name, times_ms, values):
    return ElementCourse(name, np.array([round(at * MS) for at in times_ms], np.int64), np.array(values, float))


def test_a_variable_keeps_its_value_until_the_next_one():  # R-X05
    pair = even_samples(course("X", [0, 5], [1, 2]), course("Y", range(2, 11, 2), range(5)), 0, 14 * MS)
    assert pair.step_s == 0.002
    assert pair.reference.tolist() == [1, 1, 2, 2, 2, 2, 2]
    assert pair.measured.tolist() == [0, 1, 2, 3, 4, 4, 4]


def test_what_changes_at_some_instants_only_is_read_at_all():
    times = [k for k in range(0, 400, 2) if k % 14]
    pair = even_samples(course("X", times, times), course("Y", times, times), 0, 400 * MS)
    assert pair.step_s == pytest.approx(0.002)
    assert len(pair.measured) == 200
    assert np.array_equal(pair.measured, pair.reference)


def test_times_that_waver_a_little_belong_to_their_steps():
    waver = np.random.default_rng(3).uniform(-0.2, 0.2, 500)
    times = 2.0 * np.arange(1, 501) + waver
    pair = even_samples(course("X", times, range(500)), course("Y", times, range(500)), 0, 1001 * MS)
    assert pair.step_s == pytest.approx(0.002, rel=1e-3)
    assert np.array_equal(pair.measured, pair.reference)
    assert np.mean(np.diff(pair.measured) == 1.0) > 0.95


def test_a_time_is_cut_out():
    pair = even_samples(course("X", range(100), range(100)), course("Y", range(100), range(100)), 20 * MS, 29 * MS)
    assert pair.reference.tolist() == list(range(20, 30))


def test_how_often_it_is_read_may_be_said():
    pair = even_samples(course("X", [0], [7]), course("Y", [0, 1, 30], [1, 2, 3]), 0, 40 * MS, hertz=100.0)
    assert pair.measured.tolist() == [1, 2, 2, 3, 3]


UNEVEN = np.cumsum(np.random.default_rng(4).exponential(2.0, 300))


@pytest.mark.parametrize(
    ("reference", "measured", "hertz", "key"),
    [
        (course("X", [], []), course("Y", range(9), range(9)), None, "record.response_nothing"),
        (course("X", [0], [1]), course("Y", [], []), None, "record.response_nothing"),
        (course("X", [0], [1]), course("Y", [1], [1]), None, "record.response_short"),
        (course("X", [0], [1]), course("Y", UNEVEN, UNEVEN), None, "record.response_uneven"),
        (course("X", [0], [1]), course("Y", range(9), range(9)), 1e12, "record.response_long"),
    ],
)
def test_of_what_cannot_be_read_evenly_it_is_said_why(reference, measured, hertz, key):  # R-E01
    with pytest.raises(ValueError) as refusal:
        even_samples(reference, measured, 0, 500 * MS, hertz)
    assert reason_of(refusal.value).key == key


def test_a_time_that_ends_before_it_begins_holds_nothing():
    pair = even_samples(course("X", range(9), range(9)), course("Y", range(9), range(9)), 8 * MS, 2 * MS)
    assert len(pair.measured) == 0
