"""A document of one instant."""

import mujoco
import pytest

from kit.worlds.assembler import Assembler
from kit.worlds.box_cells import boxes_world
from kit.worlds.file_cells import changed, files_of
from onika.workcell.cell.file_world import FileWorld
from onika.workcell.snapshot import decode


def test_an_instant_can_be_drawn_without_the_files_of_its_world():  # R-K06, R-X19
    world = FileWorld(files_of())
    world.step(100_000_000)
    still = mujoco.MjModel.from_xml_string(decode(world.snapshot()).mjcf)
    assert (still.nq, still.ngeom, still.camera("picture").id) == (0, len(world.scene()), 0)
    data = mujoco.MjData(still)
    mujoco.mj_forward(still, data)
    assert abs(data.xpos[:, :3] - world.poses()[:, :3]).max() < 1e-5
    lit = [colour for colour in still.geom_rgba.tolist() if colour[2] < 0.71 and colour[0] == 1.0 and colour[1] > 0.9]
    assert len(lit) == 1


def test_a_lamp_throws_its_light_only_while_it_shines_and_paints_keep_their_gloss():  # R-X19
    world = boxes_world()
    dark = decode(world.snapshot()).mjcf
    assert "attenuation" not in dark and 'shininess="0.7"' in dark and 'texture="tiles"' in dark
    Assembler(world).assemble()
    picture = decode(world.snapshot()).mjcf
    assert picture.count("attenuation") == 1
    still = mujoco.MjModel.from_xml_string(picture)
    faint = sorted(colour[3] for colour in still.geom_rgba.tolist() if colour[:3] == pytest.approx([1.0, 0.8, 0.25]))
    assert faint == pytest.approx([0.3 / k for k in range(6, 0, -1)], abs=1e-6)
    shapes = {shape.name: shape.paint for shape in world.scene()}
    assert (shapes["box_cross.lamp"], shapes["box_cross.lamp.glow0"]) == ("glass", "glow")


def test_a_camera_of_a_model_that_is_called_so_is_where_a_picture_is_seen_from():  # R-X19
    camera = '<camera name="picture" pos="1 2 3" fovy="40"/></worldbody>'
    world = FileWorld(changed("world/table.xml", "</worldbody>", camera))
    still = mujoco.MjModel.from_xml_string(decode(world.snapshot()).mjcf)
    assert still.camera("picture").pos.tolist() == pytest.approx([1.6, 1.1, 3.02])
    assert still.camera("picture").fovy[0] == pytest.approx(40.0)
