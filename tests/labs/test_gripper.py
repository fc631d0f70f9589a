"""The hand: its driver, and the jobs that open and close it."""

import pytest

from onika.model.lifecycle import State
from onika.ring.device import DeviceOrder, DriveState
from onika.store.shipped import shipped
from onika.testing.bench import Bench
from onika.testing.bench_device import BenchDevice

MODULES = shipped() / "puma" / "module"


def hand():
    return BenchDevice(["opening", "speed", "force"], ["signal"])


def gripper(device):
    return Bench(MODULES / "gripper.py", frequency=250, device=device).init()


def test_the_signal_goes_to_the_valves_and_the_fingers_come_back():
    device = hand()
    device.state[:] = 0.06, 0.0, 12.0
    bench = gripper(device).on()
    assert bench["GRIP_MEZ"].tolist() == [0.06, 0.0, 12.0]
    bench["GRIP"] = -1.0
    bench.cycle()
    assert (device.order, device.commands.tolist()) == (DeviceOrder.DRIVE, [-1.0])


def test_the_hand_holds_until_a_signal_comes():  # law 4
    device = hand()
    gripper(device).on().cycle(5)
    assert device.order == DeviceOrder.HOLD


def test_a_tripped_hand_is_an_error_that_clear_mends():  # law 17
    device = hand()
    bench = gripper(device).on()
    device.values[1] = DriveState.TRIPPED
    assert bench.cycle().state is State.ERROR
    bench.clear()
    assert device.order == DeviceOrder.CLEAR


@pytest.mark.parametrize(("module", "signal"), [("opengrip", 1.0), ("closegrip", -1.0)])
class TestJob:
    def bench(self, module):
        return Bench(MODULES / f"{module}.py", frequency=50).init()

    def test_the_signal_is_there_as_soon_as_it_is_on(self, module, signal):  # law 4: the driver need not wait
        assert self.bench(module).on()["GRIP"] == signal

    def test_it_ends_when_the_fingers_stand_still(self, module, signal):
        bench = self.bench(module).on()
        bench["GRIP_MEZ"] = [0.08, 0.1, 0.0]
        bench.cycle(15)
        assert bench.state is State.ON
        bench["GRIP_MEZ"] = [0.112, 0.0005, 0.0]
        assert bench.cycle().finished is not None

    def test_it_gives_the_air_its_time(self, module, signal):
        bench = self.bench(module).on().cycle(9)
        assert bench.state is State.ON
        assert bench.cycle().state is State.OFF

    def test_it_does_not_wait_for_ever(self, module, signal):
        bench = self.bench(module).on()
        bench["GRIP_MEZ"] = [0.08, 0.1, 0.0]
        bench.cycle(100)
        assert (bench.cycles, bench.finished is not None) == (30, True)


def test_a_device_that_is_no_hand_is_told_before_the_run():  # R-X02
    fits = gripper(hand()).cls.fits
    assert fits({}, {"ROBOT": "gripper", "ARM": "arm_left"}) is None
    assert fits({}, {"ROBOT": "puma560"}) == "expected a hand behind the device, found puma560"
    assert fits({}, {"BOXES": "plus"}) == "expected a hand behind the device, found another device"
