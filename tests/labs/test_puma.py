"""The PUMA 560 as a hardware module, and what it can reach."""

from types import SimpleNamespace

import numpy as np
import pytest

from onika.laws import puma560
from onika.laws.textbook import screws_of
from onika.model.lifecycle import State
from onika.ring.device import DeviceOrder, DriveState
from onika.store.shipped import shipped
from onika.testing.bench import Bench
from onika.testing.bench_device import BenchDevice

CODE = shipped() / "generic" / "module" / "arm.py"
RIGHT = [-1, 0, 0, 1.25, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]


def arm(base=None, robot="puma560"):
    base = tuple(map(float, np.eye(4).ravel() if base is None else base))
    joints = range(1, 7)
    return BenchDevice([f"q{k}" for k in joints], [f"tau{k}" for k in joints], {"ROBOT": robot, "BASE": base})


def puma(device, base="0 0 0 0", **local):
    return Bench(CODE, frequency=500, local={"ROBOT": "puma560", "BASE": base, **local}, device=device).init()


@pytest.fixture
def constants():
    cls = puma(arm()).cls
    return cls, cls.constants(SimpleNamespace(ROBOT="puma560", BASE=[0.0, 0.0, 0.0, 0.0]), {})


def test_it_publishes_everything_that_is_known_of_the_robot():
    bench = puma(arm())
    assert bench.state is State.OFF
    assert (bench["NDOF"], bench["ROBOT"]) == (6, "puma560")
    assert bench["SCREW"] == pytest.approx(screws_of(puma560.DH))
    assert bench["PARENT"].tolist() == [-1, 0, 1, 2, 3, 4]
    assert bench["HOME"] == pytest.approx(puma560.HOME)
    assert bench["Q^_MAX"] == pytest.approx(puma560.QDMAX)
    assert bench["BASE"] == pytest.approx(np.eye(4))


def test_the_second_arm_faces_the_first_one():  # R-K02
    bench = puma(arm(RIGHT), "1.25 0 0 180")
    assert bench.state is State.OFF, bench.why
    assert bench["BASE"].ravel() == pytest.approx(RIGHT)


def test_a_robot_that_stands_elsewhere_is_not_driven():
    bench = puma(arm(RIGHT))
    assert bench.state is State.ERROR
    assert "expected frame 0 of the robot at 0 0 0 m, turned by 0 degrees, found it at 1.25 0 0 m" in bench.why


def test_another_robot_is_not_driven():
    assert "expected the robot puma560 behind the device, found adept" in puma(arm(robot="adept")).why


def test_joint_angles_are_there_as_soon_as_it_is_on():  # law 3
    device = arm()
    device.state[:] = puma560.HOME
    assert puma(device).on()["Q_MEZ"] == pytest.approx(puma560.HOME)


def test_torques_are_clipped_to_what_the_motors_can_do():
    device = arm()
    bench = puma(device, STEP="1e6").on()
    bench["TAU_REF"] = [1000, -1000, 1, -1, 0, 0]
    bench.cycle()
    assert device.order == DeviceOrder.DRIVE
    assert device.commands.tolist() == [97.6, -186.4, 1.0, -1.0, 0.0, 0.0]


def test_the_first_torques_after_a_hold_go_over_from_those_that_hold_the_arm():  # law 33, R-X04
    device = arm()
    bench = puma(device).on().cycle()
    held = bench.task.module.held("TAU_REF").copy()
    assert abs(held).max() > 1.0  # it hangs in the air
    wanted = held + 0.5 * puma560.TAUMAX
    bench["TAU_REF"] = wanted
    bench.cycle(50)
    assert device.order == DeviceOrder.HOLD  # it may still come nearer
    given = [held]
    for _ in range(12):
        bench.cycle()
        given.append(device.commands)
    steps = abs(np.diff(given, axis=0)) / puma560.TAUMAX
    assert steps.max() <= 0.1 + 1e-9
    assert device.commands == pytest.approx(wanted)


def test_a_jump_that_is_over_before_the_hold_is_none():  # law 33, R-X04
    device = arm()
    bench = puma(device).on().cycle()
    held = bench.task.module.held("TAU_REF").copy()
    bench["TAU_REF"] = held + 2000.0  # as from a speed that was measured over the time in which nobody looked
    bench.cycle(3)
    bench["TAU_REF"] = held + 1.0
    bench.cycle()
    assert device.order == DeviceOrder.DRIVE
    assert device.commands == pytest.approx(held + 1.0)


