import numpy as np

from onika.laws.frames import nine_of_pose, pose_of_nine
from onika.model.pose_numbers import nine_of


def test_a_frame_has_the_nine_numbers_of_the_target_that_leads_to_it():  # reading 44, R-D13
    pose = pose_of_nine([0.0, 0.0, -1.0, 0.6, 0.8, 0.0, 0.1, 0.2, 0.3])
    assert np.allclose(nine_of(pose.tolist()), nine_of_pose(pose))
    assert np.allclose(pose_of_nine(list(nine_of(pose.tolist()))), pose)
