"""Further servos and watches: the servo with an integral, the watch for collisions, the fence."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from onika.laws import puma560
from onika.store.shipped import shipped
from onika.testing.bench import Bench

MODULES = shipped() / "control" / "module"
PLAIN = {"NDOF": 1, "KP": [100.0], "KD": [20.0], "TAUMAX": [50.0]}
LIMITS = {"NDOF": 6, "QMIN": puma560.QMIN, "QMAX": puma560.QMAX, "Q^_MAX": puma560.QDMAX}
DT = 0.002


def moved(bench, load, seconds=10.0, most=1e9):
    """Where a mass of 1 kg m2 comes to, that a load pulls at and the bench's servo holds at 0."""
    place, speed = 0.0, 0.0
    for _ in range(round(seconds / DT)):
        bench["Q_MEZ"], bench["Q^_MEZ"] = [place], [speed]
        torque = float(np.clip(bench.cycle()["TAU_PD"][0], -most, most))
        speed += DT * (torque - load)
        place += DT * speed
    return place


def servo(**local):
    bench = Bench(MODULES / "pid.py", frequency=500, constants=PLAIN, local=local).init()
    bench["Q_REF"] = [0.0]
    return bench.on()


def test_no_load_that_it_can_bear_leaves_the_joint_beside_its_reference():  # R-K05
    assert moved(servo(RATE=2, MOST=0.5), load=10.0) == pytest.approx(0.0, abs=1e-5)
    assert moved(servo(RATE=0), load=10.0) == pytest.approx(-10.0 / 100.0, abs=1e-5)  # as `pd` leaves it


def test_what_it_adds_up_never_comes_to_more_than_its_share():  # R-K05
    assert moved(servo(RATE=2, MOST=0.1), load=10.0) == pytest.approx(-(10.0 - 5.0) / 100.0, abs=1e-5)


def test_beyond_the_highest_torque_nothing_is_added_up_that_has_to_be_taken_down_again():  # R-K05
    bench = servo(RATE=5, MOST=1.0)
    bench["Q_REF"] = [2.0]  # 200 N m are asked for, 50 there are
    for _ in range(2000):
        bench.cycle()
    bench["Q_REF"] = [0.0]
    assert bench.cycle()["TAU_PD"][0] == pytest.approx(0.0, abs=1e-9)


def test_an_integral_servo_only_brakes_until_a_reference_is_in_force():  # law 3
    bench = Bench(MODULES / "pid.py", frequency=500, constants=PLAIN).init()
    bench["Q_REF"], bench["Q^_MEZ"] = [3.0], [0.5]
    bench.forget("Q_REF").on().cycle(500)
    assert bench["TAU_PD"] == pytest.approx([-10.0])
    bench["Q_REF"], bench["Q^_MEZ"] = [0.1], [0.0]
    assert bench.cycle()["TAU_PD"] == pytest.approx([10.0 + 100.0 * 0.1 * DT])


def watch(torques, **local):
    """HIT cycle by cycle, at 100 Hz, of these torques of joint 2; and the bench."""
    constants = {"NDOF": 2, "TAUMAX": [10.0, 20.0]}
    bench = Bench(MODULES / "collide.py", frequency=100, constants=constants, local=local).init().on()
    hits = []
    for torque in torques:
        bench["TAU_PD"] = [0.0, torque]
        hits.append(bench.cycle()["HIT"])
    return hits, bench


def test_a_hit_is_what_lasts_above_the_share_and_is_kept():  # R-K05
    hits, bench = watch([4.1, -4.1, 4.1, 4.1, 4.1, 0.0, 0.0], SHARE=0.2, LASTS=0.05)
    assert hits == [0, 0, 0, 0, 1, 1, 1]
    assert bench.get("joint") == 2
    assert bench.off().on()["HIT"] == 0


