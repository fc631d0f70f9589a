"""A gripper in metres and newtons, and the job that opens and closes it."""

import pytest

from onika.model.lifecycle import State
from onika.ring.device import DeviceOrder
from onika.store.shipped import shipped
from onika.testing.bench import Bench
from onika.testing.bench_device import BenchDevice

MODULES = shipped() / "arms" / "module"


def test_opening_and_force_go_to_the_device_and_what_the_fingers_do_comes_back():  # R-K05
    device = BenchDevice(["opening", "speed", "force"], ["opening", "force"])
    bench = Bench(MODULES / "grip.py", frequency=250, device=device).init()
    device.state[:] = 0.04, 0.0, 1.5
    assert bench.on().cycle()["GRIP_MEZ"].tolist() == [0.04, 0.0, 1.5]
    assert device.order == DeviceOrder.HOLD
    bench["OPEN_REF"], bench["FORCE_REF"] = 0.01, 20.0
    bench.cycle()
    assert (device.order, device.commands.tolist()) == (DeviceOrder.DRIVE, [0.01, 20.0])
    bench.off()
    assert device.order == DeviceOrder.HOLD


def test_a_device_that_is_no_gripper_of_this_kind_is_not_driven():
    bench = Bench(MODULES / "grip.py", frequency=250, device=BenchDevice(["q1"], ["tau1"])).init()
    assert bench.state is State.ERROR
    assert (
        "expected a gripper that publishes 3 numbers and takes 2, found a device that publishes 1 and takes 1"
        in bench.why
    )


def squeeze(line, opening, stops_at, force):
    """Fingers that go at 0.1 m/s until something is between them."""
    bench = Bench(MODULES / "squeeze.py", frequency=50).init()
    bench["GRIP_MEZ"] = [opening, 0.0, 0.0]
    bench.on(line)
    while bench.finished is None:
        way = bench["OPEN_REF"] - opening
        step = max(-0.002, min(0.002, way))
        stopped = opening + step < stops_at
        opening = stops_at if stopped else opening + step
        bench["GRIP_MEZ"] = [opening, 0.0 if stopped or not step else step * 50, force if stopped else 0.0]
        bench.cycle()
    return bench


@pytest.mark.parametrize(
    ("line", "opening", "stops_at", "force", "flow"),
    [
        ("0 20", 0.08, 0.05, 20.0, 1),
        ("0 20", 0.08, -1.0, 0.0, 0),
        ("0 20", 0.08, 0.05, 0.2, 0),
        ("0.05 20", 0.08, 0.05, 20.0, 0),
        ("0.08 20", 0.01, -1.0, 0.0, 0),
    ],
    ids=["holds", "closes on nothing", "touches lightly", "as near as was wanted", "opens"],
)
def test_it_tells_whether_it_holds_something(line, opening, stops_at, force, flow):  # R-K05, §4.4.7.2
    bench = squeeze(line, opening, stops_at, force)
    assert (bench.finished.flow, bench.finished.loop) == (flow, bool(flow))
    assert bench["FORCE_REF"] == 20.0


def test_fingers_that_never_rest_end_it_too():
    bench = Bench(MODULES / "squeeze.py", frequency=50, local={"MOST": 1.0}).init()
    bench["GRIP_MEZ"] = [0.05, 0.1, 0.0]
    assert bench.on("0 5").cycle(200).cycles == 50


def test_an_opening_that_is_none_is_asked_for_again():
    bench = Bench(MODULES / "squeeze.py", frequency=50).init()
    assert bench.on("-1 5").state is State.ASKING


def test_fingers_go_to_the_opening_of_their_target_and_stop_when_they_stand_still():  # R-X19
    bench = Bench(MODULES / "fingers.py", frequency=50, local={"FORCE": "7"}).init()
    bench["GRIP_MEZ"] = (0.0, 0.0, 0.0)
    bench.on("0.05")
    assert (bench["OPEN_REF"], bench["FORCE_REF"]) == (0.05, 7.0)
    bench["GRIP_MEZ"] = (0.02, 0.1, 0.0)
    for _ in range(20):
        bench.cycle()
    assert bench.finished is None
    bench["GRIP_MEZ"] = (0.05, 0.0, 0.0)
    bench.cycle()
    assert bench.finished is not None
