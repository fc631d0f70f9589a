"""How many subjects a comparison needs, against published tables and simulated studies."""

import numpy as np
import pytest
from scipy import stats

from onika.study.comparison import compare
from onika.study.power import power, subjects_needed


@pytest.mark.parametrize(
    ("f", "groups", "each"), [(0.1, 3, 322), (0.25, 3, 52), (0.4, 3, 21), (0.25, 2, 64), (0.4, 4, 18), (0.25, 4, 45)]
)
def test_the_numbers_are_those_of_cohens_tables(f, groups, each):  # R-H03
    """Cohen (1992), A power primer, table 2, α = 0.05; he rounds down where the power is nearly reached."""
    assert subjects_needed(f, groups) in (each, each + 1)


def test_so_many_studies_find_it():  # R-H03
    """Ten thousand simulated studies, each looked at by the analysis of variance of which the comparison speaks."""
    random, studies, each = np.random.default_rng(5), 10_000, 22
    means = np.array([-1.0, 0.0, 1.0]) * 0.4 * np.sqrt(1.5)  # their deviation is 0.4
    groups = [random.normal(mean, 1.0, (each, studies)) for mean in means]
    share = np.mean(stats.f_oneway(*groups).pvalue < 0.05)
    assert share == pytest.approx(power(0.4, 3, each), abs=0.015)
    first = {str(mean): group[:, 0].tolist() for mean, group in zip(means, groups, strict=True)}
    assert compare(first).variance.p == pytest.approx(stats.f_oneway(*groups).pvalue[0])


def test_a_difference_that_is_hardly_there_needs_more_than_are_counted():  # R-H03
    assert subjects_needed(1e-4, 3) is None
    assert subjects_needed(5.0, 3) == 2
