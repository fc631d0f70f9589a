import mujoco
import numpy as np
import pytest

from onika.laws import puma560
from onika.workcell.gripper import CLOSED_M, FORCE_N, TRAVEL_M, GripperPart
from onika.workcell.part import ARMS, WorldPart, document


def _hand():
    hand = GripperPart("hand")
    part = WorldPart(
        bodies=f"<body>{hand.body(ARMS[0], False)}</body>",
        actuators=hand.actuators(),
        equalities=hand.equalities(),
        sensors=hand.sensors(),
    )
    model = mujoco.MjModel.from_xml_string(document("hand", [part]))
    model.opt.gravity[:] = 0.0
    return model, mujoco.MjData(model)


def test_the_hand_weighs_what_the_arm_reckons_with():  # R-K01
    model, data = _hand()
    mujoco.mj_kinematics(model, data)
    mujoco.mj_comPos(model, data)
    assert model.body_mass.sum() == pytest.approx(puma560.LOAD[0])
    assert data.subtree_com[0] == pytest.approx(puma560.LOAD[1:], abs=1e-12)


def test_both_fingers_open_and_close_together_within_four_tenths_of_a_second():
    model, data = _hand()
    for signal, expected in ((1.0, TRAVEL_M), (-1.0, 0.0)):
        data.ctrl[:] = signal
        mujoco.mj_step(model, data, 200)
        assert np.allclose(data.qpos, expected, atol=1e-3)


def test_the_pads_stand_sixty_millimetres_apart_when_closed_and_130_beyond_the_flange():
    model, data = _hand()
    mujoco.mj_kinematics(model, data)
    left, two = (data.geom_xpos[model.geom(f"hand.pad{k}").id] for k in (1, 2))
    thick = 2 * model.geom("hand.pad1").size[1]
    assert left[1] - two[1] - thick == pytest.approx(CLOSED_M)
    assert left[2] == two[2] == pytest.approx(0.130)


def test_a_finger_pushes_with_the_cylinders_force():
    model, data = _hand()
    data.ctrl[:] = data.act[:] = -1.0
    mujoco.mj_step(model, data, 50)
    assert np.allclose(data.actuator_force, -FORCE_N)
