"""Modules that are any arm: they take everything that they publish from what their device says of itself."""

import numpy as np
import pytest

from kit.worlds.mjcf_arms import ARMS
from onika.host.loading.module_facts import ModuleFacts
from onika.laws.frames import nine_of_pose
from onika.model.lifecycle import State
from onika.ring.device import DeviceOrder, DriveState
from onika.store.shipped import shipped
from onika.testing.bench import Bench
from onika.testing.bench_device import BenchDevice

MODULES = shipped() / "arms" / "module"
GENERIC = shipped() / "generic" / "module"
DRIVES = {"arm_pos": "position", "arm_vel": "velocity", "arm_tau": "torque"}


def device_of(arm, drive, identity=None):
    n = arm.n
    taken = {"position": 2 * n, "velocity": n, "torque": n}[drive]
    said = arm.identity(drive) if identity is None else identity
    return BenchDevice([f"s{k}" for k in range(3 * n)], [f"c{k}" for k in range(taken)], said)


def bench_of(task, arm, **other):
    device = device_of(arm, DRIVES.get(task, "position"), **other)
    return Bench(MODULES / f"{task}.py", frequency=500, device=device).init(), device


@pytest.mark.parametrize("name", sorted(ARMS))
@pytest.mark.parametrize("task", sorted(DRIVES))
def test_it_publishes_what_the_device_says_of_any_arm(task, name):  # R-X19, R-K03, decision 5
    arm = ARMS[name]
    bench, device = bench_of(task, arm)
    assert bench.state is State.OFF, bench.why
    assert (bench["NDOF"], bench["ROBOT"]) == (arm.n, "small")
    for constant in ("SCREW", "LINK", "PARENT", "TOOL", "BASE", "QMIN", "QMAX", "Q^_MAX", "TAUMAX", "HOME"):
        assert np.array_equal(bench[constant], arm.constants[constant])
    device.state[:] = np.arange(3 * arm.n)
    bench.on()
    assert bench["Q_MEZ"].tolist() == list(range(arm.n))
    assert bench["Q^_MEZ"].tolist() == list(range(arm.n, 2 * arm.n))
    assert bench["TAU_MEZ"].tolist() == list(range(2 * arm.n, 3 * arm.n))


def test_positions_and_speeds_go_to_the_drives_within_their_limits():  # R-X19
    bench, device = bench_of("arm_pos", ARMS["five"])
    device.state[:5] = 0.1
    bench.on()
    assert bench.cycle().state is State.ON and device.order == DeviceOrder.HOLD
    bench["Q_REF"], bench["Q^_REF"] = np.full(5, 0.1), np.zeros(5)
    bench.cycle()
    assert (device.order, device.commands.tolist()) == (DeviceOrder.DRIVE, [0.1] * 5 + [0.0] * 5)
    bench.task.input_guard.transfer.channels = ()  # what follows is no switch
    bench["Q_REF"], bench["Q^_REF"] = np.full(5, 9.0), np.full(5, -9.0)
    assert bench.cycle().state is State.ON
    assert device.commands.tolist() == [2.6] * 5 + [-2.0] * 5


def test_a_first_position_far_from_where_the_arm_stands_is_refused():  # law 33, R-X04
    bench, device = bench_of("arm_pos", ARMS["five"])
    bench.on().cycle()
    bench["Q_REF"], bench["Q^_REF"] = np.full(5, 1.0), np.zeros(5)
    bench.cycle(60)
    assert bench.state is State.ERROR and "Q_REF[0] would step by 1 rad" in bench.why
    assert device.order == DeviceOrder.HOLD


def test_speeds_go_to_the_drives():
    bench, device = bench_of("arm_vel", ARMS["five"])
    bench.on().cycle()
    for speed in np.linspace(0.0, 0.5, 6):
        bench["Q^_REF"] = np.full(5, speed)
        bench.cycle()
    assert (device.order, device.commands.tolist()) == (DeviceOrder.DRIVE, pytest.approx([0.5] * 5))


def test_torques_begin_at_those_that_bear_the_arm():  # law 33
    arm = ARMS["seven"]
    bench, device = bench_of("arm_tau", arm)
    q = np.linspace(0.2, 0.9, 7)
    device.state[:7] = q
    bench.on().cycle()
    held = bench.task.module.held("TAU_REF").copy()
    assert held == pytest.approx(arm.data_at(q).qfrc_bias, abs=1e-9)
    bench["TAU_REF"] = held
    bench.cycle()
    assert device.order == DeviceOrder.DRIVE and device.commands == pytest.approx(held)


