import mujoco
import pytest

from onika.workcell.box import FEET_M, GLOWS, MASS_KG, SIGNS, SIZE_M, AssemblyBox
from onika.workcell.paint import paints
from onika.workcell.part import document


def _model(sign, drawn=False):
    parts = [paints()] if drawn else []
    return mujoco.MjModel.from_xml_string(document("box", [*parts, AssemblyBox(sign, 0.1, 0.2, 0.3).part(drawn)]))


@pytest.mark.parametrize("sign", SIGNS)
def test_a_box_has_its_size_and_weight_and_stands_on_its_feet(sign):  # R-K01
    model = _model(sign)
    name = f"box_{sign}"
    slab, foot = model.geom(f"{name}.slab"), model.geom(f"{name}.foot_pp")
    height = SIZE_M[2]
    assert (2 * slab.size[:2]).tolist() == pytest.approx(SIZE_M[:2])
    assert slab.pos[2] + slab.size[2] == pytest.approx(height / 2)
    assert foot.pos[2] - foot.size[0] == pytest.approx(-height / 2)
    assert slab.pos[2] - slab.size[2] == pytest.approx(-height / 2 + 0.001)
    assert foot.pos[:2].tolist() == pytest.approx(FEET_M)
    assert model.body(name).mass[0] == MASS_KG
    assert model.body(name).pos.tolist() == pytest.approx([0.1, 0.2, 0.3 + height / 2])


def test_patches_are_on_all_but_the_last_and_metal_feet_under_all_but_the_first():
    sites = {sign: {_model(sign).site(k).name.split(".")[1] for k in range(_model(sign).nsite)} for sign in SIGNS}
    assert sites["waves"] == {"patch_pp", "patch_mm"}
    assert sites["triangle"] == sites["square"] == {"patch_pp", "patch_mm", "foot_pp", "foot_mm"}
    assert sites["cross"] == {"foot_pp", "foot_mm"}


@pytest.mark.parametrize("sign", SIGNS)
def test_every_box_is_drawn_with_a_sign_of_its_own_inside_its_faces(sign):
    model = _model(sign, drawn=True)
    strokes = [k for k in range(model.ngeom) if model.geom_matid[k] == model.material("white").id]
    assert strokes
    half = [size / 2 for size in SIZE_M]
    for k in strokes:
        assert all(abs(place) <= edge for place, edge in zip(model.geom_pos[k], half, strict=True))
    counts = {other: _model(other, drawn=True).ngeom for other in SIGNS}
    assert len(set(counts.values())) == len(SIGNS)


def test_only_the_last_box_carries_the_lamp_and_its_glow():
    lamps = [
        sign for sign in SIGNS if "lamp" in [_model(sign, True).geom(k).name for k in range(_model(sign, True).ngeom)]
    ]
    assert lamps == ["cross"]
    assert _model("cross", True).geom(f"lamp.glow{GLOWS - 1}").size[0] < 0.06
    assert _model("cross", True).light("lamp").active[0] == 0
