import numpy as np
from hypothesis import given, strategies as st

from onika.desk.environment.shared.blocks import Blocks
from onika.desk.environment.shared.grid import grid
from onika.desk.environment.shared.variables import apart, extremes, samples_of, variables
from onika.record.downsampled import Samples

NUMBER = st.floats(-1e3, 1e3, width=32) | st.just(float("nan"))


@given(
    st.lists(st.tuples(st.integers(0, 50), NUMBER), min_size=1, max_size=30), st.lists(st.integers(0, 60), min_size=1)
)
def test_no_peak_between_two_instants_is_lost(told, moments):  # R-X21: plots
    told = sorted(dict(told).items())
    samples = Samples(np.array([at for at, _ in told]), np.array([[value] for _, value in told]))
    instants = np.unique([at for at in moments if at >= told[0][0]] + [told[0][0]])
    least, most = extremes(samples, instants)
    for k, at in enumerate(instants.tolist()):
        until = instants[k + 1] if k + 1 < len(instants) else at
        held = [value for moment, value in told if moment <= at][-1]
        seen = [held, *(value for moment, value in told if at < moment <= until)]
        numbers = [value for value in seen if value == value]
        expected = (min(numbers), max(numbers)) if numbers else (float("nan"), float("nan"))
        np.testing.assert_array_equal((least[k, 0], most[k, 0]), expected)


def test_only_where_a_peak_is_not_expected_something_is_written():  # R-X21: at most 5 MB
    assert not np.any(apart(np.array([[1.0], [np.nan]]), np.array([[1.0], [np.nan]])).view(np.uint32))
    assert np.any(apart(np.array([[2.0]]), np.array([[1.0]])).view(np.uint32))


def test_words_are_told_when_they_change_and_pictures_are_left_out(watched):
    subject = watched.subject
    samples = samples_of(subject)
    assert [*samples] == ["flow0/A"]
    held = variables(subject, samples, grid(subject.view, 0.5), Blocks())
    assert held["flow0/WORD"] == {"changes": [(0, "on")]}
    assert held["flow0/A"]["dims"] == []
