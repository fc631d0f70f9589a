import mujoco
import numpy as np
import pytest

from kit.worlds.file_cells import ARM
from kit.worlds.robot_models import PLAIN, STATUE
from onika.workcell.drafting.draft_chain import below, draft_chain, draft_tool

MOTORS = '<actuator><motor joint="turn"/><motor joint="bend"/></actuator></mujoco>'


def model_of(text):
    return mujoco.MjModel.from_xml_string(text)


def at_zero(model):
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return data


def test_the_arm_is_the_longest_run_of_joints_without_its_fingers():  # R-X19
    model = model_of(ARM)
    chain = draft_chain(model)
    assert [model.joint(k).name for k in chain.joints] == ["turn", "bend", "lift"]
    assert model.body(chain.last).name == "quill"
    assert [model.body(k).name for k in below(model, chain.last)] == ["quill", "finger1", "finger2"]


def test_joints_that_nothing_drives_are_no_arm():  # R-X19
    assert draft_chain(model_of(PLAIN)) is None
    assert draft_chain(model_of(STATUE)) is None


@pytest.mark.parametrize(("driven", "start", "notes"), [("turn", "", []), ("bend", "post", ["workcell.draft_loose"])])
def test_the_arm_is_the_part_of_a_run_that_is_driven(driven, start, notes):  # R-X19
    model = model_of(PLAIN.replace("</mujoco>", f'<actuator><motor joint="{driven}"/></actuator></mujoco>'))
    chain = draft_chain(model)
    assert [model.joint(k).name for k in chain.joints] == [driven]
    assert (chain.start, [note.key for note in chain.notes]) == (start, notes)


def test_a_rod_that_nothing_drives_is_no_branch_and_bears_no_tool():  # R-X19
    rod = '<body name="tip_of_rod"><joint name="loose" axis="0 1 0"/><geom size="0.01"/></body>'
    model = model_of(PLAIN.replace('<body name="rod"', f'{rod}<body name="rod"').replace("</mujoco>", MOTORS))
    chain = draft_chain(model)
    assert [model.joint(k).name for k in chain.joints] == ["turn", "bend"]
    on_rod = model_of(PLAIN.replace("</mujoco>", '<actuator><motor joint="turn"/></actuator></mujoco>'))
    assert draft_tool(on_rod, at_zero(on_rod), draft_chain(on_rod), ()).name != "rod"


def test_an_arm_on_what_moves_freely_begins_there_and_that_is_told():  # R-X19
    text = PLAIN.replace("</mujoco>", MOTORS).replace(
        '<body name="post" pos="0 0 0.3">',
        '<body name="cart"><freejoint/><geom size="0.1"/><body name="post" pos="0 0 0.3">',
    ).replace("</worldbody>", "</body></worldbody>")  # fmt: skip
    chain = draft_chain(model_of(text))
    assert (chain.start, [note.key for note in chain.notes]) == ("cart", ["workcell.draft_floats"])


def test_without_a_site_the_tool_is_between_the_fingers():  # R-X19
    model = model_of(ARM.replace('<site name="tip" pos="0 0 -0.1" euler="3.14159265358979 0 0"/>', ""))
    chain = draft_chain(model)
    fingers = [model.body("finger1").id, model.body("finger2").id]
    tool = draft_tool(model, at_zero(model), chain, fingers)
    assert (tool.name, tool.approach, tool.fingers) == ("quill", "-z", "y")
    np.testing.assert_allclose(tool.offset, (0.0, 0.0, -0.08), atol=1e-3)


def test_without_anything_behind_it_the_last_body_is_the_tool():  # R-X19
    model = model_of(PLAIN.replace("</mujoco>", MOTORS))
    tool = draft_tool(model, at_zero(model), draft_chain(model), ())
    assert (tool.name, tool.offset, tool.approach, tool.fingers) == ("rod", (0.0, 0.0, 0.0), "z", "y")
