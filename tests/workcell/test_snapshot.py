import mujoco
import numpy as np
import pytest

from kit.worlds.box_cells import boxes_world
from onika.workcell.snapshot import WorldSnapshot, decode, encode

SNAPSHOT = WorldSnapshot("<mujoco/>", 3.5)


def test_a_snapshot_survives_its_bytes():
    assert decode(encode(SNAPSHOT)) == SNAPSHOT


def test_any_cut_of_its_bytes_is_refused():
    data = encode(SNAPSHOT)
    for length in range(len(data)):
        with pytest.raises(ValueError, match=r".+"):
            decode(data[:length])


def test_scene_poses_and_snapshot_speak_of_the_same_bodies():
    world = boxes_world()
    world.claim("arm_left", 1)
    world.step(20_000_000)
    poses, snapshot = world.poses(), decode(world.snapshot())
    assert poses.dtype == np.float32
    assert poses.shape == (max(shape.body for shape in world.scene()) + 1, 7)
    assert snapshot.time_s == pytest.approx(0.020)
    assert mujoco.MjModel.from_xml_string(snapshot.mjcf).nbody == len(poses)
