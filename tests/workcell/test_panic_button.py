import pytest

from onika.ring.device import DeviceSheet
from onika.ring.drive import DriveInput
from onika.workcell.panic_button import PanicButton
from onika.workcell.unit import DeviceUnit


def arm(side):
    return DeviceUnit(DeviceSheet(f"arm_{side}", ("time", "drive"), ("tau1",), {}), side)


@pytest.fixture
def unit():
    return arm("right")


@pytest.fixture
def button(unit):
    return PanicButton(unit)


def test_it_stays_as_it_was_put(button):  # R-K06
    assert (button.name, button.is_pressed) == ("panic_right", False)
    assert (button.put(1), button.is_pressed) == (DriveInput.PRESS, True)
    assert (button.put(0.0), button.is_pressed) == (DriveInput.LET_GO, False)


def test_it_is_called_as_its_world_wants_else_after_the_first_of_its_units(unit):  # R-K06, R-X19
    other = arm("left")
    assert PanicButton(unit, other).name == "panic_right"
    assert PanicButton(unit, other, name="big_red").name == "big_red"


def test_it_knows_whose_drive_it_stops(button, unit):  # R-K06
    assert button.units == (unit,)


@pytest.mark.parametrize("value", [0.5, -1.0, 2.0, float("nan")])
def test_half_pressed_there_is_not(button, value):
    button.put(1.0)
    with pytest.raises(ValueError, match="1 pressed, 0 let go for panic_right"):
        button.put(value)
    assert button.is_pressed
