from kit.worlds.file_cells import files_of
from onika.model.world import LampBlock
from onika.workcell.cell.cell_scenes import CellScenes
from onika.workcell.composed.composition import Composition
from onika.workcell.composed.sources import SourceTexts
from onika.workcell.scene import BULB

COMPOSITION = Composition(SourceTexts(files_of()))


def test_a_scene_is_worked_out_once_for_those_who_stand_there():  # R-X19
    scenes = CellScenes(COMPOSITION, {}, ())
    both = scenes.of({"left": "elbow", "right": "elbow"})
    assert scenes.of({"left": "elbow", "right": "elbow"}) is both
    assert len(scenes.of({"left": "elbow", "right": ""})) < len(both)


def test_what_shines_is_painted_as_a_bulb():  # R-X19
    lamp = LampBlock("lamp", ("rests",), shines=("cube.cube",))
    shapes = CellScenes(COMPOSITION, {}, (lamp,)).of(COMPOSITION.standing)
    assert [shape.name for shape in shapes if shape.paint == BULB] == ["cube.cube"]
