"""A document of one instant."""

import mujoco

from kit.worlds.file_cells import files_of
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
