import dataclasses

import pytest

from onika.ring.device import DeviceOrder, DeviceSheet, DriveEvent, DriveState, MishapEvent
from onika.words.reason import NOTHING, Reason


def test_the_numbers_on_the_bus_are_fixed():
    assert [int(order) for order in (DeviceOrder.HOLD, DeviceOrder.DRIVE, DeviceOrder.CLEAR)] == [0, 1, 2]
    assert [int(state) for state in (DriveState.DRIVEN, DriveState.HELD, DriveState.TRIPPED, DriveState.PRESSED)] == [
        0,
        1,
        2,
        3,
    ]


def test_sheets_and_events_are_values():
    sheet = DeviceSheet("lamp", ("time", "drive"), (), {})
    assert sheet == DeviceSheet("lamp", ("time", "drive"), (), {})
    with pytest.raises(dataclasses.FrozenInstanceError):
        sheet.name = "other"  # type: ignore[misc]
    assert DriveEvent("arm", 1, 4, 2, 0, Reason.plain("stop")) == DriveEvent("arm", 1, 4, 2, 0, Reason.plain("stop"))


def test_of_a_drive_nothing_is_said_that_its_world_does_not_say():
    changed = DriveEvent("arm", 1, 4, 2, 0, Reason.plain("stop"))
    assert (changed.stands, changed.touches) == (NOTHING, ())


def test_in_a_mishap_nothing_shines_that_is_not_named():
    assert MishapEvent(Reason.plain("fall"), 1, ("arm",), b"poses").lit == ()
    assert MishapEvent(Reason.plain("fall"), 1, ("arm",), b"poses", ("lamp",)).lit == ("lamp",)
