"""The device on a bench."""

from onika.ring.device import DeviceOrder
from onika.testing.bench import Bench
from onika.testing.bench_device import BenchDevice

DRIVER = """
from onika.module import InVar, Module, OutVar

class Driver(Module):
    hardware = True
    PUSH = InVar("double", "N", "force")
    PLACE = OutVar("double", "m", "place")

    def on(self, inputs):
        self.PLACE = self.device.read()[0]

    def cycle(self):
        self.PLACE = self.device.read()[0]
        self.device.write([self.PUSH])
"""


def bench_of(tmp_path, device):
    file = tmp_path / "driver.py"
    file.write_text(DRIVER)
    return Bench(file, frequency=100, device=device)


def test_a_module_reads_what_the_device_publishes(tmp_path):
    device = BenchDevice(["place"], ["force"])
    bench = bench_of(tmp_path, device).init().on()
    device.state[0] = 0.25
    assert bench.cycle()["PLACE"] == 0.25


def test_a_hardware_module_holds_until_its_inputs_are_fresh(tmp_path):  # law 4
    device = BenchDevice(["place"], ["force"])
    bench = bench_of(tmp_path, device).init().on().cycle(3)
    assert device.order == DeviceOrder.HOLD
    bench["PUSH"] = 7.0
    bench.cycle()
    assert device.order == DeviceOrder.DRIVE
    assert device.commands.tolist() == [7.0]


def test_off_leaves_the_device_in_hold(tmp_path):  # law 12
    device = BenchDevice(["place"], ["force"])
    bench = bench_of(tmp_path, device).init().on()
    bench["PUSH"] = 7.0
    bench.cycle().off()
    assert device.order == DeviceOrder.HOLD


def test_a_device_that_only_publishes_takes_no_commands(tmp_path):
    device = BenchDevice(["place"])
    bench = bench_of(tmp_path, device).init().on()
    bench["PUSH"] = 7.0
    bench.cycle()
    assert "takes no commands" in bench.why
    assert device.order == DeviceOrder.HOLD
