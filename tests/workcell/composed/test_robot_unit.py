"""What the devices of a robot have in common."""

from onika.ring.device import DeviceSheet
from onika.workcell.composed.robot_unit import RobotUnit


def test_by_itself_it_does_nothing_on_its_own():  # R-X19
    unit = RobotUnit(DeviceSheet("base_bay", ("time", "drive"), (), {}), "rover", "bay", "bay.", 0.002)
    assert (unit.side, unit.robot, unit.mode) == ("bay", "rover", "")
    assert (unit.runs_on, unit.is_away, unit.is_stopped) == (False, False, True)
    assert str(unit.away) == "base_bay does not stand as it began"
    state = unit.state.copy()
    unit.run_on()
    unit.move()
    unit.rest()
    assert (unit.state == state).all()
