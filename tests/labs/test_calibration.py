"""The check of the angles that an arm measures."""

import numpy as np
import pytest

from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

CODE = shipped() / "generic" / "module" / "calibration.py"
KNOWN = np.array([0.1, -0.5, 1.0])
ARM = {"NDOF": 3, "QMIN": np.full(3, -3.0), "QMAX": np.full(3, 3.0)}
LINE = "0.1 -0.5 1.0 2.0"


def looked(off, **local):
    """After a look at an arm whose second joint is off by so much."""
    bench = Bench(CODE, constants=ARM, local=local).init()
    bench["Q_MEZ"] = KNOWN + np.array([0.0, off, 0.0])
    bench.on(LINE)
    while bench.state is State.ON and bench.cycles < 1000:
        bench.cycle()
    return bench


@pytest.mark.parametrize("off", [0.0, 0.009, -0.009])
def test_an_arm_that_measures_what_it_should_is_well_after_the_look(off):  # R-A16
    bench = looked(off)
    assert (bench.finished.flow, bench.finished.loop, bench.cycles) == (0, False, 200)
    np.testing.assert_allclose(bench["Q_OFF"], [0.0, off, 0.0], atol=1e-12)
    np.testing.assert_allclose(bench["Q_REF"], KNOWN)


@pytest.mark.parametrize(("off", "local"), [(0.011, {}), (-0.011, {}), (0.002, {"MOST": 0.001})])
def test_a_joint_that_is_off_is_named_with_by_how_much(off, local):  # R-A16
    bench = looked(off, **local)
    assert bench.state is State.ERROR
    assert f"found {off:.4f} rad: it has to be calibrated" in str(bench.why)
    assert "joint 2" in str(bench.why)
    np.testing.assert_allclose(bench["Q_OFF"], [0.0, off, 0.0], atol=1e-12)


def test_what_is_told_is_the_mean_of_the_look():  # R-A16
    bench = Bench(CODE, constants=ARM).init()
    bench["Q_MEZ"] = KNOWN
    bench.on(LINE)
    bench.cycle(100)
    bench["Q_MEZ"] = KNOWN + np.array([0.0, 0.0, 0.004])
    bench.cycle(100)
    np.testing.assert_allclose(bench["Q_OFF"], [0.0, 0.0, 0.002], atol=1e-12)


def test_an_arm_that_stands_elsewhere_is_not_moved():  # R-A16
    bench = looked(-0.25)
    assert bench.state is State.ERROR
    np.testing.assert_allclose(bench["Q_REF"], KNOWN + np.array([0.0, -0.25, 0.0]))
    assert "expected joint 2 within 0.2 rad of where it is known to be, found it -0.250 rad away" in str(bench.why)
