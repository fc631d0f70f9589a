"""Faults to try between a writer and its readers: delay, noise, drop-out, stuck, lost link, drift."""

import numpy as np
import pytest

from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

MODULES = shipped() / "signals" / "module"
PALETTE = ["delay", "slow_drift", "drop_out", "lost_link", "noise", "stuck"]
NAN = float("nan")


def bench_of(fault, seed=0, **local):
    return Bench(MODULES / f"{fault}.py", frequency=100, constants={"NDOF": 2}, local=local, seed=seed).init()


def course(fault, cycles=60, seed=0, **local):
    """What its readers get cycle by cycle of a ramp, whose elements are k and -k at the cycle k from 1 on."""
    bench = bench_of(fault, seed, **local)
    bench["Y"] = [0.0, 0.0]
    bench.on()
    rows = []
    for k in range(1, cycles + 1):
        bench["Y"] = [k, -k]
        rows.append(bench.cycle()["Z"].copy())
        if bench.state is not State.ON:
            break
    return np.array(rows)


RAMP = np.array([[k, -k] for k in range(1, 61)], float)


@pytest.mark.parametrize("fault", PALETTE)
def test_before_it_begins_a_fault_passes_on_what_is_measured(fault):  # R-X14
    assert (course(fault, 20, AFTER=0.2) == RAMP[:20]).all()


@pytest.mark.parametrize("fault", PALETTE)
def test_what_is_no_number_never_comes_out_of_a_fault(fault):  # R-X14
    bench = bench_of(fault, AFTER=0.05)
    bench["Y"] = [NAN, 1.0]
    assert np.isfinite(bench.on()["Z"]).all()
    for k in range(30):
        bench["Y"] = [NAN if k % 3 else float(k), float("inf")]
        if bench.state is State.ON:
            assert np.isfinite(bench.cycle()["Z"]).all()
    assert bench["Z"][1] == pytest.approx(1.0, abs=0.1)


@pytest.mark.parametrize("fault", PALETTE)
def test_a_fault_comes_on_with_what_is_measured_then(fault):  # R-X14
    bench = bench_of(fault, AFTER=0.0)
    bench["Y"] = [0.25, -3.0]
    assert bench.on()["Z"].tolist() == [0.25, -3.0]
    assert bench.cls.passive


def test_a_delay_lets_nothing_come_at_first_and_everything_late_from_then_on():  # R-X14
    late = course("delay", LATE=0.05, AFTER=0.2)
    assert (late[20:25] == RAMP[19]).all()
    assert (late[25:] == RAMP[20:55]).all()
    assert (course("delay", LATE=0.0, AFTER=0.0) == RAMP).all()


def test_noise_has_the_size_that_is_asked_for_and_is_the_same_with_the_same_seed():  # R-X14, law 14
    noise = course("noise", 2000, seed=7, SIGMA=0.5, AFTER=0.0)[:60] - RAMP
    assert noise.std() == pytest.approx(0.5, rel=0.25)
    assert abs(np.corrcoef(noise.T)[0, 1]) < 0.4
    assert (course("noise", seed=7, SIGMA=0.5, AFTER=0.0) - RAMP == noise).all()
    assert (course("noise", seed=8, SIGMA=0.5, AFTER=0.0) - RAMP != noise).any()


def test_what_drops_out_leaves_the_old_values_for_a_while():  # R-X14
    all_lost = course("drop_out", SHARE=1.0, LASTS=0.05, AFTER=0.2)
    assert (all_lost[20:] == RAMP[19]).all()
    some = course("drop_out", 400, seed=3, SHARE=0.05, LASTS=0.05, AFTER=0.0)
    steps = np.diff(some[:, 0], prepend=0.0)
    assert set(steps) >= {0.0, 1.0, 6.0}  # five are lost, and the next one is the newest
    assert (steps[steps > 1.0] % 5 == 1.0).all()
    assert (course("drop_out", 400, seed=3, SHARE=0.05, LASTS=0.05, AFTER=0.0) == some).all()


def test_one_element_is_stuck_and_the_other_goes_on():  # R-X14
    stuck = course("stuck", ELEMENT=1, AFTER=0.2)
    assert (stuck[20:, 1] == RAMP[19, 1]).all()
    assert (stuck[:, 0] == RAMP[:, 0]).all()


def test_where_the_link_is_lost_the_task_is_off_and_nothing_is_written():  # R-X14
    lost = course("lost_link", AFTER=0.2)
    assert len(lost) == 21
    assert (lost[-1] == RAMP[19]).all()


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_drift_grows_to_where_it_ends(sign):  # R-X14
    drift = course("slow_drift", RATE=sign, MOST=0.25, AFTER=0.2, ELEMENT=1) - RAMP
    assert drift[20:46, 1] == pytest.approx(sign * np.arange(26) / 100)
    assert drift[46:, 1] == pytest.approx(sign * 0.25)
    assert (drift[:, 0] == 0.0).all()


@pytest.mark.parametrize("fault", ["stuck", "slow_drift"])
def test_an_element_that_is_not_there_is_refused(fault):
    bench = bench_of(fault, ELEMENT=2)
    assert bench.state is State.ERROR
    assert "expected 0..1, found 2" in bench.why
