"""The units of a runner's rig note orders, and grant devices or refuse them."""

import pytest

from kit.plans.plan_builder import action
from kit.runtime.runner_rig import NotingUnits, RunnerRig
from onika.runtime import command


def test_an_order_is_taken_once():
    rig = RunnerRig([action("bell")]).start()
    assert [order.task for _, order in rig.units.take(command.Spawn)] == ["bell"]
    assert rig.units.take(command.Spawn) == []


def test_a_device_is_granted_unless_units_are_told_to_refuse():
    units = NotingUnits()
    assert units.grant("rt0", "yard:m0").name == "yard:m0"
    units.refuses = "it is taken"
    with pytest.raises(ValueError, match="it is taken"):
        units.grant("rt0", "yard:m1")
    assert units.granted == [("rt0", "yard:m0")]
