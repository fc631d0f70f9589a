import mujoco

from onika.workcell.view import LOOK


def test_what_a_drawn_document_says_first_is_read_and_makes_room_for_large_pictures():
    model = mujoco.MjModel.from_xml_string(f"<mujoco>{LOOK}<worldbody/></mujoco>")
    assert (model.vis.global_.offwidth, model.vis.global_.offheight) == (2560, 1720)
    assert model.nbody == 1