def test_what_would_tear_it_out_of_a_hold_is_refused():  # law 33, R-X04
    device = arm()
    bench = puma(device).on().cycle()
    bench["TAU_REF"] = [2000.0, 0, 0, 0, 0, 0]
    assert bench.cycle(50).state is State.ON and device.order == DeviceOrder.HOLD
    assert bench.cycle().state is State.ERROR
    assert "TAU_REF[0] would step by 2000 N m: a cycle may change it by 9.76 N m, 0.1 s by 488 N m" in bench.why
    assert device.order == DeviceOrder.HOLD


def test_the_drive_holds_until_torques_come_and_when_the_task_goes_off():  # laws 4 and 12
    device = arm()
    bench = puma(device).on().cycle(3)
    assert device.order == DeviceOrder.HOLD
    bench["TAU_REF"] = bench.task.module.held("TAU_REF") + np.ones(6)
    bench.cycle()
    assert device.order == DeviceOrder.DRIVE
    bench.off()
    assert device.order == DeviceOrder.HOLD


def test_a_torque_that_is_no_number_is_an_error_and_a_hold():  # law 5
    device = arm()
    bench = puma(device).on()
    bench["TAU_REF"] = [np.nan, 0, 0, 0, 0, 0]
    bench.cycle()
    assert "NaN or infinity in TAU_REF" in bench.why
    assert device.order == DeviceOrder.HOLD


def test_a_tripped_drive_is_an_error_that_clear_mends():  # law 17, R-C28
    device = arm()
    bench = puma(device).on()
    device.values[1] = DriveState.TRIPPED
    bench.cycle()
    assert (bench.state, "the drive has tripped" in bench.why) == (State.ERROR, True)
    bench.clear()
    assert device.order == DeviceOrder.CLEAR
    device.values[1] = DriveState.HELD
    assert bench.on().cycle().state is State.ON


def test_a_pressed_panic_button_is_an_error_that_clear_mends_once_it_is_let_go():  # R-K06, §4.5.2
    device = arm()
    bench = puma(device).on()
    device.values[1] = DriveState.PRESSED
    bench.cycle()
    assert (bench.state, "panic button pressed" in bench.why) == (State.ERROR, True)
    bench.clear()
    assert (bench.state, "let it go, then clear" in bench.why) == (State.ERROR, True)
    device.values[1] = DriveState.TRIPPED
    device.publish(0)
    bench.clear()
    assert (bench.state, device.order) == (State.OFF, DeviceOrder.CLEAR)
    device.values[1] = DriveState.HELD
    assert bench.on().cycle().state is State.ON


def test_an_arm_whose_panic_button_is_pressed_does_not_come_on():  # R-K06
    device = arm()
    bench = puma(device)
    device.values[1] = DriveState.PRESSED
    assert "panic button pressed" in bench.on().why


def test_joint_targets_are_judged_joint_by_joint(constants):  # law 26, R-E09
    cls, stated = constants
    targets = [("joint object", [0, 0, 4.1, 0, 0, 0, 1.0]), ("joint object", [*puma560.HOME, 1.0])]
    assert cls.resolve(stated, targets) == ["joint 3 at 4.10 rad is beyond 3.93", None]
    assert cls.resolve(stated, [("joint object", [0.0])]) == ["expected 6 joint values, found 1"]


def test_cartesian_targets_are_judged_by_inverse_kinematics(constants):  # law 26, R-E09
    cls, stated = constants
    near, far = [0, 0, -1, 0, 1, 0, 0.7, 0.28, -0.3346, 1.4], [0, 0, -1, 0, 1, 0, 1.7, 0.28, -0.3346, 1.4]
    crooked = [0, 0, -1, 0, 0, 1, 0.7, 0.28, -0.3346, 1.4]
    reachable, out, askew = cls.resolve(stated, [("cartesian object", pose) for pose in (near, far, crooked)])
    assert reachable is None
    assert out.startswith("out of reach: the wrist would be")
    assert askew == "expected approach and normal square to each other, found a · n = -1"


def test_targets_of_other_types_are_none_of_its_business(constants):
    cls, stated = constants
    assert cls.resolve(stated, [("file name object", ["x"])]) == [None]


def test_constants_may_come_as_plain_lists(constants):
    cls, stated = constants
    plain = {key: value.tolist() if isinstance(value, np.ndarray) else value for key, value in stated.items()}
    assert cls.resolve(plain, [("cartesian object", [0, 0, -1, 0, 1, 0, 0.7, 0, -0.2, 1.0])]) == [None]
