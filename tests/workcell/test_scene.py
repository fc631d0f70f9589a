from onika.workcell.layout import boxes, text
from onika.workcell.plant import Plant
from onika.workcell.scene import shapes

DRAWN = Plant(text(boxes(0, 0.0), ("left",), drawn=True))
SHAPES = shapes(DRAWN)


def test_every_shape_is_plain_data_on_a_body_that_has_a_pose():
    poses = DRAWN.poses()
    for shape in SHAPES:
        assert 0 <= shape.body < len(poses)
        assert all(type(number) is float for number in (*shape.size, *shape.position, *shape.quaternion, *shape.rgba))
        assert shape.kind in ("plane", "box", "sphere", "cylinder", "capsule", "ellipsoid")


def test_boxes_are_blue_with_white_signs_and_the_lamp_has_its_name():
    blue = [shape for shape in SHAPES if shape.paint == "blue"]
    assert len(blue) == 4
    assert {shape.body for shape in SHAPES if shape.paint == "white"} == {shape.body for shape in blue}
    assert [shape.kind for shape in SHAPES if shape.name == "lamp"] == ["ellipsoid"]
