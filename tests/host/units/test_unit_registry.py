import inspect

import pytest

from onika.host.units.unit_registry import Units
from onika.host.units.virtual import VirtualDriver
from onika.host.units.wall import WallDriver


@pytest.mark.parametrize("driver", [VirtualDriver, WallDriver])
def test_every_driver_is_asked_in_the_same_way(driver):  # law 28
    wanted = {name: call for name, call in vars(Units).items() if inspect.isfunction(call) and not name.startswith("_")}
    assert wanted.keys() == {"send", "grant", "release"}
    for name, call in wanted.items():
        found = inspect.signature(getattr(driver, name))
        kinds = [one.annotation for one in inspect.signature(call).parameters.values()]
        assert [one.annotation for one in found.parameters.values()] == kinds
        assert found.return_annotation == inspect.signature(call).return_annotation
