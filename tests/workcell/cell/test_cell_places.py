"""What stands where in a world from files, and what is elsewhere now."""

from kit.worlds.grasping_cells import Cell
from onika.words.reason import in_language


def test_things_are_called_by_their_names():  # R-X19
    cell = Cell()
    first, *_, arm = cell.world.places()
    assert str(first).startswith("the red cube stands at x = 55.0 cm")
    assert in_language(first, "es").startswith("el cubo rojo")
    assert str(arm) == "elbow_left_kin stands as it began"


def test_what_is_turned_on_its_place_is_displaced_too():  # law 18
    cell = Cell()
    cell.world._plant.data.joint("cube.free").qpos[3:] = (0.7071068, 0.0, 0.0, 0.7071068)
    texts = [str(displaced.text) for displaced in cell.world.displaced()]
    assert texts[0] == "the red cube is turned"
