"""A robot compiled by itself."""

import mujoco
import pytest

from kit.worlds.file_cells import ARM, CELL, changed, files_of
from kit.worlds.robot_models import HOIST, PLAIN
from onika.model.robot import RobotGripper, RobotText
from onika.wire.world_source import WorldFile, WorldSource
from onika.workcell.composed.robot_model import compiled, held_by_mocap, robot_model, robot_spec
from onika.workcell.composed.sources import SourceTexts

URDF = """<robot name="two">
<link name="base"><collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision></link>
<link name="arm"><inertial><mass value="1"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
<collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision></link>
<joint name="hinge" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="5" velocity="1.25"/></joint></robot>"""


def facts_of(files, name="elbow"):
    faults = []
    texts = SourceTexts(files)
    return robot_model(texts, texts.robots[name], faults), faults


def test_devices_that_can_be_used_are_known_and_the_others_told():  # R-X19
    robot, faults = facts_of(changed("robot/elbow.robot", "MOVES squeeze", "MOVES hold"))
    assert [facts.name for facts in robot.joints] == ["arm"]
    assert robot.grippers == ()
    assert [(str(fault.place), str(fault.instead)) for fault in faults] == [
        ("/lab/robot/elbow.robot:8", "gripper is left out")
    ]


def test_a_description_without_actuators_gets_a_motor_at_each_joint():  # R-X19
    text = "VERSION 2.0\nFILE two.urdf\nARM arm\nTOOL arm\nEOF\n"
    robot, faults = facts_of(files_of({**CELL, "robot/elbow.robot": text, "robot/two.urdf": URDF}))
    assert faults == []
    (arm,) = robot.joints
    assert (arm.joints, arm.speed.tolist(), arm.torque.tolist()) == (("hinge",), [1.25], [5.0])


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        ('range="-3 3"', 'range="3 -3"', "workcell.limit_reversed"),
        ('joint="bend"', 'joint="knee"', "workcell.model_unsound"),
        ("</worldbody>", "", "workcell.model_unreadable"),
        ('name="tip" pos="0 0 -0.1"', 'name="tip" pos="nan 0 -0.1"', "workcell.place_no_number"),
        ('name="tip" pos="0 0 -0.1"', 'name="tip" pos="0 0 1e300"', "workcell.place_no_number"),
    ],
)
def test_a_model_that_cannot_be_compiled_leaves_its_robot_out_and_its_line_is_told(old, new, why):  # R-B07, R-X19
    robot, (fault,) = facts_of(changed("robot/elbow.xml", old, new))
    assert robot is None
    assert (fault.reason.key, str(fault.instead)) == (why, "the robot elbow is left out")
    assert fault.place.file.endswith("elbow.xml")
    if new:
        assert (
            new
            in changed("robot/elbow.xml", old, new)
            .find("robot/elbow.xml")
            .content.decode()
            .split("\n")[fault.place.line - 1]
        )


def test_a_model_of_which_no_line_is_known_is_told_where_it_is_named():  # R-B07, R-X19
    robot, (fault,) = facts_of(files_of({**CELL, "robot/elbow.xml": "<body/>"}))
    assert robot is None
    assert (fault.place.file.endswith("elbow.robot"), fault.place.line) == (True, 2)


def test_what_is_wrong_with_a_link_is_told_in_the_file_of_the_link():  # R-B07, R-X19
    link = '<mujoco><worldbody><body name="link">\n<joint name="turn" range="1 -1"/></body></worldbody></mujoco>'
    text = "VERSION 2.0\nFILE elbow.xml\nLINKS link.xml\nON tip\nARM arm\nTOOL tip\nEOF\n"
    _, (fault,) = facts_of(files_of({**CELL, "robot/elbow.robot": text, "robot/link.xml": link}))
    assert (fault.reason.key, fault.place.line) == ("workcell.limit_reversed", 2)
    assert fault.place.file.endswith("link.xml")


def test_a_hand_is_attached_at_its_site():  # R-X19
    hand = '<mujoco><worldbody><body><geom name="palm" size="0.01"/></body></worldbody></mujoco>'
    text = "VERSION 2.0\nFILE elbow.xml\nHAND palm.xml\nON tip\nARM arm\nTOOL tip\nEOF\n"
    files = files_of({**CELL, "robot/elbow.robot": text, "robot/palm.xml": hand})
    texts = SourceTexts(files)
    assert robot_spec(texts, texts.robots["elbow"]).compile().geom("hand.palm").id > 0
    astray = text.replace("ON tip", "ON top")
    lost, (fault,) = facts_of(files_of({**CELL, "robot/elbow.robot": astray, "robot/palm.xml": hand}))
    assert lost is None
    assert fault.reason.key == "workcell.no_such_name"


