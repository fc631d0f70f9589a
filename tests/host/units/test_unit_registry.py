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
        signature = inspect.signature(getattr(driver, name))
        kinds = [parameter.annotation for parameter in inspect.signature(call).parameters.values()]
        assert [parameter.annotation for parameter in signature.parameters.values()] == kinds
        assert signature.return_annotation == inspect.signature(call).return_annotation
