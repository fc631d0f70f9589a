"""The hardware modules of the kinematic mode: angles in place of torques, everything else as with forces (law 18)."""

from types import SimpleNamespace

import numpy as np
import pytest

from kit.worlds.box_cells import boxes_world
from onika.model.lifecycle import State
from onika.model.port import PortKind
from onika.ring.device import DeviceOrder, DriveState
from onika.store.shipped import shipped
from onika.store.site import open_site
from onika.testing.bench import Bench
from onika.testing.bench_device import BenchDevice

PAIRS = [("puma560", "puma", "puma_kin"), ("adept_one", "scara", "scara_kin")]
SITE = open_site((), {}, None)
every_robot = pytest.mark.parametrize(("robot", "physical", "name"), PAIRS)


def task(name):
    return SITE.task(name)[0].task


def device_of(name):
    named = next(line.words[0] for line in task(name).local if line.key == "DEVICE")
    sheet = next(device for device in boxes_world().devices() if f"boxes:{device.name}" == named)
    return BenchDevice(sheet.state[2:], sheet.command, sheet.identity)


def bench_of(robot, name, device):
    path = shipped() / "generic" / "module" / f"{task(name).module}.py"
    return Bench(path, frequency=500, local={"ROBOT": robot, "BASE": "0 0 0 0"}, device=device)


@every_robot
def test_it_gives_all_that_the_arm_with_forces_gives(robot, physical, name):  # R-E09, R-K03
    with_forces, without = task(physical), task(name)
    assert (without.outconst, without.outvar) == (with_forces.outconst, with_forces.outvar)
    assert without.invar == ("Q_REF",)
    classes = [bench_of(robot, module, device_of(module)).cls for module in (physical, name)]
    puma, other = (cls.constants(SimpleNamespace(ROBOT=robot, BASE=[0.0] * 4), {}) for cls in classes)
    assert all(np.array_equal(puma[key], other[key]) for key in puma)
    for attribute, declared in classes[0].declared_ports.items():
        port = declared.port(attribute)
        if port.kind is not PortKind.INVAR:
            assert classes[1].declared_ports[attribute].port(attribute) == port


@every_robot
def test_the_reference_goes_to_the_device_as_it_is(robot, physical, name):  # R-K03
    device = device_of(name)
    bench = bench_of(robot, name, device).init().on()
    assert bench.state is State.ON, bench.why
    assert bench.cycle() and device.order == DeviceOrder.HOLD, "not before a reference is there (law 4)"
    wanted = np.linspace(0.001, 0.002, bench["NDOF"])  # near to where it is
    bench["Q_REF"] = wanted
    bench.cycle()
    assert device.order == DeviceOrder.DRIVE
    assert device.commands.tolist() == wanted.tolist()
    bench["Q_REF"] = wanted + 3.0
    bench.off().on().cycle()
    bench["Q_REF"] = wanted + 3.0
    bench.cycle(51)
    assert (bench.state, "Q_REF" in bench.why, "would step by" in bench.why) == (State.ERROR, True, True)
    assert device.order == DeviceOrder.HOLD


@every_robot
def test_neither_drives_the_device_of_the_other(robot, physical, name):  # angles are no torques
    assert "driven by posture, found one driven by torque" in bench_of(robot, name, device_of(physical)).init().why
    assert "driven by torque, found one driven by posture" in bench_of(robot, physical, device_of(name)).init().why


@every_robot
def test_a_panic_button_stops_it_as_well(robot, physical, name):  # R-K06
    device = device_of(name)
    bench = bench_of(robot, name, device).init().on()
    device.values[1] = DriveState.PRESSED
    bench.cycle()
    assert (bench.state, "panic button pressed" in bench.why) == (State.ERROR, True)
    assert "let it go, then clear" in bench.clear().why
