"""A motion at a share of its speed."""

import numpy as np
import pytest

from onika.store.shipped import shipped
from onika.testing.bench import Bench

MODULE = shipped() / "motions" / "module" / "override.py"


def bench_of(**local):
    bench = Bench(MODULE, frequency=100, constants={"NDOF": 2}, local=local).init()
    bench["Y"] = [0.0, 0.0]
    return bench.on()


def fed(bench, steps, per_step=0.01):
    """What comes out while a reference goes on evenly."""
    rows = []
    for _ in range(steps):
        bench["Y"] = bench["Y"] + per_step
        rows.append(float(bench.cycle()["Z"][0]))
    return rows


def test_it_passes_on_what_comes_and_is_told_to_be_slower_or_to_rest():  # R-K05
    bench = bench_of(EASE=1000)
    assert fed(bench, 10)[-1] == pytest.approx(0.1)
    assert bench["Z^"][0] == pytest.approx(1.0)
    bench.set("share", "0.5")
    assert fed(bench, 10)[-1] == pytest.approx(0.15)
    bench.set("share", "0")
    assert np.ptp(fed(bench, 10)) == pytest.approx(0.0, abs=1e-12)
    assert bench.get("behind") == pytest.approx(0.15, abs=0.02)
    bench.set("share", "1")
    assert fed(bench, 40, 0.0)[-1] == pytest.approx(bench["Y"][0])
    assert bench.get("share") == 1.0


@pytest.mark.parametrize("value", ["1.5", "-0.1", "nan"])
def test_a_share_that_is_none_is_refused(value):
    with pytest.raises(RuntimeError, match="share of 0 to 1"):
        bench_of().set("share", value)
