"""The texts of a world, and its models read from memory alone."""

import pytest

from kit.worlds.file_cells import CELL, changed, files_of
from onika.workcell.composed.sources import SourceTexts


def test_all_texts_are_read():  # R-X19
    texts = SourceTexts(files_of())
    assert (texts.faults, set(texts.robots), texts.world.name) == ([], {"elbow", "stiff"}, "cell")
    assert texts.robot_place("elbow", 3).file == "/lab/robot/elbow.robot"


def test_what_is_wrong_with_a_text_is_told_where_it_was_read():  # R-B07
    texts = SourceTexts(changed("robot/elbow.robot", "OPEN 0.03 0.06", "OPEN wide"))
    assert [str(fault.place) for fault in texts.faults] == ["/lab/robot/elbow.robot:9"]
    assert set(texts.robots) == {"stiff"}


def test_a_model_reads_nothing_of_this_machine(tmp_path):  # R-X24
    (tmp_path / "secret.xml").write_text("<mujoco/>")
    include = f'<include file="{tmp_path}/secret.xml"/>'
    texts = SourceTexts(files_of({**CELL, "robot/elbow.xml": f"<mujoco>{include}</mujoco>"}))
    with pytest.raises(ValueError, match="needs only files that are there"):
        texts.model("robot/elbow.xml")


def test_shapes_of_a_mesh_that_is_gone_are_left_out():  # R-B07, R-X19
    mesh = '<asset><mesh name="m" file="missing.obj"/></asset><worldbody><geom name="g" type="mesh" mesh="m"/>'
    model = f'<mujoco>{mesh}<geom name="rest" size="1"/></worldbody></mujoco>'
    spec = SourceTexts(files_of({**CELL, "robot/elbow.xml": model})).model("robot/elbow.xml")
    assert [geom.name for geom in spec.geoms] == ["rest"]
    assert spec.compile().nmesh == 0


@pytest.mark.parametrize(("name", "why"), [("robot/none.xml", "found none"), ("robot/elbow.xml", "cannot read")])
def test_what_is_no_model_is_told(name, why):  # R-B07
    texts = SourceTexts(files_of({**CELL, "robot/elbow.xml": "<mujoco><worldbody>"}))
    with pytest.raises(ValueError, match=why):
        texts.model(name)


def test_a_texture_that_is_gone_is_left_out_and_what_is_painted_with_it_stays():  # R-B07, R-X19
    paint = '<asset><texture name="t" type="2d" file="missing.png"/><material name="m" texture="t"/></asset>'
    model = f'<mujoco>{paint}<worldbody><geom name="g" size="1" material="m"/></worldbody></mujoco>'
    spec = SourceTexts(files_of({**CELL, "robot/elbow.xml": model})).model("robot/elbow.xml")
    assert (len(spec.textures), [geom.name for geom in spec.geoms], spec.compile().nmat) == (0, ["g"], 1)
