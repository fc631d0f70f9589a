"""How fast a push is meant."""

import numpy as np
import pytest
from hypothesis import given, strategies as st

from onika.laws.signals.push import strength

AXES = st.tuples(*[st.floats(-1, 1)] * 3)


@given(AXES, st.floats(0, 0.9), st.floats(0, 1))
def test_it_leads_where_the_push_does_and_never_further_than_all(push, zone, curve):  # R-K07
    meant = strength(push, zone, curve)
    assert np.linalg.norm(meant) <= 1.0 + 1e-9
    assert np.cross(meant, push) == pytest.approx(np.zeros(3), abs=1e-9)
    assert meant @ np.array(push) >= 0.0


def test_near_the_middle_it_means_nothing_and_at_the_end_all():  # R-K07
    assert strength([0.1, 0, 0], 0.1, 0.5).tolist() == [0, 0, 0]
    assert strength([0, -1, 0], 0.1, 0.5) == pytest.approx([0, -1, 0])
    assert strength([0.55, 0, 0], 0.1, 1.0) == pytest.approx([0.125, 0, 0])
    assert strength([0.55, 0, 0], 0.1, 0.0) == pytest.approx([0.5, 0, 0])


def test_what_is_no_number_is_let_go():
    assert strength([float("nan"), float("inf"), 1.0], 0.0, 0.0) == pytest.approx([0, 0, 1])
    assert strength([0, 0, 0], 0.0, 0.0).tolist() == [0, 0, 0]