def test_neither_a_knock_nor_what_is_below_the_share_is_a_hit():  # R-K05
    hits, bench = watch([19.0, 19.0, 19.0, 19.0, 0.0] * 5 + [3.9] * 50, SHARE=0.2, LASTS=0.05)
    assert sum(hits) == 0 and bench.get("joint") == 0
    assert watch([4.1], SHARE=0.2, LASTS=0)[0] == [1]


wishes = st.lists(st.floats(-20, 20), min_size=6, max_size=6)


@settings(max_examples=20, deadline=None)
@given(st.lists(wishes, min_size=1, max_size=20))
def test_a_fence_lets_nothing_out_whatever_is_wished(course):  # R-K05
    bench = Bench(MODULES / "fence.py", frequency=100, constants=LIMITS, local={"MARGIN": 0.1, "SPEED": 0.5}).init()
    bench["Q_MEZ"] = puma560.HOME
    bench.on()
    for wish in course:
        bench["Q_WISH"] = wish
        before = bench["Q_REF"].copy()
        bench.cycle(10)
        now = bench["Q_REF"]
        assert (now >= puma560.QMIN + 0.1 - 1e-9).all() and (now <= puma560.QMAX - 0.1 + 1e-9).all()
        assert (np.abs(now - before) <= 10 * 0.01 * 0.5 * np.array(puma560.QDMAX) + 1e-9).all()
        assert (np.abs(bench["Q^_REF"]) <= 0.5 * np.array(puma560.QDMAX) + 1e-9).all()


def test_a_wish_inside_the_fence_is_reached():
    bench = Bench(MODULES / "fence.py", frequency=100, constants=LIMITS).init()
    bench["Q_MEZ"] = puma560.HOME
    bench.on()
    wish = np.array(puma560.HOME) + 0.1
    bench["Q_WISH"] = wish
    assert bench.cycle(200)["Q_REF"] == pytest.approx(wish)


def test_a_wish_that_is_no_number_moves_nothing():
    bench = Bench(MODULES / "fence.py", frequency=100, constants=LIMITS).init()
    bench["Q_MEZ"], bench["Q_WISH"] = puma560.HOME, puma560.HOME
    bench.on()
    bench["Q_WISH"] = [float("nan"), float("inf"), *puma560.HOME[2:]]
    assert bench.cycle(50)["Q_REF"] == pytest.approx(puma560.HOME)


def test_a_wish_from_before_the_last_hold_moves_nothing():  # law 3
    bench = Bench(MODULES / "fence.py", frequency=100, constants=LIMITS).init()
    bench["Q_MEZ"], bench["Q_WISH"] = puma560.HOME, np.zeros(6)
    bench.forget("Q_WISH", "Q_REF").on().cycle(50)
    assert bench["Q_REF"] == pytest.approx(puma560.HOME)


def pressing(stiffness, cycles=1500, **local):
    """A hand that goes along x over a floor at z = -0.01, as a spring presses: its last reference and force."""
    bench = Bench(MODULES / "force.py", frequency=250, local=local).init()
    bench["X_REF"] = np.eye(4)
    bench.on()
    for step in range(cycles):
        path = np.eye(4)
        path[0, 3] = 1e-5 * step
        bench["X_REF"] = path
        bench["F_MEZ"] = [0, 0, stiffness * max(-0.01 - bench["X_OUT"][2, 3], 0.0), 0, 0, 0]
        bench.cycle()
    return bench


def test_a_force_is_held_along_its_axis_and_the_path_across_it():  # R-K05, R-B10
    bench = pressing(10_000.0, FORCE=20)
    assert bench["F_MEZ"][2] == pytest.approx(20.0, abs=0.2)
    assert bench["X_OUT"][:3, 3] == pytest.approx([1e-5 * 1499, 0.0, -0.012], abs=1e-4)
    assert bench.get("lacks") == pytest.approx(0.0, abs=0.2)


def test_where_nothing_is_met_it_leaves_its_path_no_further_than_it_may():  # R-K05
    assert pressing(0.0, FAR=0.02, AXIS="0 0 -5")["X_OUT"][2, 3] == pytest.approx(-0.02)
