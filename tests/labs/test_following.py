"""The watch on how an arm follows its reference."""

import numpy as np
import pytest

from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

CODE = shipped() / "control" / "module" / "following.py"
ARM = {"NDOF": 2, "Q^_MAX": [1.0, 2.0]}


def followed(measured, cycles=100, *, is_stale=False, **local):
    """After so many cycles of 10 ms of a reference at 0.5 rad/s in both joints, measured as the function says."""
    bench = Bench(CODE, frequency=100, constants=ARM, local=local).init()
    bench["Q_MEZ"] = measured(0)
    if is_stale:
        bench["Q_REF"] = [9.0, 9.0]
        bench.forget("Q_REF")
    bench.on()
    for k in range(1, cycles + 1):
        if bench.state is not State.ON:
            break
        if not is_stale:
            bench["Q_REF"] = [0.005 * k, 0.005 * k]
        bench["Q_MEZ"] = measured(k)
        bench.cycle()
    return bench


def true(k):
    return np.full(2, 0.005 * k)


def test_an_arm_that_follows_is_left_alone():  # R-X14
    assert followed(true).state is State.ON


@pytest.mark.parametrize(
    ("measured", "sentence", "cycle"),
    [
        (
            lambda k: [0.005 * k, 0.005 * k + 0.05 * (k == 30)],
            "joint 2 is measured to move at 5.50 rad/s, and can move at 2",
            30,
        ),
        (lambda k: true(min(k, 30)), "nothing measured has changed for 0.100 s", 40),
        (lambda k: [0.005 * k, 0.005 * min(k, 30)], "joint 2 is measured to stand still for 0.100 s", 40),
        (lambda k: 0.7 * true(k), "joint 1 is measured 0.101 rad from where it is to be, 0.1 rad are allowed", 67),
    ],
)
def test_what_cannot_be_true_is_an_error_that_names_it(measured, sentence, cycle):  # R-X14
    bench = followed(measured)
    assert bench.state is State.ERROR
    assert sentence in bench.why
    assert bench.cycles == cycle


def test_how_much_is_allowed_is_a_parameter():
    assert followed(lambda k: 0.7 * true(k), AWAY=0.2).state is State.ON
    assert followed(lambda k: true(min(k, 12)), 25, SILENT=0.2).state is State.ON


def test_an_arm_that_is_not_asked_to_move_may_stand_still():
    bench = Bench(CODE, frequency=100, constants=ARM).init()
    assert bench.on().cycle(500).state is State.ON


def test_nobody_is_away_from_a_reference_of_before_the_last_hold():  # law 3
    assert followed(lambda k: np.zeros(2), is_stale=True).state is State.ON
