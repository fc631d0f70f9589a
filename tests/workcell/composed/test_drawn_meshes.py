import io
import sys

import numpy as np
from msgspec import msgpack

from kit.worlds.file_cells import CELL, files_of
from onika.workcell.cell.file_world import FileWorld
from onika.workcell.composed.drawn_meshes import drawn_meshes, main

CORNERS = " ".join(f"{x} {y} {z}" for x in (0.0, 0.04) for y in (0.0, 0.08) for z in (0.0, 0.12))


def with_mesh(text, size="1 1 1"):
    """A model whose first shape of body `foot` is a mesh."""
    mesh = f'<asset><mesh name="block" vertex="{CORNERS}" scale="{size}"/></asset><worldbody>'
    shape = '<geom name="foot" type="cylinder" size="0.08 0.2" pos="0 0 0.2"/>'
    assert shape in text
    return text.replace("<worldbody>", mesh, 1).replace(shape, '<geom name="foot" type="mesh" mesh="block"/>')


MESHED = {
    **CELL,
    "robot/elbow.xml": with_mesh(CELL["robot/elbow.xml"]),
    "robot/other.xml": with_mesh(CELL["robot/elbow.xml"], "2 2 2"),
    "robot/stiff.robot": CELL["robot/stiff.robot"].replace("elbow.xml", "other.xml"),
}


def test_every_mesh_of_a_scene_is_made_whichever_robot_stands_there():  # R-X19
    world = FileWorld(files_of(MESHED))
    (shape, twin) = [shape for shape in world.scene() if shape.mesh]
    assert shape.kind == "mesh" and twin.mesh == shape.mesh
    world.claim("stiff_left", 1)
    scene = world.scene()
    (other,) = {shape.mesh for shape in scene if shape.mesh} - {shape.mesh}
    made = drawn_meshes(files_of(MESHED), {shape.mesh, other, "0" * 32})
    assert set(made) == {shape.mesh, other}
    counts = np.frombuffer(made[shape.mesh], "<u4", 2)
    assert counts.tolist() == [8, 12]
    corners = np.frombuffer(made[shape.mesh], "<u2", 24, 8).reshape(-1, 3)
    assert {tuple(corner) for corner in corners.tolist()} == {
        (x, y, z) for x in (0, 65535) for y in (0, 65535) for z in (0, 65535)
    }


def test_a_world_that_cannot_be_made_has_no_meshes():  # R-X19
    assert drawn_meshes(files_of({"world/cell.world": "VERSION 2.0\nEOF\n"}, "moon"), {"0" * 32}) == {}


def test_the_program_answers_with_bytes_by_name(monkeypatch):  # R-X19
    (name,) = {shape.mesh for shape in FileWorld(files_of(MESHED)).scene()} - {""}

    class Stream:
        buffer = io.BytesIO(msgpack.encode(files_of(MESHED)))

    class Out:
        buffer = io.BytesIO()

    monkeypatch.setattr(sys, "stdin", Stream)
    monkeypatch.setattr(sys, "stdout", Out)
    assert main([name]) == 0
    assert list(msgpack.decode(Out.buffer.getvalue())) == [name]
