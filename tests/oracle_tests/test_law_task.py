"""A task as the law sees it."""

import pytest

from onika.ring.device import DeviceOrder
from oracle.law_task import DeviceHandle, LawTask, Traced

PUBLISHED = {"m0": (0.5, 0.0, 1.0, 2.0)}


def test_a_hand_reads_what_was_published_last_without_time_and_drive():  # law 1
    published = dict(PUBLISHED)
    hand = DeviceHandle(published, "m0")
    assert hand.read() == (1.0, 2.0)
    published["m0"] = (0.6, 0.0, 3.0, 4.0)
    assert hand.read() == (3.0, 4.0)


def test_the_newest_command_is_the_one_that_counts():  # law 1
    hand = DeviceHandle(PUBLISHED, "m0")
    assert hand.order is None
    hand.hold()
    hand.write((2.0,))
    assert hand.order == (DeviceOrder.DRIVE, (2.0,))


def test_while_it_holds_every_command_is_a_hold():  # law 4
    hand = DeviceHandle(PUBLISHED, "m0")
    hand.is_holding = True
    hand.write((float("nan"),))
    assert hand.order == (DeviceOrder.HOLD, ())


@pytest.mark.parametrize("bad", [float("nan"), float("-inf")])
def test_what_is_not_finite_is_a_hold_and_raises(bad):  # law 5
    hand = DeviceHandle(PUBLISHED, "m0")
    with pytest.raises(ValueError, match="finite"):
        hand.write((1.0, bad))
    assert hand.order == (DeviceOrder.HOLD, ())


def test_records_are_values():
    assert Traced(1, "a", "on", {}, {}) == Traced(1, "a", "on", {}, {})
    assert LawTask("a", {}) == LawTask("a", {})
