import msgspec
import pytest

from onika.wire.figures import TaskFigures, VariableSteps

STEPS = VariableSteps("flow0", "puma", "TAU_REF", "N m", 19, 1, 40.0, 9.0, 9.76, 1.5, 2, 6, 1)
FIGURES = TaskFigures("flow0", "pd", "rt0", 500.0, 1000, 2, 4.5, 20.0)


@pytest.mark.parametrize("message", [STEPS, FIGURES], ids=lambda message: type(message).__name__)
def test_figures_travel_whole(message):  # R-E14, X04
    assert msgspec.msgpack.decode(msgspec.msgpack.encode(message), type=type(message)) == message


def test_steps_that_were_never_blended_or_refused_say_so():  # X04
    steps = VariableSteps("flow0", "puma", "TAU_REF", "N m", 19, 1, 40.0, 40.0, 50.0, 1.5)
    assert (steps.blended, steps.cycles, steps.refused) == (0, 0, 0)