@pytest.mark.parametrize("task", sorted(DRIVES))
def test_a_device_that_is_driven_otherwise_is_not_driven(task):
    other = "velocity" if task != "arm_vel" else "torque"
    bench, device = bench_of(task, ARMS["five"], identity=ARMS["five"].identity(other))
    assert bench.state is State.ERROR and device.order == DeviceOrder.HOLD
    assert f"expected a device that is driven by {DRIVES[task]}, found one driven by {other}" in bench.why


def test_a_tripped_drive_is_an_error_that_clear_mends():  # law 17, R-C28
    bench, device = bench_of("arm_pos", ARMS["five"])
    bench.on()
    device.values[1] = DriveState.TRIPPED
    bench.cycle()
    assert (bench.state, "the drive has tripped" in bench.why) == (State.ERROR, True)
    bench.clear()
    assert device.order == DeviceOrder.CLEAR


def test_a_device_that_says_too_little_is_told_before_anything_lives():  # R-X19
    said = {name: value for name, value in ARMS["five"].identity("position").items() if name != "LINK"}
    with pytest.raises(ValueError, match="expected the arm behind the device to say its LINK"):
        bench_of("arm_pos", ARMS["five"], identity=said)


def test_axes_publish_their_limits_and_take_joint_targets_within_them():  # R-X19
    said = {"DRIVE": "position", "QMIN": (0.0, 0.0), "QMAX": (1.0, 0.05), "Q^_MAX": (1.0, 1.0), "HOME": (0.0, 0.0)}
    device = BenchDevice([f"s{k}" for k in range(6)], [f"c{k}" for k in range(4)], said)
    bench = Bench(MODULES / "axes.py", frequency=500, device=device).init()
    assert bench["NDOF"] == 2 and bench["QMAX"].tolist() == [1.0, 0.05]
    bench.on().cycle()
    bench["Q_REF"], bench["Q^_REF"] = [0.001, 0.0], [0.0, 0.1]
    bench.cycle()
    assert device.commands.tolist() == [0.001, 0.0, 0.0, 0.1]
    constants = bench.cls.constants(None, said)
    targets = [("joint object", [0.5, 0.01, 1.0]), ("joint object", [0.5, 0.06]), ("pause object", [1.0])]
    assert bench.cls.resolve(constants, targets) == [None, "joint 2 at 0.06 rad is beyond 0.05", None]


@pytest.mark.parametrize("name", sorted(ARMS))
def test_an_arm_without_forces_takes_its_constants_from_its_device_too(name):  # R-K03
    arm = ARMS[name]
    device = BenchDevice([f"q{k}" for k in range(arm.n)], [f"r{k}" for k in range(arm.n)], arm.identity("posture"))
    bench = Bench(GENERIC / "arm_kin.py", frequency=500, device=device).init()
    assert bench.state is State.OFF, bench.why
    assert np.array_equal(bench["SCREW"], arm.constants["SCREW"]) and bench["KP"].tolist() == [0.0] * arm.n


# What they reach


@pytest.fixture(params=["seven", "six"])
def reaching(request):
    arm = ARMS[request.param]
    cls = bench_of("arm_pos", arm)[0].cls
    return arm, cls, cls.constants(None, arm.identity("position"))


def test_poses_of_postures_are_within_reach_and_far_ones_are_not(reaching):  # R-E09, law 26
    arm, cls, constants = reaching
    random = np.random.default_rng(8)
    postures = random.uniform(-1.5, 1.5, (10, arm.n))
    near = [("cartesian object", [*nine_of_pose(arm.pose(q)), 1.0]) for q in postures]
    assert cls.resolve(constants, near) == [None] * 10
    far = [("cartesian object", [*target[:6], 4.0 + target[6], *target[7:]]) for _, target in near]
    assert all(reason.startswith("out of reach: the nearest posture") for reason in cls.resolve(constants, far))


def test_the_postures_of_poses_bring_the_tool_there_within_limits(reaching):  # R-E09
    arm, cls, constants = reaching
    poses = [arm.pose(q) for q in np.random.default_rng(9).uniform(-1.5, 1.5, (30, arm.n))]
    for pose, posture in zip(poses, cls.postures(constants, [nine_of_pose(pose) for pose in poses]), strict=True):
        assert np.abs(arm.pose(posture) - pose).max() < 1e-7
        assert (posture >= constants["QMIN"]).all() and (posture <= constants["QMAX"]).all()


