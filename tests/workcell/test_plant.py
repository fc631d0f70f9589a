import numpy as np
import pytest

from kit.worlds.box_cells import boxes_world

SIDES = ("left", "right")


def _plant(*sides):
    world = boxes_world()
    for side in sides:
        world.claim(f"arm_{side}", 1)
    return world._plant


def _row(plant, side):
    where, rate = plant.joints([f"{side}.joint{k}" for k in range(1, 7)])
    return plant.data.qpos[where], plant.data.qvel[rate]


def test_names_find_neighbouring_numbers():
    plant = _plant("left")
    q, _ = _row(plant, "left")
    q[:] = np.arange(6.0)
    assert [plant.data.joint(f"left.joint{k}").qpos[0] for k in range(1, 7)] == list(range(6))
    assert plant.signals(["left.hand.valve1", "left.hand.valve2"]) == slice(6, 8)


def test_an_unknown_name_is_a_key_error():
    with pytest.raises(KeyError, match="no_such_body"):
        _plant().body("no_such_body")


def test_state_is_taken_over_by_name_whatever_stands_before_it():  # law 18
    before, after = _plant("right"), _plant(*SIDES)
    random = np.random.default_rng(4)
    before.data.qpos[:], before.data.qvel[:] = random.random(before.model.nq), random.random(before.model.nv)
    before.data.ctrl[:], before.data.act[:] = random.random(before.model.nu), random.random(before.model.na)
    untouched = [row.copy() for row in _row(after, "left")]
    after.take(before)
    for mine, theirs in zip(_row(after, "right"), _row(before, "right"), strict=True):
        assert np.array_equal(mine, theirs)
    for mine, was in zip(_row(after, "left"), untouched, strict=True):
        assert np.array_equal(mine, was)
    assert np.array_equal(after.data.joint("box_square.free").qpos, before.data.joint("box_square.free").qpos)
    assert np.array_equal(after.data.ctrl[8:], before.data.ctrl)
    assert np.array_equal(after.data.act[2:], before.data.act)


def test_touch_is_felt_when_asked_for():
    import mujoco

    plant = _plant("left")
    mujoco.mj_step(plant.model, plant.data, 5)
    assert not plant.data.sensordata.any()
    plant.data.sensordata[:] = 9.0
    plant.sense()
    assert not plant.data.sensordata.any()  # nothing stands on a patch, nothing is held


def test_poses_of_settled_boxes_are_where_they_were_put():
    plant = _plant()
    plant.settle()
    poses = plant.poses()
    assert poses.dtype == np.float32
    assert poses.shape == (5, 7)
    assert np.allclose(poses[1, :2], plant.data.qpos[:2], atol=1e-6)
    assert np.allclose(poses[1, 3:], (1, 0, 0, 0))


def test_what_rubs_and_what_weighs_is_otherwise_once_and_only_what_is_free_weighs_more():  # R-X23
    plain, other = _plant("left"), _plant("left")
    for _ in range(2):
        other.vary({"friction": 0.5, "mass": 3.0})
    assert other.model.geom_friction[:, 0] == pytest.approx(0.5 * plain.model.geom_friction[:, 0])
    assert other.model.geom_friction[:, 1:] == pytest.approx(plain.model.geom_friction[:, 1:])
    ratio = np.divide(
        other.model.body_mass, plain.model.body_mass, where=plain.model.body_mass > 0, out=np.ones(plain.model.nbody)
    )
    for body in range(plain.model.nbody):
        is_box = plain.model.body(body).name.startswith("box")
        if plain.model.body_mass[body] > 0:
            assert ratio[body] == pytest.approx(3.0 if is_box else 1.0), plain.model.body(body).name
    assert other.model.body_inertia[other.body("box_waves.box")] == pytest.approx(
        3.0 * plain.model.body_inertia[plain.body("box_waves.box")]
    )
    assert other.model.body_subtreemass[0] > plain.model.body_subtreemass[0]


def test_where_nothing_is_varied_nothing_changes():  # R-X08
    plain, other = _plant("left"), _plant("left")
    other.vary({})
    assert np.array_equal(plain.model.geom_friction, other.model.geom_friction)
    assert np.array_equal(plain.model.body_mass, other.model.body_mass)
