import math

import pytest

from onika.desk.environment.watching import Watching, homes_of
from onika.model.task import Task
from onika.testing.duet import Duet
from onika.wire import live


@pytest.fixture
def duet(tmp_path):
    return Duet(tmp_path, (Task("a", "a", outvar=("A",), frequency=10.0),))


def test_each_variable_is_asked_for_under_its_subsystem(duet):  # R-C14
    doc, other = duet.connected("a"), duet.new()
    watching = Watching(
        frozenset((f"{doc}/Q^_REF", f"{doc}/A", f"{other}/A", "c9/A", "A")), frozenset(("boxes",)), hz=30.0
    )
    asked = watching.attend(duet.environment.model)
    assert asked == live.Attend(("*",), ("Untitled-1/A", "Untitled-1/Q^_REF"), ("boxes",), 30.0)
    assert homes_of(duet.environment.model) == {doc: "Untitled-1"}


@pytest.mark.parametrize(("wished", "asked"), [(1000.0, 60.0), (0.0, 0.1), (-3.0, 0.1), (math.nan, 0.1)])
def test_nobody_is_shown_more_than_a_screen_can_show(duet, wished, asked):  # R-C14
    assert Watching(hz=wished).attend(duet.environment.model).hz == asked
