import mujoco
import numpy as np
import pytest

from onika.workcell.part import document
from onika.workcell.view import CAMERA, LOOK, view


@pytest.mark.parametrize("arms", [0, 1, 2])
def test_the_camera_stands_upright_and_looks_at_the_table(arms):
    model = mujoco.MjModel.from_xml_string(document("view", [view(arms)], LOOK))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    camera = model.camera(CAMERA).id
    right, up, back = data.cam_xmat[camera].reshape(3, 3).T
    assert right[2] == pytest.approx(0.0, abs=1e-12)
    assert up[2] > 0.8
    table = np.array([0.6, 0.0, -0.3]) - data.cam_xpos[camera]
    assert -table @ back / np.linalg.norm(table) > 0.95


def test_two_lights_and_no_body_so_that_poses_keep_their_numbers():
    model = mujoco.MjModel.from_xml_string(document("view", [view(2)], LOOK))
    assert model.nlight == 2
    assert model.nbody == 1
