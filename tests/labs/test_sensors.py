"""What is measured in a world, as tasks."""

import numpy as np
import pytest

from onika.laws.frames import rotation_of_rpy
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench
from onika.testing.bench_device import BenchDevice

MODULES = shipped() / "sensors" / "module"


def numbers(count):
    return BenchDevice([f"s{k}" for k in range(count)], [])


def test_a_thing_is_where_its_device_says():  # R-K05
    device = numbers(7)
    device.state[:] = 1.0, 2.0, 3.0, np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)
    bench = Bench(MODULES / "whereis.py", frequency=50, device=device).init().on()
    assert bench["X_PART"] == pytest.approx(np.array([[0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]))


def test_where_it_is_may_be_measured_wrong():  # R-K05
    device = numbers(7)
    device.state[3] = 1.0
    bench = Bench(MODULES / "whereis.py", frequency=50, device=device, local={"NOISE": "0.01"}).init().on()
    seen = np.array([bench.cycle()["X_PART"][:3, 3].copy() for _ in range(500)])
    assert np.std(seen, axis=0) == pytest.approx(np.full(3, 0.01), rel=0.2)


def test_a_wrench_is_what_its_device_says():  # R-K05
    device = numbers(6)
    device.state[:] = 1, 2, 3, 4, 5, 6
    bench = Bench(MODULES / "wrench.py", frequency=250, device=device).init().on().cycle()
    assert bench["F_RAW"].tolist() == [1, 2, 3, 4, 5, 6]


def test_a_wrench_may_be_what_holds_against_it():  # R-K05
    device = numbers(6)
    device.state[:] = 1, 2, 3, 4, 5, 6
    bench = Bench(MODULES / "wrench.py", frequency=250, device=device, local={"SIGN": "-1"}).init().on().cycle()
    assert bench["F_RAW"].tolist() == [-1, -2, -3, -4, -5, -6]
    nothing = Bench(MODULES / "wrench.py", frequency=250, device=device, local={"SIGN": "0"}).init()
    assert nothing.state is State.ERROR and "SIGN" in nothing.why


@pytest.mark.parametrize(("task", "kind"), [("whereis", "pose"), ("wrench", "wrench")])
def test_another_device_is_told(task, kind):  # R-X04
    bench = Bench(MODULES / f"{task}.py", frequency=250, device=numbers(3)).init()
    assert bench.state is State.ERROR and f"of a {kind}, found one that publishes 3" in bench.why


def test_a_wrench_without_weight_and_offset_is_what_presses_on_the_tool():  # R-K05
    local = {"MASS": "2.0", "CENTRE": "0 0 0.1", "ZERO": "0.1"}
    bench = Bench(MODULES / "unbias.py", frequency=100, local=local).init()
    offset = np.array([1.0, -2.0, 3.0, 0.1, 0.2, -0.3])

    def show(turn, force, torque):
        pose = np.eye(4)
        pose[:3, :3] = turn
        weight = turn.T @ [0.0, 0.0, -2.0 * 9.81]
        shown = np.concatenate([weight + turn.T @ force, np.cross([0, 0, 0.1], weight) + turn.T @ torque])
        bench["X_MEZ"], bench["F_RAW"] = pose, shown + offset

    tilted = rotation_of_rpy(0.4, -0.2, 1.0)
    show(tilted, np.zeros(3), np.zeros(3))
    bench.on().cycle(10)
    assert bench["F_MEZ"].tolist() == [0.0] * 6
    show(rotation_of_rpy(-1.0, 0.3, 0.0), np.array([5.0, 0.0, -7.0]), np.array([0.0, 1.0, 0.0]))
    assert bench.cycle()["F_MEZ"] == pytest.approx([5, 0, -7, 0, 1, 0])
    assert bench.get("offset") == pytest.approx(3.0)


def test_a_gauge_says_one_of_the_numbers_of_its_device():  # R-K05, R-K08
    device = numbers(3)
    device.state[:] = 0.1, -1.0, 0.3
    said = [
        Bench(MODULES / "gauge.py", frequency=250, device=device, local=local).init().on().cycle()["SENSE"]
        for local in ({}, {"NUMBER": "2"}, {"NUMBER": "2", "FAR": "5"}, {"NUMBER": "3", "FAR": "5"})
    ]
    assert said == [0.1, -1.0, 5.0, 0.3]


def test_a_gauge_of_a_number_that_is_not_there_says_so():  # R-X04
    bench = Bench(MODULES / "gauge.py", frequency=250, device=numbers(3), local={"NUMBER": "4"}).init()
    assert bench.state is State.ERROR
    assert "publishes 4 numbers or more, found one that publishes 3" in bench.why
