import mujoco
import numpy as np

from kit.worlds.file_cells import ARM
from onika.model.picture import Picture
from onika.workcell.drafting.draft_chain import draft_chain
from onika.workcell.drafting.draft_pictures import draft_pictures

GREY, RED, GREEN, WHITE = "6", "0", "1", "7"


def pictures_of(text, *postures):
    model = mujoco.MjModel.from_xml_string(text)
    chain = draft_chain(model)
    return draft_pictures(model, chain.joints, [np.array(posture) for posture in postures])


def cells(picture, colour):
    return [(x, y) for y, row in enumerate(picture) for x, cell in enumerate(row) if cell == colour]


def test_each_posture_has_a_picture_of_its_own_seen_from_the_same_place():  # R-X19, R-B11
    home, bent, again = pictures_of(ARM, (0.0, 0.0, 0.0), (1.5, -1.0, 0.0), (0.0, 0.0, 0.0))
    assert Picture(home).size == 32
    assert home == again != bent
    foot = cells(home, GREY)
    assert len(foot) > 80
    assert set(cells(bent, GREY)) & set(foot), "the foot stands where it stood"


def test_a_robot_fills_the_picture_and_leaves_room_for_the_line_around_it():  # R-B11
    (home,) = pictures_of(ARM, (0.0, 0.0, 0.0))
    columns, lines = zip(*cells(home, GREY), strict=True)
    assert max(max(columns) - min(columns), max(lines) - min(lines)) == 25
    assert min(columns + lines) >= 3 and max(columns + lines) <= 28


def test_shapes_keep_their_colours_and_what_is_white_is_grey():  # R-X19
    painted = ARM.replace('size="0.03" fromto', 'size="0.03" rgba="0.9 0.1 0.1 1" fromto')
    (home,) = pictures_of(painted.replace('size="0.08 0.2"', 'size="0.08 0.2" rgba="1 1 1 1"'), (0.0, 0.0, 0.0))
    assert cells(home, RED) and cells(home, GREY) and not cells(home, GREEN)


def test_what_is_nearer_hides_what_is_behind_it():  # R-X19
    wall = '<worldbody><geom type="box" size="0.01 2 2" pos="{x} 0 0" rgba="0.1 0.6 0.2 1"/>'
    (before,) = pictures_of(ARM.replace("<worldbody>", wall.format(x=2.0), 1), (0.0, 0.0, 0.0))
    (behind,) = pictures_of(ARM.replace("<worldbody>", wall.format(x=-2.0), 1), (0.0, 0.0, 0.0))
    assert not cells(before, GREY) and cells(behind, GREY)


def test_of_nothing_to_see_there_is_no_picture():  # R-X19
    bare = """<mujoco><worldbody><body><joint name="turn" axis="0 0 1"/>
    <inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body></worldbody>
    <actuator><motor joint="turn"/></actuator></mujoco>"""
    assert pictures_of(bare, (0.0,)) == ()
