"""A world that is files, as its runtime sees it."""

import numpy as np
import pytest

from kit.worlds.file_cells import CELL, changed, files_of
from onika.ring.device import DeviceOrder, DriveState
from onika.runtime.bus import World
from onika.words.cause import by_cause
from onika.workcell.cell.file_world import FileWorld
from onika.workcell.filmed.filmed_world import judged


@pytest.fixture
def world():
    return FileWorld(files_of())


def test_it_is_a_world_with_all_devices_of_all_robots_that_may_stand_there(world):  # R-X19
    assert all(hasattr(world, name) for name in vars(World) if not name.startswith("_"))
    assert [sheet.name for sheet in world.devices()] == [
        "elbow_left",
        "elbow_left_kin",
        "elbow_gripper_left",
        "stiff_left",
        "stiff_left_kin",
        "stiff_gripper_left",
        "elbow_right",
        "elbow_right_kin",
        "gripper_right",
        "lamp",
    ]
    right = next(sheet for sheet in world.devices() if sheet.name == "elbow_right").identity["BASE"]
    assert np.array(right).reshape(4, 4) == pytest.approx(
        np.array([[-1, 0, 0, 2], [0, -1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]), abs=1e-12
    )


def test_the_claim_decides_who_stands_there_and_the_rest_goes_on(world):  # R-X19
    world.claim("elbow_right", 1)
    for _ in range(200):
        world.command("elbow_right", 1, DeviceOrder.DRIVE, [0.5, 0.3, 0.0, 0.0, 0.0, 0.0])
        world.step(world.now_ns + world.step_ns)
    world.claim("stiff_left", 2)
    world.step(world.now_ns + world.step_ns)
    assert world.state("stiff_left")[2:5] == pytest.approx([0.2, 0.3, 0.0], abs=1e-3)
    assert world.state("elbow_right")[2:5] == pytest.approx([0.5, 0.3, 0.0], abs=1e-3)
    with pytest.raises(ValueError, match="a free place"):
        world.claim("elbow_left", 3)


def test_equal_runs_have_equal_fingerprints_and_shaken_ones_others():  # R-X19
    prints = []
    for seed in (None, None, 7):
        world = FileWorld(files_of(), seed)
        world.claim("elbow_left", 1)
        world.command("elbow_left", 1, DeviceOrder.DRIVE, [0.5, 0.3, 0.0, 1.0, 0.0, 0.0])
        world.step(300_000_000)
        prints.append(world.fingerprint())
    assert prints[0] == prints[1] != prints[2]


def test_it_goes_back_to_where_it_stood(world):
    start = world.poses()
    world.claim("elbow_left", 1)
    world.command("elbow_left", 1, DeviceOrder.DRIVE, [1.0, 0.3, 0.0, 0.0, 0.0, 0.0])
    world.step(500_000_000)
    world._plant.data.joint("cube.free").qpos[0] += 0.1
    world.step(510_000_000)
    (cube, arm) = world.displaced()
    assert (str(cube.text), cube.is_harmless) == ("cube is 10.0 cm from its place", False)
    assert (str(arm.text), arm.is_harmless) == ("elbow_left does not stand as it began", True)
    world.reset()
    assert world.displaced() == ()
    assert world.poses() == pytest.approx(start, abs=1e-5)
    assert "cube stands at x = 60.0 cm" in str(world.places()[0])


def test_a_panic_button_stops_the_robots_of_its_places(world):
    world.claim("elbow_left", 1)
    world.command("elbow_left", 1, DeviceOrder.DRIVE, [0.2, 0.3, 0.0, 0.0, 0.0, 0.0])
    assert world.pressed == ()
    world.touch("panic", 1.0)
    assert world.pressed == ("panic",)
    assert world.state("elbow_left")[1] == world.state("elbow_right")[1] == DriveState.PRESSED
    world.stop()
    world.go_on()
    assert world.state("elbow_left")[1] == DriveState.PRESSED
    world.touch("panic", 0.0)
    assert world.pressed == ()


def test_stopped_it_hears_nothing(world):
    world.claim("elbow_left", 1)
    world.stop()
    world.command("elbow_left", 1, DeviceOrder.DRIVE, [1.0, 0.3, 0.0, 0.0, 0.0, 0.0])
    world.step(500_000_000)
    assert world.state("elbow_left")[2] == pytest.approx(0.2, abs=1e-6)


@pytest.mark.parametrize("name", ["world/cell.world", "robot/elbow.robot"])
def test_a_world_broken_at_any_line_says_so_or_is_a_world(name):  # R-B07, R-X19
    lines = CELL[name].splitlines()
    for at in range(len(lines)):
        broken = "\n".join([*lines[:at], "?? garbled", *lines[at + 1 :]])
        faults = judged(files_of({**CELL, name: broken + "\n"}))
        assert any(fault.place.file == f"/lab/{name}" for fault in faults), lines[at]
        assert all(fault.place.line for fault in faults if fault.place.file == f"/lab/{name}")


def test_a_world_without_fault_says_nothing():
    assert judged(files_of()) == ()
    faults = judged(changed("world/cube.xml", "<body", "<bodi"))
    assert [str(fault.place) for fault in faults] == [
        "/lab/world/cube.xml:1",
        "/lab/world/cell.world:18",
        "/lab/world/cell.world:20",
    ]
    assert [len(cause.consequences) for cause in by_cause(faults)] == [2]
    assert str(faults[0].instead) == "the part cube is left out"


def test_frame_0_of_a_chain_that_nothing_bears_is_its_place():  # R-X19
    rail = '<mujoco><worldbody><body name="car"><joint name="x" type="slide" axis="1 0 0" range="-1 1"/>'
    rail += '<geom size="0.1"/></body></worldbody></mujoco>'
    robot = "VERSION 2.0\nFILE rail.xml\nARM arm\nTOOL car\nEOF\n"
    world = FileWorld(files_of({**CELL, "robot/stiff.robot": robot, "robot/rail.xml": rail}))
    sheet = next(sheet for sheet in world.devices() if sheet.name == "stiff_left")
    assert sheet.identity["BASE"] == tuple(np.eye(4).ravel())
    world.claim("stiff_left", 1)
    assert world.state("stiff_left")[2] == 0.0


def test_physics_that_becomes_unstable_is_told_and_leaves_no_file_behind(world, tmp_path, monkeypatch):  # R-X19
    monkeypatch.chdir(tmp_path)
    world._plant.data.qvel[0] = 1e30
    world.step(10_000_000)
    assert "became unstable" in str(world.standing()[0])
    assert list(tmp_path.iterdir()) == []
