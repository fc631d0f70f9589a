import mujoco
import numpy as np
import pytest

from onika.laws.textbook import serial_arm
from onika.workcell.arm import arm
from onika.workcell.gripper import GripperPart
from onika.workcell.layout import KINDS, base
from onika.workcell.paint import paints
from onika.workcell.part import ARMS, document

every_kind = pytest.mark.parametrize("kind", KINDS.values(), ids=KINDS)


def _world(kind, side="left", drawn=False):
    part = arm(kind, "arm", base(side), ARMS[0], GripperPart("hand"), drawn)
    model = mujoco.MjModel.from_xml_string(document("arm", [paints(), part] if drawn else [part]))
    return model, mujoco.MjData(model)


@every_kind
def test_the_worlds_arm_stands_where_the_laws_say(kind):  # R-K01, R-K03
    robot = kind.robot
    law, random = serial_arm(robot.DH, base=base("right"), tool=robot.TOOL), np.random.default_rng(1)
    for drawn in (False, True):
        model, data = _world(kind, "right", drawn)
        hand = model.body("hand.hand").id
        for _ in range(20):
            q = data.qpos[: robot.NDOF] = random.uniform(robot.QMIN, robot.QMAX)
            mujoco.mj_kinematics(model, data)
            tip = data.xpos[hand] + data.xmat[hand].reshape(3, 3) @ robot.TOOL[:3, 3]
            assert np.allclose(tip, law.forward(q)[:3, 3], atol=1e-12)


@every_kind
def test_gravity_model_and_world_agree_but_for_the_hands_own_inertia(kind):
    model, data = _world(kind)
    robot = kind.robot
    law = serial_arm(robot.DH, robot.DYN, robot.LOAD)
    q = data.qpos[: robot.NDOF] = 0.7 * robot.QMIN + 0.3 * robot.QMAX
    mujoco.mj_fwdPosition(model, data)
    mujoco.mj_fwdVelocity(model, data)
    assert np.allclose(data.qfrc_bias[: robot.NDOF], law.bias(q, np.zeros(robot.NDOF)), atol=1e-9)


@every_kind
def test_motors_limits_and_friction_are_those_of_the_table(kind):
    model, _ = _world(kind)
    robot, n = kind.robot, kind.robot.NDOF
    assert np.allclose(model.actuator_ctrlrange[:n, 1], robot.TAUMAX)
    assert np.allclose(model.jnt_range[:n], np.transpose((robot.QMIN, robot.QMAX)))
    assert np.allclose(model.dof_armature[:n], robot.DYN[:, 7])
    assert np.allclose(model.dof_damping[:n], robot.DYN[:, 8])


@every_kind
def test_a_drawn_arm_has_the_same_bodies_and_joints_in_the_same_order(kind):
    physical, drawn = _world(kind)[0], _world(kind, drawn=True)[0]
    assert [drawn.body(k).name for k in range(drawn.nbody)] == [physical.body(k).name for k in range(physical.nbody)]
    assert [drawn.joint(k).name for k in range(drawn.njnt)] == [physical.joint(k).name for k in range(physical.njnt)]
    assert drawn.nu == 0
