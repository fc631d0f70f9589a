import inspect

import pytest

from onika.host.units.served_views import ServedViews
from onika.host.units.world_buses import Buses
from onika.host.units.world_views import WorldViews

WORDS = sorted(name for name in vars(WorldViews) if not name.startswith("_"))


@pytest.mark.parametrize("views", [Buses, ServedViews])
@pytest.mark.parametrize("word", WORDS)
def test_worlds_are_looked_at_with_the_same_words_in_wall_and_in_virtual_time(views, word):  # law 1
    wanted, given = inspect.getattr_static(WorldViews, word), inspect.getattr_static(views, word, None)
    assert inspect.isfunction(given)
    assert len(inspect.signature(given).parameters) == len(inspect.signature(wanted).parameters)


def test_there_is_something_to_look_at():
    assert {"scene", "poses", "picture"} <= set(WORDS)
