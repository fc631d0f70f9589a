import numpy as np
import pytest

from onika.laws.frames import nine_of_pose, pose_of_nine
from onika.model.pose_numbers import aimed, nine_of

HERE = (0.1, 0.2, 0.3)


def test_a_frame_has_the_nine_numbers_of_the_target_that_leads_to_it():  # reading 44, R-D13
    pose = pose_of_nine([0.0, 0.0, -1.0, 0.6, 0.8, 0.0, 0.1, 0.2, 0.3])
    assert np.allclose(nine_of(pose.tolist()), nine_of_pose(pose))
    assert np.allclose(pose_of_nine(list(nine_of(pose.tolist()))), pose)


@pytest.mark.parametrize("approach", [(0.0, 0.0, -2.0), (0.3, -0.4, 0.5), (1.0, 0.0, 0.0)])
def test_poses_that_aim_share_place_and_approach_and_are_turned_about_it_all_the_way_round(approach):  # R-D25
    poses = aimed(HERE, approach, (1.0, 0.0, 0.0))
    along = np.array(approach) / np.linalg.norm(approach)
    frames = [pose_of_nine(pose) for pose in poses]  # raises where one is no pose
    for frame in frames:
        assert np.allclose(frame[:3, 2], along) and np.allclose(frame[:3, 3], HERE)
    turns = sorted(np.arccos(np.clip([frame[:3, 0] @ frames[0][:3, 0] for frame in frames], -1, 1)))
    assert np.allclose(turns, sorted(np.deg2rad([0, 30, 30, 60, 60, 90, 90, 120, 120, 150, 150, 180])), atol=1e-6)


def test_the_turn_nearest_to_the_one_wished_for_comes_first_and_its_opposite_last():  # R-D25
    poses = aimed(HERE, (0.0, 0.0, -1.0), (0.0, 3.0, 1.0))
    assert np.allclose(poses[0], (0, 0, -1, 0, 1, 0, *HERE))
    assert np.allclose(poses[-1], (0, 0, -1, 0, -1, 0, *HERE))


def test_a_direction_of_no_length_aims_at_nothing():  # R-D25
    with pytest.raises(ValueError, match="no length"):
        aimed(HERE, (0.0, 0.0, 0.0), (1.0, 0.0, 0.0))
