import math

import numpy as np
import pytest

from kit.record.recording_builder import RecordingBuilder
from onika.record.downsampled import Samples, is_drawn, parts, samples
from onika.record.series import Series

NS = 1_000_000_000


@pytest.fixture
def series(tmp_path):
    tape = RecordingBuilder(tmp_path / "run.mcap")
    tape.variable("X", "double[2]", *((k / 10, [k, -k]) for k in range(100)))
    tape.variable("N", "int", (0.0, 3), (4.0, 5))
    tape.variable("ODD", "double", (0.0, math.inf), (1.0, math.nan), (2.0, -math.inf), (3.0, 1.0))
    tape.variable("PICTURE", "byte[100]", (0.0, [0] * 100))
    tape.variable("NOTHING", "double")
    return Series.all_of(tape.end())


def test_all_values_are_read_at_once(series):  # R-X05
    column = samples(series["flow0/X"])
    assert column.at_ns.tolist() == [at for at, _ in series["flow0/X"].values()]
    assert column.values.tolist() == [at for _, at in series["flow0/X"].values()]
    assert samples(series["flow0/N"]).values.tolist() == [[3.0], [5.0]]


def test_a_stretch_begins_with_the_value_that_was_there(series):
    assert samples(series["flow0/X"], NS + 1, 2 * NS).at_ns.tolist() == [k * NS // 10 for k in range(10, 21)]
    assert samples(series["flow0/N"], NS, 2 * NS).values.tolist() == [[3.0]]
    assert samples(series["flow0/N"]).between(NS, 2 * NS).values.tolist() == [[3.0]]


def test_what_no_double_is_is_read_as_it_was(series):
    np.testing.assert_equal(samples(series["flow0/ODD"]).values.ravel(), [math.inf, math.nan, -math.inf, 1.0])


def test_parts_tell_the_least_and_the_greatest(series):  # R-X05: no peak is lost
    blocks = parts(samples(series["flow0/X"]), 0, 10 * NS, 5)
    assert blocks.at_s.tolist() == [0, 2, 4, 6, 8]
    assert blocks.least[:, 0].tolist() == [0, 20, 40, 60, 80]
    assert blocks.most[:, 0].tolist() == [19, 39, 59, 79, 99]
    assert blocks.most[:, 1].tolist() == [0, -20, -40, -60, -80]


def test_a_part_in_which_nothing_came_is_left_out(series):
    assert parts(samples(series["flow0/N"]), 0, 8 * NS, 8).at_s.tolist() == [0.0, 4.0]
    assert parts(samples(series["flow0/NOTHING"]), 0, 8 * NS, 8).at_s.tolist() == []


def test_no_number_hides_no_other():
    some = Samples(np.array([0, 1]), np.array([[math.nan], [2.0]]))
    assert parts(some, 0, 2, 1).least.tolist() == [[2.0]]


def test_words_and_pictures_are_not_drawn(series):
    assert [name for name, variable in series.items() if not is_drawn(variable)] == ["flow0/PICTURE"]
