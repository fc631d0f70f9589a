"""The tool presses with a force on what it meets."""

import numpy as np
import pytest

from onika.laws.frames import pose_of_nine, rotation_of_rpy
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

CODE = shipped() / "generic" / "module" / "press.py"
HERE = pose_of_nine([0, 0, -1, 0, 1, 0, 0.7, 0.28, -0.1])
SPRING, SCREW = 10_000.0, 50.0
"""N/m and N m/rad: how stiff an arm presses, and turns."""


def pressed(line, floor=-0.105, carried=5.0, **local):
    """Press on a floor, as a spring does, with something in the hand; and turn against a screw that holds."""
    bench = Bench(CODE, frequency=250, local=local).init()
    bench["X_MEZ"] = HERE

    def feel():
        wanted = bench["X_REF"]
        push = SPRING * max(floor - wanted[2, 3], 0.0)
        turn = wanted[:3, :3] @ HERE[:3, :3].T
        twist = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) / 2.0
        bench["F_MEZ"] = [0.0, 0.0, push - carried, *(-SCREW * twist)]

    bench["X_REF"] = HERE
    feel()
    bench.on(line)
    while bench.state is State.ON:
        bench.cycle()
        feel()
    return bench


def test_it_presses_as_hard_as_is_wanted_whatever_it_carries():  # R-B10
    bench = pressed("0 0 -20 0 0 0")
    assert (bench.finished.flow, bench.finished.loop) == (0, False)
    assert bench["F_MEZ"][2] + 5.0 == pytest.approx(20.0, rel=0.1)
    assert bench["X_REF"][:3, :3] == pytest.approx(HERE[:3, :3])
    assert bench["X_REF"][:2, 3] == pytest.approx(HERE[:2, 3])


def test_it_turns_until_a_torque_is_there():  # R-B10
    bench = pressed("0 0 0 0 0 2")
    assert bench.finished is not None
    assert bench["F_MEZ"][5] == pytest.approx(-2.0, rel=0.1)
    assert bench["X_REF"][:3, 3] == pytest.approx(HERE[:3, 3])
    assert bench["X_REF"][:3, :3] == pytest.approx(rotation_of_rpy(0, 0, 0.04) @ HERE[:3, :3], abs=5e-3)


def test_where_it_meets_nothing_it_is_an_error_and_it_stays():  # R-B10
    bench = pressed("0 0 -20 0 0 0", floor=-9.0, FAR=0.02)
    assert bench.state is State.ERROR
    assert "nothing to press on was met within 0.02 m" in bench.why
    assert HERE[2, 3] - bench["X_REF"][2, 3] == pytest.approx(0.02, abs=1e-3)


def test_what_takes_too_long_is_an_error():
    assert "within 0.5 s" in pressed("0 0 -20 0 0 0", MOST=0.5).why


@pytest.mark.parametrize("line", ["0 0 0 0 0 0", "0 0 -300 0 0 0", "0 0 0 60 0 0"])
def test_a_force_that_is_none_or_too_much_is_asked_for_again(line):  # R-A10
    bench = Bench(CODE, frequency=250).init()
    bench["X_MEZ"] = HERE
    assert bench.on(line).state is State.ASKING
