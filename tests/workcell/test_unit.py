import numpy as np

from onika.ring.device import DeviceSheet, DriveState
from onika.workcell.unit import DeviceUnit, row_of


def test_a_unit_starts_unclaimed_and_in_hold_and_publishes_the_time():
    unit = DeviceUnit(DeviceSheet("thing", ("time", "drive", "x"), ("u",), {}))
    assert (unit.epoch, unit.follows, unit.count) == (None, None, 1)
    assert unit.state[1] == DriveState.HELD
    unit.refresh(1.5)
    assert unit.state.tolist() == [1.5, 1.0, 0.0]


def test_a_row_writes_into_the_array_it_looks_at():
    array = np.zeros(4)
    row_of(array[1:])[0] = 2.0
    assert array.tolist() == [0.0, 2.0, 0.0, 0.0]
