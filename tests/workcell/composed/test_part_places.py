import numpy as np

from kit.worlds.file_cells import files_of
from onika.words.reason import Reason
from onika.workcell.composed import part_places
from onika.workcell.composed.composition import Composition
from onika.workcell.composed.sources import SourceTexts
from onika.workcell.plant import Plant


def cell(seed=None):
    composition = Composition(SourceTexts(files_of()))
    parts = composition.world.parts
    offsets = part_places.offsets(parts, seed)
    return parts, Plant(composition.compile(composition.standing, offsets, is_drawn=False)), offsets


def test_a_part_that_moves_is_where_its_file_has_it():  # R-X19
    parts, plant, _ = cell()
    ((cube, at),) = part_places.free_parts(parts, plant, plant.data.qpos)
    assert (cube.name, np.round(at[:3], 9).tolist()) == ("cube", [0.6, -0.9, 0.06])
    (place,) = part_places.places(parts, plant, plant.data.qpos, Reason.plain)
    assert str(place) == "cube stands at x = 60.0 cm, y = -90.0 cm, z = 6.0 cm"
    assert list(part_places.displaced(parts, plant, Reason.plain, ())) == []


def test_a_seed_moves_it_a_little_and_always_alike():  # R-X19
    _, plant, offsets = cell(5)
    assert offsets == cell(5)[2] != cell(6)[2]
    assert offsets["table"] == (0.0, 0.0) and 0.0 < max(map(abs, offsets["cube"])) <= 0.01
    assert np.allclose(plant.data.joint("cube.free").qpos[:2], np.array([0.6, -0.9]) + offsets["cube"])


def test_what_has_gone_away_is_told():  # R-X19
    parts, plant, _ = cell()
    plant.data.joint("cube.free").qpos[0] += 0.05
    assert [str(displaced.text) for displaced in part_places.displaced(parts, plant, Reason.plain, ())] == [
        "cube is 5.0 cm from its place"
    ]


def test_what_is_turned_is_told_and_what_is_held_is_not():  # law 18, R-X19
    parts, plant, _ = cell()
    plant.data.joint("cube.free").qpos[3:] = (0.9987503, 0.0, 0.0, 0.0499792)
    (turned,) = part_places.displaced(parts, plant, Reason.plain, ())
    assert str(turned.text) == "cube is turned"
    assert list(part_places.displaced(parts, plant, Reason.plain, ["cube"])) == []
