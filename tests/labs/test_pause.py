"""The pause."""

import pytest

from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

CODE = shipped() / "generic" / "module" / "pause.py"


@pytest.mark.parametrize(("seconds", "cycles"), [(1.0, 50), (0.5, 25), (0.3, 15), (0.0, 1)])
def test_it_ends_when_the_time_is_over(seconds, cycles):  # §4.4.6.1
    bench = Bench(CODE, frequency=50).init().on(str(seconds))
    while bench.state is State.ON:
        bench.cycle()
    assert bench.cycles == cycles
    assert (bench.finished.flow, bench.finished.loop) == (0, False)


def test_what_is_left_can_be_asked_for():  # R-A14
    bench = Bench(CODE, frequency=50).init().on("1.0").cycle(25)
    assert bench.get("left") == pytest.approx(0.5, abs=0.02)


def test_less_than_no_time_there_is_not():
    assert Bench(CODE, frequency=50).init().on("-1.0").state is State.ASKING
