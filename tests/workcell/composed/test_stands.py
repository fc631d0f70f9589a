"""Which robot stands where."""

import pytest

from kit.worlds.file_cells import files_of
from onika.workcell.composed.file_world import FileWorld


@pytest.fixture
def stands():
    return FileWorld(files_of())._stands


def unit(stands, name):
    return next(unit for unit in stands.units if unit.sheet.name == name)


def test_the_first_robot_stands_there_until_another_one_is_wanted(stands):  # R-X19
    assert stands.acting == {"left": "elbow", "right": "elbow"}
    assert not stands.admit(unit(stands, "elbow_left"))
    assert stands.admit(unit(stands, "stiff_gripper_left"))
    assert stands.acting["left"] == "stiff"
    names = {unit.sheet.name for unit in stands.present()}
    assert names == {"stiff_left", "stiff_gripper_left", "elbow_right", "gripper_right"}


def test_two_robots_do_not_stand_at_one_place_nor_two_modes_in_one_world(stands):
    objections = [reason.key for reason in stands.objections(["elbow_left", "stiff_left", "elbow_right_kin"])]
    assert objections == ["workcell.one_place", "workcell.modes_unlike", "workcell.modes_unlike"]
    unit(stands, "elbow_left").epoch = 1
    with pytest.raises(ValueError, match="a free place"):
        stands.admit(unit(stands, "stiff_left"))
    with pytest.raises(ValueError, match="arms of one mode"):
        stands.admit(unit(stands, "elbow_right_kin"))
    assert not stands.admit(unit(stands, "gripper_right"))
