"""What is measured, as devices."""

import numpy as np
import pytest

from kit.worlds.file_cells import ARM, CELL, ROBOT, WORLD, files_of
from onika.ring.device import DeviceOrder
from onika.workcell.cell.file_world import FileWorld

SENSING = ARM.replace(
    "</mujoco>", '<sensor><force name="force" site="tip"/><torque name="torque" site="tip"/></sensor></mujoco>'
)
FILES = {
    **CELL,
    "robot/elbow.xml": SENSING,
    "robot/elbow.robot": ROBOT.replace("EOF", "SENSOR wrist\nREADS force torque\nEOF"),
    "world/cell.world": WORLD.replace("EOF", "SENSOR cube_at\nPOSE cube.cube\nEOF"),
}


def faults_with(name, old, new):
    world = FileWorld(files_of({**FILES, name: FILES[name].replace(old, new)}))
    return [(fault.place.file, fault.place.line, fault.reason.key) for fault in world.faults], world


def test_where_a_thing_is_can_be_read():  # R-X19
    world = FileWorld(files_of(FILES))
    sheet = next(sheet for sheet in world.devices() if sheet.name == "cube_at")
    assert (sheet.state[2:], sheet.command) == (("x", "y", "z", "qw", "qx", "qy", "qz"), ())
    assert world.state("cube_at")[2:] == pytest.approx((0.6, -0.9, 0.06, 1.0, 0.0, 0.0, 0.0))
    world._plant.data.joint("cube.free").qpos[:3] = 0.6, -0.9, 0.5
    world.step(100_000_000)
    assert 0.4 < world.state("cube_at")[4] < 0.5


def test_a_wrist_feels_the_weight_that_hangs_there():  # R-X19
    world = FileWorld(files_of(FILES))
    world.claim("elbow_left", 1)
    for _ in range(200):
        world.command("elbow_left", 1, DeviceOrder.DRIVE, [0.2, 0.3, 0.0, 0.0, 0.0, 0.0])
        world.step(world.now_ns + world.step_ns)
    names = next(sheet for sheet in world.devices() if sheet.name == "wrist_left").state[2:]
    assert names == ("force1", "force2", "force3", "torque1", "torque2", "torque3")
    felt = world.state("wrist_left")[2:].copy()
    site = world._plant.model.site("left.tip").bodyid[0]
    borne = world._plant.model.body_subtreemass[site] * 9.81
    world._plant.data.xfrc_applied[site, 2] = -5.0
    for _ in range(300):
        world.command("elbow_left", 1, DeviceOrder.DRIVE, [0.2, 0.3, 0.0, 0.0, 0.0, 0.0])
        world.step(world.now_ns + world.step_ns)
    pressed = world.state("wrist_left")[2:]
    assert np.linalg.norm(felt[:3]) < borne + 1e-6
    assert np.linalg.norm(pressed[:3] - felt[:3]) == pytest.approx(5.0, rel=0.05)


def test_a_sensor_that_is_not_there_is_told_with_its_line_and_left_out():  # R-B07, R-X19
    told, world = faults_with("robot/elbow.robot", "READS force", "READS weight")
    assert told == [("/lab/robot/elbow.robot", 12, "workcell.no_such_name")]
    assert "wrist_left" not in {sheet.name for sheet in world.devices()}
    told, world = faults_with("world/cell.world", "POSE cube.cube", "POSE cube.ball")
    assert told == [("/lab/world/cell.world", 25, "workcell.no_such_name")]
    assert "cube_at" not in {sheet.name for sheet in world.devices()}


def test_what_belongs_to_a_robot_that_is_exchanged_stays_as_it_was():  # R-X19
    files = {
        **FILES,
        "robot/stiff.robot": CELL["robot/stiff.robot"].replace("elbow.xml", "other.xml"),
        "robot/other.xml": ARM.replace('"quill"', '"pin"'),
        "world/cell.world": WORLD.replace("EOF", "SENSOR quill_at\nPOSE left.quill\nEOF"),
    }
    world = FileWorld(files_of(files))
    world.step(20_000_000)
    before = world.state("quill_at")[2:].copy()
    world.claim("stiff_left", 1)
    world.step(100_000_000)
    assert world.state("quill_at")[2:].tolist() == before.tolist()
