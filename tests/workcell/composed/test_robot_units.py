"""The devices of all robots at all places."""

from kit.worlds.file_cells import files_of
from onika.workcell.composed.composition import Composition
from onika.workcell.composed.robot_units import robot_units
from onika.workcell.composed.sources import SourceTexts


def test_each_robot_at_each_place_has_its_devices_and_knows_its_frame_there():  # R-X19
    composition = Composition(SourceTexts(files_of()))

    def model_with(place, robot):
        return composition.compile({**composition.standing, place: robot}, {}, is_drawn=False)

    units = {unit.sheet.name: unit for unit in robot_units(composition, model_with)}
    assert {(unit.side, unit.robot) for unit in units.values()} == {
        ("left", "elbow"),
        ("left", "stiff"),
        ("right", "elbow"),
    }
    assert {unit.mode for unit in units.values()} == {"", "_kin", "*"}
    bases = [units[name].sheet.identity["BASE"][3] for name in ("elbow_left", "stiff_left", "elbow_right")]
    assert bases == [0.0, 0.0, 2.0]
