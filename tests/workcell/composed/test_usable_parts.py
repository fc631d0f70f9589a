"""Parts of which a world is made; those that cannot be made are left out, each told with its line."""

from pathlib import PurePath

import pytest

from kit.worlds.file_cells import CELL, changed, files_of
from onika.workcell.composed.composition import Composition
from onika.workcell.composed.sources import SourceTexts
from onika.workcell.composed.usable_parts import prefix_of

ON_TABLE = CELL["world/cell.world"].replace("AT 0.6 -0.9 0.06 0", "ON table.patch")


def composed(files):
    """The world of these files with what is told of it, as places and reasons."""
    composition = Composition(SourceTexts(files))
    composition.compile(composition.standing, {}, is_drawn=False)
    told = [(_at(fault.place), fault.reason.key, str(fault.instead)) for fault in composition.faults]
    return [part.name for part in composition.parts], told


def _at(place):
    return f"{PurePath(place.file).name}:{place.line}"


@pytest.mark.parametrize(
    ("name", "old", "new", "key", "part", "at"),
    [
        ("world/cell.world", "FILE table.xml", "FILE shelf.xml", "workcell.model_missing", "table", "cell.world:5"),
        ("world/table.xml", 'size="0.3 0.3 0.02"', 'size="-1 1 1"', "workcell.model_unsound", "table", "table.xml:1"),
        ("world/cube.xml", '<body name="cube">', "", "workcell.model_unreadable", "cube", "cube.xml:1"),
        ("world/cube.xml", "<worldbody>", "<worldbody/><worldbody>", "", "", ""),
    ],
)
def test_a_part_that_cannot_be_made_is_left_out_with_the_line_of_its_cause(
    name, old, new, key, part, at
):  # R-B07, R-X19
    parts, told = composed(changed(name, old, new))
    assert told == ([(at, key, f"the part {part} is left out")] if key else [])
    assert parts == [name for name in ("table", "cube") if name != part]


def test_a_part_that_moves_has_a_body():  # R-B07, R-X19
    parts, told = composed(files_of({**CELL, "world/cube.xml": "<mujoco><worldbody/></mujoco>"}))
    assert (parts, [key for _, key, _ in told]) == (["table"], ["workcell.part_without_body"])


def test_what_stands_on_a_part_that_is_left_out_is_left_out_as_well():  # R-B07, R-X19
    parts, told = composed(files_of({**CELL, "world/cell.world": ON_TABLE.replace("table.xml", "shelf.xml")}))
    assert (parts, [key for _, key, _ in told]) == ([], ["workcell.model_missing", "workcell.no_such_name"])
    assert [at for at, _, _ in told] == ["cell.world:5", "cell.world:9"]


def test_a_place_on_a_site_that_is_nowhere_is_left_out():  # R-B07, R-X19
    parts, told = composed(changed("world/cell.world", "AT 2 0 0 180", "ON table.edge"))
    assert (parts, [key for _, key, _ in told]) == (["table", "cube"], ["workcell.no_such_name"])
    assert (prefix_of("-"), prefix_of("left")) == ("", "left.")
