import inspect

import pytest

from onika.host.driver import Driver
from onika.host.units.virtual import VirtualDriver
from onika.host.units.wall import WallDriver

WORDS = sorted(name for kind in Driver.__mro__ for name in vars(kind) if not name.startswith("_"))


@pytest.mark.parametrize("driver", [VirtualDriver, WallDriver])
@pytest.mark.parametrize("word", WORDS)
def test_wall_and_virtual_time_are_driven_with_the_same_words(driver, word):  # law 1
    wanted, given = inspect.getattr_static(Driver, word), inspect.getattr_static(driver, word, None)
    if inspect.isfunction(wanted):
        assert inspect.isfunction(given)
        assert len(inspect.signature(given).parameters) == len(inspect.signature(wanted).parameters)


def test_there_is_something_to_drive():
    assert {"begin", "advance", "stop", "reset", "touch", "send", "grant"} <= set(WORDS)