def test_a_redundant_arm_keeps_its_posture_from_pose_to_pose():  # R-X19
    arm = ARMS["seven"]
    cls = bench_of("arm_pos", arm)[0].cls
    constants = cls.constants(None, arm.identity("position"))
    pose = arm.pose(np.array([0.3, 0.5, -0.2, 0.9, 0.3, 0.6, 0.1]))
    line = [pose + np.array([[0, 0, 0, 0], [0, 0, 0, 0.001 * k], [0, 0, 0, 0], [0, 0, 0, 0]]) for k in range(30)]
    postures = cls.postures(constants, [nine_of_pose(pose) for pose in line])
    assert np.abs(np.diff(postures, axis=0)).max() < 0.05
    there = cls.postures(constants, [nine_of_pose(pose) for pose in (*line, *line[::-1])])
    assert there[-1] == pytest.approx(there[0], abs=0.02)


def test_joint_targets_beyond_limits_are_told_with_their_unit():
    arm = ARMS["gantry"]
    cls = bench_of("arm_pos", arm)[0].cls
    constants = cls.constants(None, arm.identity("position"))
    targets = [("joint object", q) for q in ([0.6, 0.0, 0.1, 0.0], [0.1, 0.0, 0.1, 3.0], [0.1, 0.1, 0.1, 0.1])]
    assert cls.resolve(constants, targets) == [
        "joint 1 at 0.600 m is beyond 0.500",
        "joint 4 at 3.00 rad is beyond 2.60",
        None,
    ]


def test_joints_without_limits_are_never_beyond_them():  # R-X19
    arm = ARMS["five"]
    said = arm.identity("position") | {"QMIN": (-np.inf,) * 5, "QMAX": (np.inf,) * 5}
    cls = bench_of("arm_pos", arm)[0].cls
    constants = cls.constants(None, said)
    pose = nine_of_pose(arm.pose(np.array([3.0, 0.3, -0.5, 0.4, 9.0])))
    assert cls.resolve(constants, [("joint object", [50.0] * 5), ("cartesian object", [*pose, 1.0])]) == [None, None]


def test_the_loader_asks_the_device_before_anything_lives(monkeypatch):  # decision 5, law 26
    arm = ARMS["seven"]
    facts = ModuleFacts()
    monkeypatch.setattr(facts, "_identity", {"cell:arm": arm.identity("torque")}.get)
    source = (MODULES / "arm_tau.py").read_text()
    from onika.wire.plan import Code

    code = Code("digest", "arm_tau", str(MODULES / "arm_tau.py"), source)
    constants = facts.constants(code, (("DEVICE", ("cell:arm",)),))
    assert constants["NDOF"] == 7 and constants["SCREW"] == arm.constants["SCREW"].tolist()
    absent = facts.constants(code, (("DEVICE", ("cell:other",)),))
    assert "expected an arm behind the device, found another device" in str(absent.reason)


def test_without_forces_an_arm_is_where_its_reference_says():  # R-X19, R-K03
    arm = ARMS["five"]
    device = BenchDevice([f"s{k}" for k in range(5)], [f"c{k}" for k in range(5)], arm.identity("position"))
    bench = Bench(MODULES / "arm_sim.py", frequency=500, device=device).init()
    assert (bench.state, bench["NDOF"]) == (State.OFF, 5)
    device.state[:] = 0.1
    bench.on()
    bench["Q_REF"] = np.full(5, 0.102)
    bench.cycle()
    assert (device.order, device.commands.tolist()) == (DeviceOrder.DRIVE, [0.102] * 5)
    device.state[:] = 0.102
    bench.cycle()
    assert bench["Q^_MEZ"] == pytest.approx(np.ones(5)) and bench["TAU_MEZ"].tolist() == [0.0] * 5


def test_an_arm_with_forces_is_no_arm_without_them():  # R-X04
    device = device_of(ARMS["five"], "position")
    bench = Bench(MODULES / "arm_sim.py", frequency=500, device=device).init()
    assert bench.state is State.ERROR
    assert "publishes and takes 5 numbers, found one that publishes 15 and takes 10" in bench.why
