import mujoco
import numpy as np

from onika.laws import puma560
from onika.laws.arm import Arm
from onika.workcell.gripper import Gripper
from onika.workcell.layout import base
from onika.workcell.paint import paints
from onika.workcell.part import ARMS, document
from onika.workcell.puma import arm


def _world(side, drawn=False):
    part = arm("arm", base(side), ARMS[0], Gripper("hand"), drawn)
    model = mujoco.MjModel.from_xml_string(document("arm", [paints(), part] if drawn else [part]))
    return model, mujoco.MjData(model)


def test_the_worlds_arm_stands_where_the_laws_say():  # R-K01
    law, random = Arm(puma560.DH, base=base("right"), tool=puma560.TOOL), np.random.default_rng(1)
    for drawn in (False, True):
        model, data = _world("right", drawn)
        hand = model.body("hand.hand").id
        for _ in range(20):
            data.qpos[:6] = random.uniform(puma560.QMIN, puma560.QMAX)
            mujoco.mj_kinematics(model, data)
            tip = data.xpos[hand] + data.xmat[hand].reshape(3, 3) @ puma560.TOOL[:3, 3]
            assert np.allclose(tip, law.forward(data.qpos[:6])[:3, 3], atol=1e-12)


def test_gravity_model_and_world_agree_but_for_the_hands_own_inertia():
    model, data = _world("left")
    law = Arm(puma560.DH, puma560.DYN, puma560.LOAD)
    data.qpos[:6] = 0.3, -0.8, 1.9, 0.4, 0.9, -0.2
    mujoco.mj_fwdPosition(model, data)
    mujoco.mj_fwdVelocity(model, data)
    assert np.allclose(data.qfrc_bias[:6], law.bias(data.qpos[:6], np.zeros(6)), atol=1e-9)


def test_motors_limits_and_friction_are_those_of_the_table():
    model, _ = _world("left")
    assert np.allclose(model.actuator_ctrlrange[:6, 1], puma560.TAUMAX)
    assert np.allclose(model.jnt_range[:6], np.transpose((puma560.QMIN, puma560.QMAX)))
    assert np.allclose(model.dof_armature[:6], puma560.DYN[:, 7])
    assert np.allclose(model.dof_damping[:6], puma560.DYN[:, 8])


def test_a_drawn_arm_has_the_same_bodies_and_joints_in_the_same_order():
    physical, drawn = _world("left")[0], _world("left", drawn=True)[0]
    for model, count in ((physical, physical.nbody), (drawn, physical.nbody)):
        assert [model.body(k).name for k in range(count)] == [physical.body(k).name for k in range(count)]
    assert [physical.joint(k).name for k in range(8)] == [drawn.joint(k).name for k in range(8)]
    assert drawn.nu == 0
