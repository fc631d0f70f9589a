"""Bases as tasks: what they do, where they believe to be, and how they come to a place."""

import numpy as np
import pytest

from onika.laws.planar import advanced
from onika.model.lifecycle import State
from onika.ring.device import DeviceOrder
from onika.store.shipped import shipped
from onika.testing.bench import Bench
from onika.testing.bench_device import BenchDevice

MODULES = shipped() / "mobile" / "module"
STATE, COMMAND = ["x", "y", "turn", "vx", "vy", "w"], ["vx", "vy", "w"]


def test_a_base_publishes_where_it_is_and_goes_as_it_is_told():  # R-K04, R-K05
    device = BenchDevice(STATE, COMMAND, {"DRIVE": "twist", "V_MAX": (0.5, 0.0, 2.0)})
    bench = Bench(MODULES / "base.py", frequency=250, device=device).init()
    device.state[:] = 1.0, 2.0, 0.5, 0.1, 0.0, 0.2
    bench.on().cycle()
    assert (bench["P_TRUE"].tolist(), bench["W_MEZ"].tolist()) == ([1.0, 2.0, 0.5], [0.1, 0.0, 0.2])
    assert device.order == DeviceOrder.HOLD
    bench["V_BASE"] = (0.02, 0.0, 0.1)
    bench.cycle()
    assert (device.order, device.commands.tolist()) == (DeviceOrder.DRIVE, [0.02, 0.0, 0.1])
    bench.task.input_guard.transfer.channels = ()  # what follows is no switch
    bench["V_BASE"] = (3.0, 3.0, -9.0)
    bench.cycle()
    assert device.commands.tolist() == [0.5, 0.0, -2.0]


def test_what_is_no_base_is_not_driven():
    device = BenchDevice(STATE, COMMAND, {"DRIVE": "torque", "V_MAX": (0.5, 0.0, 2.0)})
    bench = Bench(MODULES / "base.py", frequency=250, device=device).init()
    assert bench.state is State.ERROR and "driven by twist, found one driven by torque" in bench.why


def test_odometry_adds_up_and_goes_on_where_it_was():  # R-K04
    bench = Bench(MODULES / "odometry.py", frequency=250, local={"START": "1 2 0"}).init()
    bench["W_MEZ"] = (0.5, 0.0, 0.5)
    bench.on().cycle(500)
    assert bench["P_MEZ"] == pytest.approx(advanced((1.0, 2.0, 0.0), (0.5, 0.0, 0.5), 2.0))
    there = bench["P_MEZ"].copy()
    bench.off()
    bench["P_MEZ"] = np.zeros(3)
    assert bench.on()["P_MEZ"] == pytest.approx(there)


def driven(line, **local):
    bench = Bench(MODULES / "gopose.py", frequency=50, local=local).init()
    bench["P_MEZ"] = place = np.zeros(3)
    bench.on(line)
    while bench.finished is None and bench.state is State.ON:
        bench.cycle()
        place = advanced(place, bench["V_BASE"], 0.02)
        bench["P_MEZ"] = place
    return bench


def test_it_drives_to_its_place():  # R-K04, R-K05
    bench = driven("1 -0.5 3")
    assert (bench.finished.flow, bench.finished.loop) == (0, False)
    assert bench["P_MEZ"][:2] == pytest.approx((1.0, -0.5), abs=0.01)
    assert np.cos(bench["P_MEZ"][2] - 3.0) > 0.999
    assert bench["V_BASE"] == pytest.approx(np.zeros(3), abs=0.01)


def test_a_place_that_it_does_not_come_to_is_an_error():  # R-X04
    bench = driven("9 0 0", MOST="2")
    assert bench.state is State.ERROR
    assert "did not come to its place in 2 s: it is 8." in bench.why


def test_it_begins_with_the_speeds_that_are_in_force():  # law 3
    bench = Bench(MODULES / "gopose.py", frequency=50).init()
    bench["V_BASE"] = (0.2, 0.0, 0.1)
    assert bench.on("1 0 0")["V_BASE"].tolist() == [0.2, 0.0, 0.1]
    bench.off()
    assert bench.forget("V_BASE").on("1 0 0")["V_BASE"].tolist() == [0.0, 0.0, 0.0]
