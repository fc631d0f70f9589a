"""The SCARA as a hardware module, and what it can reach."""

from types import SimpleNamespace

import numpy as np
import pytest

from onika.laws import adept_one, puma560, reach
from onika.laws.robot import published
from onika.laws.textbook import screws_of
from onika.model.lifecycle import State
from onika.ring.device import DeviceOrder, DriveState
from onika.store.shipped import shipped
from onika.testing.bench import Bench
from onika.testing.bench_device import BenchDevice

CODE = shipped() / "generic" / "module" / "arm.py"
GENERIC = shipped() / "generic" / "module"
PUMA = published(puma560, 0.0, 0.0, 0.0, 0.0)
ABOVE_TRIANGLE = [0.181442, -0.625356, 2.700589, 0.0, 1.06636, 1.752238, 2.3]


def arm(robot="adept_one"):
    joints = range(1, 5)
    base = tuple(np.eye(4).ravel().tolist())
    return BenchDevice([f"q{k}" for k in joints], [f"tau{k}" for k in joints], {"ROBOT": robot, "BASE": base})


def scara(device, **local):
    return Bench(CODE, frequency=500, local={"ROBOT": "adept_one", "BASE": "0 0 0 0", **local}, device=device).init()


@pytest.fixture
def constants():
    cls = scara(arm()).cls
    return cls, cls.constants(SimpleNamespace(ROBOT="adept_one", BASE=[0.0, 0.0, 0.0, 0.0]), {})


def test_it_publishes_everything_that_is_known_of_the_robot():  # R-K03, law 20
    bench = scara(arm())
    assert bench.state is State.OFF, bench.why
    assert (bench["NDOF"], bench["ROBOT"]) == (4, "adept_one")
    assert bench["SCREW"] == pytest.approx(screws_of(adept_one.DH))
    assert bench["Q^_MAX"] == pytest.approx(adept_one.QDMAX)


def test_another_robot_is_not_driven():
    assert "expected the robot adept_one behind the device, found puma560" in scara(arm("puma560")).why


def test_torques_are_clipped_to_what_the_motors_can_do():
    device = arm()
    bench = scara(device, STEP="1e6").on()
    bench["TAU_REF"] = [1000, -1000, 1, -1]
    bench.cycle()
    assert device.commands.tolist() == [300.0, -150.0, 1.0, -1.0]


def test_a_tripped_drive_is_an_error_that_clear_mends():  # law 17, R-C28
    device = arm()
    bench = scara(device).on()
    device.values[1] = DriveState.TRIPPED
    bench.cycle()
    assert (bench.state, "the drive has tripped" in bench.why) == (State.ERROR, True)
    bench.clear()
    assert device.order == DeviceOrder.CLEAR


def test_targets_out_of_its_reach_are_named(constants):  # law 26, R-E09, R-K03
    cls, stated = constants
    box, far = [0, 0, -1, 0, 1, 0, 0.7, 0.28, -0.3346, 1.4], [0, 0, -1, 0, 1, 0, 0.9, 0.28, -0.3346, 1.4]
    reachable, out, up = cls.resolve(stated, [("cartesian object", pose) for pose in (box, far, [0, 0, 1, *box[3:]])])
    assert reachable is None
    assert out.startswith("out of reach: the quill would be")
    assert up.startswith("the hand would lean 180 degrees")
    assert cls.resolve(stated, [("joint object", [0.1, 0.2, 0.3, 0.0])]) == ["joint 3 at 0.300 m is beyond 0.295"]
    assert cls.resolve(stated, [("file name object", ["x"])]) == [None]


def test_it_says_the_joint_values_of_the_pumas_targets_or_why_there_are_none(constants):  # law 26, R-E09
    cls, stated = constants
    triangle, up = cls.postures(stated, reach.poses(PUMA, [ABOVE_TRIANGLE, puma560.HOME]))
    assert cls.resolve(stated, [("joint object", triangle)]) == [None]
    assert cls.poses(stated, [triangle])[0] == pytest.approx(reach.poses(PUMA, [ABOVE_TRIANGLE])[0], abs=1e-4)
    assert up.startswith("the hand would lean 180 degrees")


def test_the_generic_tasks_serve_it_as_they_are(constants):  # R-K03, law 20
    _, stated = constants
    posture = np.array([0.1, 0.7, 0.1, -0.8])
    bench = Bench(GENERIC / "fwdkin.py", frequency=250, constants=stated).init()
    bench["Q_MEZ"] = posture
    pose = bench.on().cycle()["X_MEZ"]
    assert pose[:3, 2] == pytest.approx([0.0, 0.0, -1.0])
    assert pose[2, 3] == pytest.approx(0.30 - 0.24 - 0.13 - 0.1)
    back = Bench(GENERIC / "invkin.py", frequency=250, constants=stated).init()
    back["Q_MEZ"], back["X_REF"] = posture, pose
    assert back.on().cycle()["Q_REF"] == pytest.approx(posture)
    weight = Bench(GENERIC / "gravcomp.py", frequency=250, constants=stated).init()
    weight["Q_MEZ"] = posture
    hanging = adept_one.DYN[2:, 0].sum() + adept_one.LOAD[0]
    assert weight.on().cycle()["TAU_G"] == pytest.approx([0.0, 0.0, -9.81 * hanging, 0.0], abs=1e-9)
