"""What there is to draw, as plain data."""

import mujoco
from msgspec import msgpack

from onika.workcell.composed.drawing import Drawing, Material, drawing
from onika.workcell.plant import Plant

GLOSSY = """<mujoco><asset><material name="lacquer" specular="0.25" shininess="0.75"/></asset><worldbody>
<body name="box" pos="0 0 1"><geom name="box" type="box" size="1 1 1" material="lacquer"/>{camera}</body>
</worldbody></mujoco>"""


def drawn(camera=""):
    return drawing(Plant(mujoco.MjModel.from_xml_string(GLOSSY.format(camera=camera))))


def test_it_holds_shapes_and_how_they_reflect_and_goes_as_bytes():  # R-X19
    plain = drawn()
    assert [shape.name for shape in plain.shapes] == ["box"]
    assert plain.materials == (Material("lacquer", 0.25, 0.75),) and plain.eye == ""
    assert msgpack.decode(msgpack.encode(plain), type=Drawing) == plain


def test_the_eye_of_a_model_is_where_it_is_at_the_start():  # R-X19
    eye = drawn('<camera name="picture" pos="1 2 3" fovy="40"/>').eye
    assert 'pos="1.0 2.0 4.0"' in eye and 'fovy="40.0"' in eye
    assert drawn('<camera name="other" pos="1 2 3" fovy="40"/>').eye == ""
