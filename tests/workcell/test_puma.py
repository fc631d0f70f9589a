import mujoco

from onika.workcell.arm import arm
from onika.workcell.gripper import GripperPart
from onika.workcell.layout import base
from onika.workcell.part import ARMS, document
from onika.workcell.puma import PUMA


def test_it_turns_in_all_six_joints_and_stands_on_the_floor():  # R-K01
    part = arm(PUMA, "arm", base("left"), ARMS[0], GripperPart("hand"), drawn=False)
    model = mujoco.MjModel.from_xml_string(document("arm", [part]))
    assert [int(model.joint(f"arm.joint{k}").type[0]) for k in range(1, 7)] == [mujoco.mjtJoint.mjJNT_HINGE] * 6


def test_there_is_a_shape_to_touch_and_one_to_look_at_for_each_link():
    assert len(PUMA.touching(ARMS[0])) == len(PUMA.drawn()) == 6
