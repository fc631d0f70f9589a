"""A neural network as a task: the torque that holds an arm, as it has learnt it."""

import numpy as np
import pytest

from onika.laws import puma560
from onika.laws.textbook import serial_arm
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

MODULE = shipped() / "learning" / "module" / "net_torque.py"
GRAVITY = "learning/net/puma_gravity.onnx"
CONSTANTS = {"NDOF": puma560.NDOF, "TAUMAX": puma560.TAUMAX}


def bench_of(model=GRAVITY, constants=CONSTANTS):
    return Bench(MODULE, frequency=250, constants=constants, local={"MODEL": model}).init()


def test_the_shipped_network_has_learnt_the_gravity_of_the_puma():  # R-K09
    arm, random = serial_arm(puma560.DH, puma560.DYN, puma560.LOAD), np.random.default_rng(1)
    bench = bench_of()
    bench.on()
    away = []
    for posture in random.uniform(puma560.QMIN, puma560.QMAX, (300, puma560.NDOF)):
        bench["Q_MEZ"] = posture
        away.append(bench.cycle()["TAU_G"] - arm.bias(posture, np.zeros(puma560.NDOF)))
    assert np.abs(away).mean() < 0.01 * puma560.TAUMAX.max()
    assert (np.abs(away).max(axis=0) < 0.05 * puma560.TAUMAX).all()


def test_no_more_than_the_highest_torque_comes_out():  # R-K09
    weak = np.full(puma560.NDOF, 0.5)
    bench = bench_of(constants=CONSTANTS | {"TAUMAX": weak})
    bench["Q_MEZ"] = [0.0, 0.0, 1.57, 0.0, 0.0, 0.0]
    assert np.abs(bench.on()["TAU_G"]).max() == 0.5


def test_what_is_no_number_never_comes_out():  # R-K09
    bench = bench_of().on()
    bench["Q_MEZ"] = np.full(puma560.NDOF, np.nan)
    assert bench.cycle().state is State.ERROR
    assert np.isfinite(bench["TAU_G"]).all()


@pytest.mark.parametrize("model", ["nowhere.onnx", str(MODULE), "~"])
def test_a_file_that_is_no_network_is_told(model):  # R-K09, R-B07
    bench = bench_of(model)
    assert "expected a network in" in bench.failed.text


def test_a_network_for_another_arm_is_told():  # R-K09
    bench = bench_of(constants={"NDOF": 4, "TAUMAX": np.ones(4)})
    assert "expected a network from 4 joints" in bench.failed.text
