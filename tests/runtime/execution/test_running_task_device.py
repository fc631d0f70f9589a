"""A running task with a device: when it holds, and what its inputs have to be."""

from types import SimpleNamespace

import pytest

from onika.module import InVar, Module, OutVar
from onika.runtime.device import SILENCE_NS
from onika.runtime.error import LawBroken

MS = 1_000_000
NOTHING = SimpleNamespace()


class Arm(Module):
    """Holds by a word of its own."""

    hardware = True
    F = InVar("double")
    G = InVar("double")
    X = OutVar("double")
    did = ""

    def cycle(self):
        self.did = "cycle"
        self.device.write((self.F + self.G,))

    def hold(self):
        self.did = "hold"
        self.X = self.device.read()[0]


def arm_on(place):
    task = place.task(Arm, with_device=True)
    task.init()
    place.device.publish(0)
    task.on(0, NOTHING)
    return task


def cycle(place, task, now):
    place.device.publish(now)
    task.cycle(now)
    return task.module.did


def test_hardware_holds_until_every_input_was_written_since_its_on(place):  # law 4
    place.write(F=9.0, G=9.0)
    task = arm_on(place)
    assert cycle(place, task, 10 * MS) == "hold"
    place.write(F=1.0)
    assert cycle(place, task, 20 * MS) == "hold"
    place.write(G=2.0)
    assert cycle(place, task, 30 * MS) == "cycle"
    assert (place.device.order, place.device.commands.tolist()) == (1, [3.0])
    assert cycle(place, task, 40 * MS) == "cycle"


def test_hardware_publishes_while_it_holds(place):  # law 4
    place.device.state[:] = 0.25
    task = arm_on(place)
    cycle(place, task, 10 * MS)
    assert place.table.value("X") == 0.25


def test_hardware_that_comes_on_again_waits_again(place):  # law 4
    task = arm_on(place)
    place.write(F=1.0, G=1.0)
    cycle(place, task, 10 * MS)
    task.off()
    task.on(20 * MS, NOTHING)
    assert cycle(place, task, 20 * MS) == "hold"


def test_an_input_is_fresh_only_if_its_fresh_value_was_copied(place):  # law 4
    """A value that is written while the inputs are copied in must not let through what was copied before."""
    task = arm_on(place)
    place.write(F=1.0, G=-7.0)
    task.on(0, NOTHING)
    place.write(F=2.0)
    task._reads.append(lambda: place.write(G=3.0))
    assert cycle(place, task, 10 * MS) == "hold"
    task._reads.pop()
    assert cycle(place, task, 20 * MS) == "cycle"
    assert place.device.commands.tolist() == [5.0]


@pytest.mark.parametrize("value", [float("nan"), float("-inf")])
def test_inputs_that_are_not_finite_break_the_law_and_are_named(place, value):  # law 5
    task = arm_on(place)
    place.write(F=value, G=1.0)
    with pytest.raises(LawBroken, match="NaN or infinity in F"):
        cycle(place, task, 10 * MS)


def test_a_silent_device_breaks_the_law(place):  # law 17
    task = arm_on(place)
    place.write(F=1.0, G=1.0)
    cycle(place, task, 10 * MS)
    task.cycle(10 * MS + SILENCE_NS)
    with pytest.raises(LawBroken, match="device bench has published nothing for 60 ms"):
        task.cycle(11 * MS + SILENCE_NS)


def test_off_and_hold_leave_the_drive_in_hold_even_if_the_module_raises(place):  # law 17
    class Stubborn(Arm):
        def off(self):
            raise ValueError("no")

    for leave in ("off", "hold"):
        task = place.task(Stubborn, with_device=True)
        task.module.device.write((1.0,))
        if leave == "off":
            with pytest.raises(ValueError, match="no"):
                task.off()
        else:
            task.hold()
        assert place.device.order == 0
