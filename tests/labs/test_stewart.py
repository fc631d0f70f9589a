"""The platform on six legs as modules: lengths of a pose, pose of lengths."""

import numpy as np
import pytest

from onika.files import rmod
from onika.laws.frames import rotation_exp, rotation_of_quaternion
from onika.model.lifecycle import State
from onika.ring.device import DeviceOrder
from onika.store.shipped import shipped
from onika.store.site import open_site
from onika.store.world_source import gather_world
from onika.testing.bench import Bench
from onika.workcell.cell.file_world import FileWorld

MODULES = shipped() / "arms" / "module"


def bench_of(task):
    record, _ = rmod.read((MODULES / f"{task}.rmod").read_text(), task, task)
    local = {line.key: line.words for line in record.task.local}
    return Bench(MODULES / f"{task}.py", frequency=500, local=local).init()


def pose_at(t):
    pose = np.eye(4)
    pose[:3, 3] = 0.02 * np.sin(2 * t), 0.02 * np.cos(2 * t) - 0.02, 0.35 + 0.01 * np.sin(3 * t)
    pose[:3, :3] = rotation_exp([0.1 * np.sin(t), 0.05 * np.sin(2 * t), 0.1 * np.sin(t)])
    return pose


def settled():
    """Both modules with the plate where the movement begins."""
    lengths, place = bench_of("stewart_inv"), bench_of("stewart_fwd")
    start = lengths.task.module._platform.lengths(pose_at(0.0)) - 0.35
    lengths["Q_MEZ"] = place["Q_MEZ"] = start
    lengths["X_REF"] = pose_at(0.0)
    return lengths.forget("Q_REF").on(), place.on()


def test_the_plate_is_where_its_legs_were_sent():  # R-K05
    lengths, place = settled()
    before = lengths["Q_REF"]
    for k in range(1, 1000):
        lengths["X_REF"] = pose_at(0.002 * k)
        place["Q_MEZ"] = after = lengths.cycle()["Q_REF"]
        assert np.abs(place.cycle()["PLATE_MEZ"] - pose_at(0.002 * k)).max() < 1e-9
        assert lengths["Q^_REF"] == pytest.approx((after - before) * 500, abs=1e-9)
        before = after


def test_a_first_pose_far_away_is_an_error_and_moves_nothing():  # R-X04
    lengths, _ = settled()
    before = lengths["Q_REF"]
    lengths["X_REF"] = pose_at(1.0)
    lengths.cycle()
    assert lengths.state is State.ERROR and "within 0.500 m/s, found" in lengths.why
    assert np.array_equal(lengths["Q_REF"], before)


def test_a_pose_from_before_the_last_hold_is_not_followed():  # law 3
    lengths = bench_of("stewart_inv")
    lengths["Q_MEZ"], lengths["X_REF"] = np.full(6, 0.01), pose_at(0.5)
    lengths.forget("X_REF").on().cycle(10)
    assert lengths.state is State.ON and lengths["Q_REF"].tolist() == [0.01] * 6


def test_legs_that_no_pose_has_are_an_error_that_clear_mends():
    _, place = settled()
    place["Q_MEZ"] = [0.3, -0.3, 0.3, -0.3, 0.3, -0.3]
    place.cycle()
    assert place.state is State.ERROR and "no pose near the last one has these leg lengths" in place.why
    place["Q_MEZ"] = bench_of("stewart_inv").task.module._platform.lengths(pose_at(0.0)) - 0.35
    assert place.clear().on().cycle().state is State.ON
    assert place["PLATE_MEZ"] == pytest.approx(pose_at(0.0), abs=1e-9)


def test_the_law_of_the_legs_is_that_of_the_shipped_model():  # R-K04
    world = FileWorld(gather_world("stand", open_site((), {}, None))[0])
    assert world.faults == ()
    world.claim("legs_mid", 1)
    lengths = bench_of("stewart_inv").task.module._platform.lengths
    before = np.zeros(6)
    for t in (0.0, 0.4, 1.3):
        wanted = lengths(pose_at(t)) - 0.35
        for share in np.linspace(0.0, 1.0, 200):
            command = [*(before + share * (wanted - before)), *np.zeros(6)]
            world.command("legs_mid", 1, DeviceOrder.DRIVE, command)
            world.step(world.now_ns + 2 * world.step_ns)
        before = wanted
        for _ in range(100):
            world.command("legs_mid", 1, DeviceOrder.DRIVE, [*wanted, *np.zeros(6)])
            world.step(world.now_ns + 2 * world.step_ns)
        plate = world.state("plate_mid")[2:]
        assert plate[:3] == pytest.approx(pose_at(t)[:3, 3], abs=1e-4)
        assert rotation_of_quaternion(plate[3:]) == pytest.approx(pose_at(t)[:3, :3], abs=5e-4)
