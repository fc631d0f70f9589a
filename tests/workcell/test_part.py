import mujoco
import numpy as np
import pytest

from onika.laws.frames import rotation_of_rpy
from onika.workcell.part import ARMS, STEP_S, THINGS, WorldPart, document, placed


def _meet(first, two):
    return bool(first.kinds & two.meets or two.kinds & first.meets)


def test_arms_touch_things_and_each_other_and_not_themselves():
    left, right = ARMS
    assert _meet(left, THINGS)
    assert _meet(right, THINGS)
    assert _meet(left, right)
    assert _meet(THINGS, THINGS)
    assert not _meet(left, left)
    assert not _meet(right, right)


def test_a_document_of_parts_is_a_world_with_the_settings_that_stack_boxes():
    part = WorldPart(bodies='<body><geom size="0.1"/></body>')
    model = mujoco.MjModel.from_xml_string(document("world", [part, part]))
    assert model.nbody == 3
    assert model.opt.timestep == STEP_S
    assert model.opt.solver == mujoco.mjtSolver.mjSOL_NEWTON
    assert model.opt.integrator == mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    assert model.opt.cone == mujoco.mjtCone.mjCONE_ELLIPTIC
    assert (model.opt.impratio, model.opt.iterations) == (10, 50)


def test_a_pose_is_written_so_that_mujoco_reads_it_back():
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = rotation_of_rpy(0.3, -0.4, 2.0), (0.1, 0.2, 0.3)
    part = WorldPart(bodies=f'<body {placed(pose)}><geom size="0.1"/></body>')
    model = mujoco.MjModel.from_xml_string(document("world", [part]))
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    assert data.xpos[1] == pytest.approx(pose[:3, 3])
    assert np.allclose(data.xmat[1].reshape(3, 3), pose[:3, :3], atol=1e-12)
