import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from onika.laws import adept_one, puma560
from onika.laws.chain import chain_pose, kinds_of
from onika.laws.frames import dh_transform, rotation_exp
from onika.laws.textbook import frames_at_rest, links_of, load_of, screws_of, serial_arm, tool_of

ROBOTS = [puma560, adept_one]


def product_of_exponentials(screw, q):
    """The pose of what the last joint bears, by Rodrigues' formula alone."""
    pose = np.eye(4)
    for (w, v), value in zip(screw.reshape(-1, 2, 3), q, strict=True):
        turn, place = rotation_exp(w * value), np.cross(w, v)
        step = np.eye(4)
        step[:3, :3], step[:3, 3] = turn, (place - turn @ place if w.any() else v * value)
        pose = pose @ step
    return pose


@pytest.mark.parametrize("robot", ROBOTS)
def test_the_screws_of_a_table_bring_the_tool_to_where_the_table_does(robot):  # R-X19, decision 46
    screw, tool, random = screws_of(robot.DH), tool_of(robot.DH, robot.TOOL), np.random.default_rng(2)
    arm = serial_arm(robot.DH, tool=robot.TOOL)
    for _ in range(500):
        q = random.uniform(robot.QMIN, robot.QMAX)
        expected = chain_pose(robot.DH, kinds_of(robot.DH), q) @ robot.TOOL
        assert np.abs(product_of_exponentials(screw, q) @ tool - expected).max() < 1e-12
        assert np.abs(arm.forward(q) - expected).max() < 1e-12


row = st.tuples(st.floats(-1, 1), st.floats(-3, 3), st.floats(-1, 1), st.floats(-3, 3), st.booleans())


@settings(max_examples=examples(50), deadline=None)
@given(rows=st.lists(row, min_size=1, max_size=8), seed=st.integers(0, 2**32 - 1))
def test_any_table_is_as_good_as_its_screws(rows, seed):  # R-X19
    table, kind = np.array([row[:4] for row in rows]), np.array([float(row[4]) for row in rows])
    q = np.random.default_rng(seed).uniform(-2.0, 2.0, len(rows))
    pose = product_of_exponentials(screws_of(table, kind), q) @ tool_of(table, np.eye(4))
    assert np.abs(pose - chain_pose(table, kind, q)).max() < 1e-12


@pytest.mark.parametrize("robot", ROBOTS)
def test_the_links_of_a_table_weigh_what_its_masses_do_in_their_own_frames(robot):  # R-X19
    arm, random = serial_arm(robot.DH, robot.DYN, robot.LOAD), np.random.default_rng(3)
    for _ in range(20):
        q = random.uniform(robot.QMIN, robot.QMAX)
        assert arm.inertia(q) == pytest.approx(inertia_of_table(robot, q), abs=1e-9)


def inertia_of_table(robot, q):
    """M = sum over bodies of J^T diag(m, I) J, with Jacobians by the geometry of the frames."""
    n, kinds = robot.NDOF, kinds_of(robot.DH)
    frames = [chain_pose(robot.DH[:k], kinds[:k], q[:k]) for k in range(n + 1)]
    bodies = [(frames[k + 1], row[0], row[1:4], np.diag(row[4:7]), k + 1) for k, row in enumerate(robot.DYN)]
    bodies.append((frames[n], robot.LOAD[0], robot.LOAD[1:], np.zeros((3, 3)), n))
    matrix = np.diag(robot.DYN[:, 7])
    for frame, mass, centre, inertia, moved in bodies:
        place, turn = (frame @ [*centre, 1.0])[:3], frame[:3, :3]
        linear, angular = np.zeros((3, n)), np.zeros((3, n))
        for k in range(moved):
            axis = frames[k][:3, 2]
            linear[:, k] = axis if kinds[k] else np.cross(axis, place - frames[k][:3, 3])
            angular[:, k] = 0.0 if kinds[k] else axis
        matrix = matrix + mass * linear.T @ linear + angular.T @ turn @ inertia @ turn.T @ angular
    return matrix


def test_frames_at_rest_are_free_of_the_dust_of_right_angles():
    for robot in ROBOTS:
        poses = frames_at_rest(robot.DH)
        assert len(poses) == robot.NDOF + 1
        assert all(not ((np.abs(pose) > 0.0) & (np.abs(pose) < 1e-12)).any() for pose in poses)
    assert frames_at_rest([[0.3, 0.0, 0.2, 0.5]])[1] == pytest.approx(dh_transform(0.3, 0.0, 0.2, 0.5))


def test_a_load_is_where_the_last_frame_has_it():
    expected = (chain_pose(puma560.DH, np.zeros(6), np.zeros(6)) @ [0.0, 0.0, 0.075, 1.0])[:3]
    assert load_of(puma560.DH, puma560.LOAD) == pytest.approx([0.78, *expected])


def test_armature_and_friction_stay_the_joints_own():
    rows = links_of(puma560.DH, puma560.DYN)
    assert rows[:, 10:12].tolist() == puma560.DYN[:, 7:].tolist() and not rows[:, 12].any()
