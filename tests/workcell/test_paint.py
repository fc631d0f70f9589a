import mujoco

from onika.workcell.paint import paints
from onika.workcell.part import document


def test_every_paint_is_a_material_and_the_glow_is_invisible():
    model = mujoco.MjModel.from_xml_string(document("paints", [paints()]))
    names = {model.material(k).name for k in range(model.nmat)}
    assert {"paper", "wood", "cream", "orange", "blue", "white", "brass", "glow"} <= names
    assert model.material("glow").rgba[3] == 0.0
    assert model.material("paper").texid.max() >= 0
