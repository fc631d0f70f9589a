"""A robot made ready in another copy of the world stands there as one that was compiled here."""

import numpy as np

from kit.worlds.file_cells import files_of
from onika.workcell.cell.cell_scenes import CellScenes
from onika.workcell.cell.robot_exchange import RobotExchange
from onika.workcell.composed.composition import Composition
from onika.workcell.composed.sources import SourceTexts

STIFF = {"left": "stiff", "right": "elbow"}


def exchange():
    """With the composition that it fills, and its scenes."""
    composition = Composition(SourceTexts(files_of()))
    scenes = CellScenes(composition, {}, ())
    return RobotExchange(composition, scenes, STIFF, {}), composition, scenes


def test_what_another_copy_has_worked_out_is_at_hand_here(monkeypatch):  # R-X19, law 16
    there, compiled_there, drawn_there = exchange()
    here, composition, scenes = exchange()
    worked_out = there.work_out()
    monkeypatch.setattr(composition, "_spec", None)  # whoever compiles here fails
    assert not here.is_ready
    here.take(worked_out)
    model, wanted = (each.compile(STIFF, {}, is_drawn=False) for each in (composition, compiled_there))
    assert model.opt.timestep == wanted.opt.timestep and model.names == wanted.names
    assert np.array_equal(model.body_inertia, wanted.body_inertia)
    assert scenes.drawing(STIFF) == drawn_there.drawing(STIFF)
    assert here.is_ready
