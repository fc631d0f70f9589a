"""Inverse kinematics as a module, and forward kinematics as its mirror."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.laws import puma560
from onika.laws.frames import pose_of_nine
from onika.laws.robot import published
from onika.laws.textbook import serial_arm
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

GENERIC = shipped() / "generic" / "module"
CONSTANTS = published(puma560, 0.0, 0.0, 0.0, 0.0)
ABOVE = np.array([0.1814, -0.6254, 2.7006, 0.0, 1.0664, 1.7522])
ARM = serial_arm(puma560.DH, tool=puma560.TOOL)


def invkin(posture, reference=None, **local):
    """On, with the arm at `posture` and, where given, a joint reference in force; X_REF is in force too."""
    bench = Bench(GENERIC / "invkin.py", frequency=250, constants=CONSTANTS, local=local).init()
    bench["Q_MEZ"] = posture
    if reference is not None:
        bench["Q_REF"] = reference
    bench["X_REF"] = ARM.forward(np.asarray(posture))
    return bench.on()


inner = st.tuples(
    *(st.floats(low + 0.1, high - 0.1) for low, high in zip(puma560.QMIN, puma560.QMAX, strict=True))
).filter(lambda q: abs(q[4]) > 0.1)


@settings(max_examples=examples(40), deadline=None)
@given(posture=inner)
def test_the_posture_of_a_pose_of_a_posture_is_that_posture(posture):
    forward = Bench(GENERIC / "fwdkin.py", frequency=250, constants=CONSTANTS).init()
    forward["Q_MEZ"] = posture
    bench = invkin(posture)
    bench["X_REF"] = forward.on()["X_MEZ"]
    assert bench.cycle()["Q_REF"] == pytest.approx(posture, abs=1e-7)
    assert bench["Q^_REF"] == pytest.approx(np.zeros(6), abs=1e-4)


def test_a_straight_line_becomes_a_smooth_joint_path():
    bench = invkin(ABOVE)
    path, speeds = [], []
    for step in range(251):
        share = (1 - np.cos(np.pi * step / 250)) / 2
        pose = ARM.forward(ABOVE)
        pose[2, 3] -= 0.2 * share
        bench["X_REF"] = pose
        bench.cycle()
        path.append(bench["Q_REF"])
        speeds.append(bench["Q^_REF"])
    assert ARM.forward(path[-1])[2, 3] == pytest.approx(ARM.forward(ABOVE)[2, 3] - 0.2)
    assert np.abs(np.diff(speeds, axis=0)).max() * 250 < 10.0  # rad/s2
    assert np.diff(path, axis=0) * 250 == pytest.approx(np.array(speeds[1:]))


def test_it_does_not_jump_where_the_reference_differs_from_the_pose():  # R-X04, law 3
    bench = invkin(ABOVE, reference=ABOVE + 0.01)
    assert bench["Q_REF"] == pytest.approx(ABOVE + 0.01)
    path = [bench["Q_REF"]]
    for _ in range(100):
        bench["Q_MEZ"] = ABOVE + 0.01
        path.append(bench.cycle()["Q_REF"])
    assert np.abs(np.diff(path, axis=0)).max() * 250 < 0.08  # 1.875 * 0.01 rad / 0.25 s
    assert path[-1] == pytest.approx(ABOVE, abs=1e-6)


def test_a_first_pose_far_away_is_an_error_and_moves_nothing():
    bench = invkin(ABOVE, STEP=0.05)
    bench["X_REF"] = ARM.forward(ABOVE + np.array([0.2, 0, 0, 0, 0, 0]))
    bench.cycle()
    assert bench.state is State.ERROR
    assert bench.why == (
        "ModuleError: the arm does not stand where the motion begins: joint 1 is 0.200 rad away, 0.05 rad are allowed"
    )
    assert bench["Q_REF"] == pytest.approx(ABOVE)


def test_a_pose_from_before_the_last_hold_is_not_followed():  # law 3
    bench = Bench(GENERIC / "invkin.py", frequency=250, constants=CONSTANTS).init()
    bench["Q_MEZ"] = ABOVE
    bench["X_REF"] = ARM.forward(ABOVE + 1.0)
    bench.forget("X_REF").on().cycle(50)
    assert bench.state is State.ON
    assert bench["Q_REF"] == pytest.approx(ABOVE)
    bench["X_REF"] = ARM.forward(ABOVE)
    assert bench.cycle()["Q_REF"] == pytest.approx(ABOVE)


def test_a_pose_out_of_reach_is_an_error_with_the_reason():
    bench = invkin(ABOVE)
    bench["X_REF"] = pose_of_nine([0, 0, -1, 0, 1, 0, 1.5, 0, -0.2])
    bench.cycle()
    assert bench.why.startswith("ModuleError: out of reach: the wrist would be")


def test_a_joint_that_would_turn_too_fast_is_an_error():
    bench = invkin(ABOVE).cycle()
    bench["X_REF"] = ARM.forward(ABOVE + np.array([0.05, 0, 0, 0, 0, 0]))
    bench.cycle()
    assert bench.why == (
        "ModuleError: the motion is too fast for the arm: joint 1 would turn at 12.50 rad/s, and can turn at 1.43 rad/s"
    )


def test_the_tool_of_the_second_arm_is_told_in_the_world():  # R-K02
    base = np.diag([-1.0, -1.0, 1.0, 1.0])
    base[0, 3] = 1.25
    bench = Bench(GENERIC / "fwdkin.py", frequency=250, constants={**CONSTANTS, "BASE": base}).init()
    bench["Q_MEZ"] = ABOVE
    assert bench.on()["X_MEZ"] == pytest.approx(base @ ARM.forward(ABOVE))