def test_a_link_and_what_bears_it_do_not_hinder_each_other():
    robot, _ = facts_of(files_of({**CELL, "robot/elbow.xml": ARM}))
    assert ("foot", "upper") in robot.excluded


def test_links_are_attached_to_each_other_and_joints_keep_their_names():  # R-K04
    link = """<mujoco><worldbody><body name="link"><joint name="turn" axis="0 0 1" range="-1 1"/>
<geom name="tube" size="0.02" fromto="0 0 0 0 0 0.3" type="capsule"/>
<site name="tip" pos="0 0 0.3"/></body></worldbody></mujoco>"""
    foot = '<mujoco><worldbody><site name="tip" pos="0 0 0.1"/></worldbody></mujoco>'
    text = "VERSION 2.0\nFILE foot.xml\nLINKS link.xml link.xml\nON tip\nARM arm\nTOOL 2.tip\nEOF\n"
    files = {**CELL, "robot/elbow.robot": text, "robot/link.xml": link, "robot/foot.xml": foot}
    robot, faults = facts_of(files_of(files))
    assert faults == []
    (arm,) = robot.joints
    assert arm.joints == ("1.turn", "2.turn")
    assert arm.constants["TOOL"][3::4][:3] == pytest.approx((0.0, 0.0, 0.7))
    robot, (fault,) = facts_of(files_of({**files, "robot/foot.xml": foot.replace("tip", "end")}))
    assert (robot, fault.reason.key, fault.place.line) == (None, "workcell.no_such_name", 4)


def test_a_robot_is_not_held_by_a_hand_of_the_simulator():  # R-X19
    led = '<body name="lead" mocap="true"/><body name="foot">'
    weld = '<equality><weld name="w" body1="lead" body2="quill"/>'
    model = ARM.replace('<body name="foot">', led, 1).replace("<equality>", weld, 1)
    sources = SourceTexts(files_of({**CELL, "robot/elbow.xml": model}))
    assert list(held_by_mocap(sources.model("robot/elbow.xml"))) == ["quill"]
    spec = robot_spec(sources, sources.robots["elbow"])
    assert [equality.name for equality in spec.equalities] == [""]
    assert list(held_by_mocap(spec)) == []


def test_a_motor_that_is_added_is_one_whatever_the_model_says_of_its_own_servos():  # R-X19
    text = PLAIN.replace("<worldbody>", '<default><position kp="80" ctrlrange="-1 1"/></default><worldbody>')
    files = WorldSource("new", "", (WorldFile("robot/new.xml", "/lab/new.xml", text.encode()),))
    model = compiled(robot_spec(SourceTexts(files), RobotText("new", "new.xml")))
    assert model.nu == 2
    assert not model.actuator_biasprm.any() and (model.actuator_gainprm[:, 0] == 1.0).all()
    assert not model.actuator_ctrllimited.any()


def test_a_light_finger_of_a_urdf_feels_a_gear_behind_its_motor_and_the_arm_does_not():  # R-X19
    jaw = URDF.replace("</robot>", """<link name="jaw"><inertial><mass value="0.01"/>
<inertia ixx="1e-5" iyy="1e-5" izz="1e-5" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="bite" type="revolute"><parent link="arm"/><child link="jaw"/><axis xyz="0 1 0"/>
<limit lower="-0.2" upper="1.7" effort="12" velocity="1"/></joint></robot>""")  # fmt: skip
    files = WorldSource("new", "", (WorldFile("robot/new.urdf", "/lab/new.urdf", jaw.encode()),))
    gripper = RobotGripper("gripper", ("bite",), (12.0, 0.05), (-12.0, 0.0))
    model = compiled(robot_spec(SourceTexts(files), RobotText("new", "new.urdf", devices=(gripper,))))
    assert [float(model.dof_armature[model.joint(name).dofadr[0]]) for name in ("hinge", "bite")] == [0.0, 0.02]
    data = mujoco.MjData(model)
    data.actuator("bite").ctrl[0] = -12.0
    for _ in range(1000):
        mujoco.mj_step(model, data)
    assert -0.25 < data.joint("bite").qpos[0] < -0.19


def test_a_finger_that_follows_feels_the_gear_of_the_one_that_leads():  # R-X19
    files = WorldSource("new", "", (WorldFile("robot/new.urdf", "/lab/new.urdf", HOIST.encode()),))
    gripper = RobotGripper("gripper", ("finger_left",), (30.0, 0.08), (-30.0, 0.0))
    model = compiled(robot_spec(SourceTexts(files), RobotText("new", "new.urdf", devices=(gripper,))))
    names = ("z", "finger_left", "finger_right")
    assert [float(model.dof_armature[model.joint(name).dofadr[0]]) for name in names] == [0.0, 1.0, 1.0]
