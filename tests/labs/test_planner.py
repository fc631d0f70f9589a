"""The trajectory that asks an outside path planner (Figure 23)."""

import numpy as np
import pytest

from onika.laws import puma560
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench
from onika.testing.fake_partner import FakePartner

CODE = shipped() / "generic" / "module" / "planner.py"
CONSTANTS = {"NDOF": 6, "QMIN": puma560.QMIN, "QMAX": puma560.QMAX, "Q^_MAX": puma560.QDMAX}
HOME = puma560.HOME
VIA = HOME + np.array([0.3, 0.2, -0.1, 0.0, 0.1, 0.0])
END = HOME + np.array([0.6, 0.0, -0.2, 0.0, 0.2, 0.1])


@pytest.fixture
def outsider(tmp_path):
    with FakePartner(tmp_path) as made:
        yield made


@pytest.fixture
def bench(outsider):
    local = {"PARTNER": outsider.address, "PATIENCE": 10.0}
    bench = Bench(CODE, frequency=250, constants=CONSTANTS, local=local).init()
    bench["Q_MEZ"] = HOME
    return bench.on(" ".join(map(str, [*END, 3.0])))


def follow(bench):
    path = [bench["Q_REF"]]
    while bench.state is State.ON:
        bench["Q_MEZ"] = bench["Q_REF"]
        bench.cycle()
        path.append(bench["Q_REF"])
    return np.array(path)


def test_it_asks_for_a_path_within_the_limits_and_stays_until_it_is_answered(bench, outsider):  # R-F04
    question = outsider.accept().read()
    assert question["ask"] == "path"
    wanted = {"start": HOME, "end": END, "low": puma560.QMIN, "high": puma560.QMAX}
    assert all(question[name] == pytest.approx(list(values)) for name, values in wanted.items())
    assert bench.cycle(100)["Q_REF"] == pytest.approx(HOME)
    assert bench.state is State.ON


def test_it_goes_by_the_points_that_the_planner_names_and_ends_at_the_target(bench, outsider):  # R-F04, R-D13
    call = outsider.accept()
    call.answer(call.read(), via=[VIA.tolist()])
    path = follow(bench)
    assert bench.finished is not None, bench.why
    assert min(np.abs(path - VIA).max(axis=1)) < 1e-6
    assert path[-1] == pytest.approx(END)
    assert bench.cycles == pytest.approx(3.0 * 250, abs=4)
    assert np.abs(np.diff(path, axis=0)).max() * 250 < 0.6 * max(puma560.QDMAX)


def test_without_points_it_goes_straight(bench, outsider):
    call = outsider.accept()
    call.answer(call.read(), via=[])
    path = follow(bench)
    shares = (path - HOME)[:, [0, 2, 4, 5]] / (END - HOME)[[0, 2, 4, 5]]
    assert np.ptp(shares, axis=1).max() < 1e-9


LIES = {
    "a wrong number of joints": [[0.0] * 5],
    "one point too few brackets": [0.0] * 6,
    "texts": [["0"] * 6],
    "nothing": None,
    "null for a number": [[None] * 6],
    "far out of reach": [[9.0, 0, 0, 0, 0, 0]],
    "more than a double can hold": [[10**400, 0, 0, 0, 0, 0]],
}


@pytest.mark.parametrize("lie", LIES.values(), ids=LIES.keys())
def test_a_planner_that_lies_moves_nothing(bench, outsider, lie):  # R-F04
    call = outsider.accept()
    call.answer(call.read(), via=lie)
    bench.cycle()
    assert bench.state is State.ERROR
    assert "expected" in bench.failed.text
    assert bench["Q_REF"] == pytest.approx(HOME)


@pytest.mark.parametrize("number", ["NaN", "Infinity", "1e999"])
def test_what_is_no_finite_number_moves_nothing(bench, outsider, number):  # R-F04, law 5
    call = outsider.accept()
    question = call.read()
    call.say(f'{{"id": {question["id"]}, "via": [[{number}, 0, 0, 0, 0, 0]]}}\n'.encode())
    bench.cycle()
    assert bench.state is State.ERROR
    assert bench["Q_REF"] == pytest.approx(HOME)


def test_a_planner_that_finds_no_way_says_why(bench, outsider):
    call = outsider.accept()
    call.answer(call.read(), error="no way found round the balls")
    bench.cycle()
    assert bench.failed.text.endswith("it says: no way found round the balls")


def test_a_time_that_is_too_short_is_warned_of_and_takes_longer(outsider):
    bench = Bench(CODE, frequency=250, constants=CONSTANTS, local={"PARTNER": outsider.address}).init()
    bench["Q_MEZ"] = HOME
    bench.on(" ".join(map(str, [*END, 0.1])))
    call = outsider.accept()
    call.answer(call.read(), via=[VIA.tolist()])
    follow(bench)
    assert "0.1 s is too short for the joint speeds" in bench.warnings[0]
    assert bench.cycles > 0.3 * 250
