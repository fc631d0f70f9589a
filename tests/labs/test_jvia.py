"""The joint path through a point on the way."""

import numpy as np
import pytest

from onika.laws import puma560
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

CODE = shipped() / "generic" / "module" / "jvia.py"
CONSTANTS = {"NDOF": 6, "QMIN": puma560.QMIN, "QMAX": puma560.QMAX, "Q^_MAX": puma560.QDMAX}
HOME = puma560.HOME
VIA = HOME + np.array([0.3, 0.2, -0.1, 0.0, 0.1, 0.0])
END = HOME + np.array([0.6, 0.0, -0.2, 0.0, 0.2, 0.1])


def jvia():
    bench = Bench(CODE, frequency=250, constants=CONSTANTS).init()
    bench["Q_MEZ"] = HOME
    return bench


def line(via=VIA, first=1.5, end=END, second=2.0):
    return " ".join(map(str, [*via, first, *end, second]))


def follow(bench):
    """The arm follows exactly; the references, cycle by cycle."""
    path, speeds = [bench["Q_REF"]], [bench["Q^_REF"]]
    while bench.state is State.ON:
        bench["Q_MEZ"] = bench["Q_REF"]
        bench.cycle()
        path.append(bench["Q_REF"])
        speeds.append(bench["Q^_REF"])
    return np.array(path), np.array(speeds)


def test_it_passes_the_first_target_on_time_without_a_stop_and_ends_at_the_second():  # R-D13
    path, speeds = follow(jvia().on(line()))
    assert path[0] == pytest.approx(HOME)
    assert path[375] == pytest.approx(VIA)
    assert speeds[375][0] > 0.1
    assert path[-1] == pytest.approx(END)
    assert np.abs(speeds[-1]).max() < 1e-9


def test_it_ends_when_the_time_is_over_and_the_arm_stands_there():  # R-E03
    bench = jvia().on(line())
    follow(bench)
    assert bench.finished.flow == 0
    assert bench.cycles == pytest.approx(3.5 * 250, abs=2)


@pytest.mark.parametrize(("short_by", "state"), [(0.04, State.OFF), (0.06, State.ERROR)])
def test_an_arm_that_does_not_arrive_is_given_some_time_and_no_more(short_by, state):  # R-X06
    bench = jvia().on(line())
    bench["Q_MEZ"] = END - np.array([short_by, 0.0, 0.0, 0.0, 0.0, 0.0])
    bench.cycle(round(3.5 * 250 + 0.4 * 250))
    assert bench.state is State.ON
    bench.cycle(50)
    assert bench.state is state


def test_times_that_are_too_short_are_warned_of_and_take_longer():
    bench = jvia().on(line(first=0.1, second=0.1))
    assert "0.2 s is too short for the joint speeds" in bench.warnings[0]
    follow(bench)
    assert bench.cycles * 0.004 > 0.3


@pytest.mark.parametrize("name", ["via", "endpoint"])
def test_a_point_out_of_reach_asks_again(name):
    far = HOME + np.array([9.0, 0, 0, 0, 0, 0])
    bench = jvia().on(line(**({"via": far} if name == "via" else {"end": far})))
    assert bench.state is State.ASKING
    assert name in bench.why
