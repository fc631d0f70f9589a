import mujoco
import numpy as np
import pytest

from kit.worlds.box_cells import boxes_world
from onika.laws.mesh import mesh_name
from onika.workcell.plant import Plant
from onika.workcell.scene import BULB, box_around, looked_at, mesh_of

WORLD = boxes_world()
WORLD.claim("arm_left", 1)
SHAPES = WORLD.scene()


def drawn():
    """The world as it is looked at."""
    return Plant(WORLD._compile(WORLD._stands.acting, is_drawn=True))


def plant_of(text):
    return Plant(mujoco.MjModel.from_xml_string(text))


def test_every_shape_is_plain_data_on_a_body_that_has_a_pose():
    poses = WORLD.poses()
    for shape in SHAPES:
        assert 0 <= shape.body < len(poses)
        assert all(type(number) is float for number in (*shape.size, *shape.position, *shape.quaternion, *shape.rgba))
        assert shape.kind in ("plane", "box", "sphere", "cylinder", "capsule", "ellipsoid")


def test_four_boxes_are_blue_with_white_signs_and_the_lamp_shines_in_glass():
    blue = {shape.body for shape in SHAPES if shape.rgba[2] > 2.0 * shape.rgba[0] and shape.kind == "box"}
    assert blue == {1, 2, 3, 4}
    assert {shape.body for shape in SHAPES if min(shape.rgba[:3]) > 0.9 and shape.body in blue} == blue
    assert [(shape.name, shape.kind) for shape in SHAPES if shape.paint == BULB] == [("box_cross.lamp", "ellipsoid")]


def test_hinges_say_where_the_bodies_of_an_arm_come_for_given_angles():  # R-D25
    plant = drawn()
    angles = [0.3, -1.2, 0.7, 0.5, -0.4, 1.1]
    where, _ = plant.joints([f"left.joint{k}" for k in range(1, 7)])
    plant.data.qpos[where] = angles
    mujoco.mj_kinematics(plant.model, plant.data)
    hinges = {shape.body: shape.hinge for shape in looked_at(plant) if shape.hinge and shape.hinge.joint}
    # the world itself and the four boxes, which are free, hang on nothing
    assert len([shape for shape in SHAPES if shape.hinge]) == len({shape.body for shape in SHAPES}) - 5
    links = [(body, hinge) for body, hinge in hinges.items() if hinge.joint.startswith("left.joint")]
    assert [hinge.joint for _, hinge in links] == [f"left.joint{k}" for k in range(1, 7)]
    poses = plant.poses()
    for (body, hinge), angle in zip(links, angles, strict=True):
        assert np.allclose(hung(poses[hinge.carrier], hinge, angle), poses[body][:3], atol=1e-5)


def hung(carrier, hinge, angle):
    """The place of a body that turns by an angle about its joint."""
    rest, turn = np.zeros(3), np.zeros(4)
    mujoco.mju_mulPose(rest, turn, *map(np.float64, (carrier[:3], carrier[3:], hinge.position, hinge.quaternion)))
    about, turned, pivot, back = np.zeros(4), np.zeros(4), np.zeros(3), np.zeros(3)
    mujoco.mju_axisAngle2Quat(about, np.array(hinge.axis), angle)
    mujoco.mju_mulQuat(turned, turn, about)
    mujoco.mju_rotVecQuat(pivot, np.array(hinge.anchor), turn)
    mujoco.mju_rotVecQuat(back, np.array(hinge.anchor), turned)
    return rest + pivot - back


def test_what_lies_free_hangs_on_nothing():
    free = {shape.hinge for shape in SHAPES if shape.body in (1, 2, 3, 4)}
    assert free == {None}


def test_of_a_body_that_is_drawn_what_only_touches_is_left_out():  # R-X19
    plant = plant_of(
        '<mujoco><worldbody><body name="a"><joint name="j"/><geom name="touch" size="1" group="3"/>'
        '<geom name="seen" size="1" group="2" rgba="1 0 0 1"/></body>'
        '<body name="b"><geom name="only" size="1" group="3"/></body></worldbody></mujoco>'
    )
    seen, only = looked_at(plant)
    assert (seen.name, seen.hinge.joint, seen.rgba, only.name) == ("seen", "j", (1.0, 0.0, 0.0, 1.0), "only")


def test_what_touches_in_a_group_of_its_own_is_left_out_beside_what_is_only_drawn():  # R-X19
    plate = '<geom name="{}" type="box" size="1 1 1" group="{}" contype="{}" conaffinity="{}"/>'
    hull, skin = plate.format("hull", 0, 1, 1), plate.format("skin", 1, 0, 0)
    glow, alike = plate.format("glow", 0, 0, 0), plate.format("alike", 0, 1, 1)
    bodies = f"<body>{hull}{skin}</body><body>{alike}{glow}</body><body>{plate.format('lone', 0, 1, 1)}</body>"
    names = [shape.name for shape in looked_at(plant_of(f"<mujoco><worldbody>{bodies}</worldbody></mujoco>"))]
    assert names == ["skin", "alike", "glow", "lone"]


def test_a_mesh_has_a_name_and_stands_in_the_box_around_it():  # R-X19
    corners = " ".join(f"{x} {y} {z}" for x in (0, 2) for y in (0, 4) for z in (0, 6))
    mesh = f'<asset><mesh name="m" vertex="{corners}"/></asset>'
    plant = plant_of(f'<mujoco>{mesh}<worldbody><geom type="mesh" mesh="m"/></worldbody></mujoco>')
    (box,) = looked_at(plant)
    assert (box.kind, box.mesh) == ("mesh", mesh_name(*mesh_of(plant.model, 0)))
    assert sorted(box.size) == pytest.approx([1.0, 2.0, 3.0], abs=1e-4)
    assert box.position == pytest.approx((1.0, 2.0, 3.0), abs=1e-4)


def test_a_joint_says_whether_it_slides():  # R-D25
    joints = '<joint name="{0}" type="{0}"/><geom size="1"/>'
    bodies = "".join(f"<body>{joints.format(kind)}</body>" for kind in ("slide", "hinge"))
    slide, hinge = looked_at(plant_of(f"<mujoco><worldbody>{bodies}</worldbody></mujoco>"))
    assert (slide.hinge.slides, hinge.hinge.slides) == (True, False)


def test_points_on_the_box_around_a_shape_lie_on_all_its_sides():
    model = plant_of("<mujoco><worldbody><geom type='box' size='.1 .2 .3'/></worldbody></mujoco>").model
    points = box_around(model, 0, 3)
    assert points.shape == (3**3 - 1, 3)
    assert points.max(axis=0) == pytest.approx((0.1, 0.2, 0.3)) == -points.min(axis=0)
    assert ((abs(points) > (0.099, 0.199, 0.299)).any(axis=1)).all()
