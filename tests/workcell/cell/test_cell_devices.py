"""Lamps and sensors whose names are nowhere, each told behind what it follows from."""

from pathlib import PurePath

from kit.worlds.file_cells import CELL, files_of
from onika.words.cause import by_cause
from onika.workcell.cell.file_world import FileWorld

TEXT = """VERSION 2.0

PART table
FILE table.xml

PART cube
FILE shelf.xml
AT 0.6 -0.9 0.06 0

SENSOR where
POSE cube.cube

SWITCH on
NEAR cube.top table.patch 0.01

LAMP lamp
WHEN on

SENSOR nothing
READS nobody

EOF
"""


def test_what_names_a_part_that_is_left_out_follows_from_that():  # R-B07, R-X19
    world = FileWorld(files_of({**CELL, "world/cell.world": TEXT}))
    told = [(_at(cause.fault), sorted(_at(each) for each in cause.consequences)) for cause in by_cause(world.faults)]
    assert told == [("cell.world:7", ["cell.world:11", "cell.world:14", "cell.world:17"]), ("cell.world:20", [])]
    assert [sheet.name for sheet in world.devices()] == []


def test_a_lamp_that_names_no_shape_is_told_of_and_is_a_lamp_all_the_same():  # R-X19
    text = CELL["world/cell.world"].replace("SHINES cube.cube", "SHINES cube.cub table.board\nGLOWS left.foot air")
    world = FileWorld(files_of({**CELL, "world/cell.world": text}))
    at = next(number for number, line in enumerate(text.splitlines(), 1) if line.startswith("SHINES"))
    told = [(fault.place.line, fault.reason.args["name"], fault.instead.key) for fault in world.faults]
    assert told == [(at, "cube.cub", "workcell.shape_dark"), (at + 1, "air", "workcell.shape_dark")]
    assert "lamp" in {sheet.name for sheet in world.devices()}


def _at(fault):
    return f"{PurePath(fault.place.file).name}:{fault.place.line}"
