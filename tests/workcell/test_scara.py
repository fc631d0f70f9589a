import mujoco
import numpy as np

from onika.workcell.arm import SHOULDER_M, arm
from onika.workcell.gripper import GripperPart
from onika.workcell.layout import base, boxes, text
from onika.workcell.part import ARMS, document
from onika.workcell.plant import Plant
from onika.workcell.scara import SCARA


def _model():
    part = arm(SCARA, "arm", base("left"), ARMS[0], GripperPart("hand"), drawn=False)
    return mujoco.MjModel.from_xml_string(document("arm", [part]))


def test_its_third_joint_slides_and_the_others_turn():  # R-K03
    kinds = [int(_model().joint(f"arm.joint{k}").type[0]) for k in range(1, 5)]
    hinge, slide = mujoco.mjtJoint.mjJNT_HINGE, mujoco.mjtJoint.mjJNT_SLIDE
    assert kinds == [hinge, hinge, slide, hinge]


def test_its_column_stands_on_the_floor():
    model = _model()
    column = model.body("arm.base").geomadr[0]
    assert np.isclose(model.geom_pos[column][2] - model.geom_size[column][1], -SHOULDER_M)


def test_at_home_and_over_the_table_it_touches_nothing():
    plant = Plant(text(boxes(0, 0.0), ("left",), drawn=False, kinds={"left": "scara"}))
    where, _ = plant.joints([f"scara_left.joint{k}" for k in range(1, 5)])
    of_boxes = {plant.model.body(k).id for k in range(plant.model.nbody) if plant.model.body(k).name.startswith("box")}
    for q in (SCARA.robot.HOME, np.array([0.06, 0.68, 0.05, -0.82])):
        plant.data.qpos[where] = q
        plant.settle()
        for pair in plant.data.contact.geom.tolist():
            assert of_boxes & {int(plant.model.geom_bodyid[shape]) for shape in pair}
