"""The lamp monitor does not believe single looks."""

import pytest

from onika.store.shipped import shipped
from onika.testing.bench import Bench
from onika.testing.bench_device import BenchDevice

CODE = shipped() / "boxes" / "module" / "led_monitor.py"


@pytest.fixture
def lamp():
    device = BenchDevice([f"contact{k}" for k in range(1, 7)])
    return device, Bench(CODE, frequency=50, device=device).init().on()


def test_the_lamp_is_lit_after_most_of_a_window_with_all_contacts_closed(lamp):
    device, bench = lamp
    device.state[:] = 1.0
    assert bench.cycle(8)["LAMP"] == 0
    assert bench.cycle()["LAMP"] == 1


def test_one_open_contact_keeps_it_dark(lamp):
    device, bench = lamp
    device.state[:] = 1.0
    device.state[3] = 0.0
    assert bench.cycle(50)["LAMP"] == 0


def test_a_flicker_neither_lights_nor_darkens_it(lamp):
    device, bench = lamp
    device.state[:] = 1.0
    assert bench.cycle()["LAMP"] == 0
    bench.cycle(20)
    device.state[:] = 0.0
    assert bench.cycle()["LAMP"] == 1
    assert bench.cycle()["LAMP"] == 0  # two of ten: 80 % is not more than 80 %
    device.state[:] = 1.0
    assert bench.cycle(20)["LAMP"] == 1


def test_it_begins_dark(lamp):
    device, bench = lamp
    device.state[:] = 1.0
    bench.cycle(20).off()
    assert bench.on()["LAMP"] == 0


def test_a_device_that_is_no_lamp_is_told_before_the_run(lamp):  # R-X02
    _, bench = lamp
    assert bench.cls.fits({}, {"BOXES": "plus square"}) is None
    assert bench.cls.fits({}, {"ROBOT": "puma560"}) == "expected the lamp behind the device, found puma560"
