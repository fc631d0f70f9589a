import inspect

import pytest

from kit.runtime.live_edits import LossyDriver
from onika.host.subsystems.subsystem_registry import Subsystems
from onika.host.units.unit_listener import UnitListener

WORDS = sorted(name for name in vars(UnitListener) if not name.startswith("_"))


@pytest.mark.parametrize("listener", [Subsystems, LossyDriver])
@pytest.mark.parametrize("name", WORDS)
def test_whoever_listens_hears_the_same(listener, name):  # law 1
    wanted, given = vars(UnitListener)[name], inspect.getattr_static(listener, name)
    assert type(given) is type(wanted)
    if inspect.isfunction(wanted):
        assert list(inspect.signature(given).parameters) == list(inspect.signature(wanted).parameters)


def test_there_is_something_to_hear():
    assert {"hear", "lost", "tick", "wake_at", "is_moving"} <= set(WORDS)
