"""Worlds composed of files; what is left out is told."""

import pytest

from kit.worlds.file_cells import CELL, changed, files_of
from onika.workcell.composed.composition import Composition
from onika.workcell.composed.sources import SourceTexts
from onika.workcell.composed.usable_parts import prefix_of


def composed(files):
    return Composition(SourceTexts(files))


def test_parts_and_robots_stand_where_the_world_says():  # R-X19
    composition = composed(files_of())
    model = composition.compile(composition.standing, {"cube": (0.01, 0.0)}, is_drawn=False)
    assert composition.faults == []
    assert model.body("left.foot").pos.tolist() == [0.0, 0.0, 0.0]
    assert model.body("right.foot").pos[0] == pytest.approx(2.0)
    assert model.joint("cube.free").qpos0[:3] == pytest.approx([0.61, -0.9, 0.06])
    assert (model.opt.timestep, model.opt.gravity[2]) == (0.002, -9.81)
    assert (prefix_of("-"), prefix_of("left")) == ("", "left.")


def test_a_part_stands_on_a_site_of_another_whatever_their_order():  # R-X19
    world = CELL["world/cell.world"].replace("AT 0.6 -0.9 0.06 0\nFREE 0.01", "ON table.patch")
    blocks = world.split("PART ")
    world = "PART ".join([blocks[0], blocks[2].replace("PLACE", "PART table\nFILE table.xml\nPLACE", 1)])
    composition = composed(files_of({**CELL, "world/cell.world": world}))
    model = composition.compile(composition.standing, {}, is_drawn=False)
    assert model.body("cube.cube").pos[2] == pytest.approx(0.02)


def test_a_robot_that_is_nowhere_is_left_out_with_its_line():  # R-B07, R-X19
    composition = composed(changed("world/cell.world", "ROBOTS elbow stiff", "ROBOTS gone elbow"))
    assert composition.standing["left"] == "elbow"
    assert [(fault.reason.key, fault.place.line) for fault in composition.faults] == [("workcell.robot_missing", 12)]


def test_a_place_without_a_robot_is_left_out():  # R-B07
    composition = composed(changed("world/cell.world", "ROBOTS elbow stiff", "ROBOTS gone"))
    assert list(composition.standing) == ["right"]
    assert {fault.reason.key for fault in composition.faults} == {"workcell.robot_missing", "workcell.place_empty"}


def test_a_world_whose_text_is_broken_is_refused_with_its_line():  # R-B07
    with pytest.raises(ValueError, match=r"cell\.world:3"):
        composed(changed("world/cell.world", "FLOOR 0", "FLOOR low"))


def test_a_robot_whose_inertia_is_that_of_what_is_drawn_keeps_it():  # R-X19
    bones = '<compiler angle="radian" autolimits="true" inertiafromgeom="true"/>'
    model = CELL["robot/elbow.xml"].replace('<compiler angle="radian" autolimits="true"/>', bones)
    model = model.replace('mass="2"/>', 'mass="2" contype="0" conaffinity="0"/>', 1)
    composition = composed(files_of({**CELL, "robot/elbow.xml": model}))
    compiled = composition.compile(composition.standing, {}, is_drawn=False)
    assert compiled.body("left.upper").mass[0] == pytest.approx(2.0)
