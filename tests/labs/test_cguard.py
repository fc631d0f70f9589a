"""The straight line of the tool that ends where it meets something."""

import numpy as np
import pytest

from onika.laws.frames import pose_of_nine
from onika.model.lifecycle import State
from onika.store.shipped import shipped
from onika.testing.bench import Bench

CODE = shipped() / "generic" / "module" / "cguard.py"
HERE = pose_of_nine([0, 0, -1, 0, 1, 0, 0.7, 0.28, -0.1])
DOWN = "0 0 -1 0 1 0 0.7 0.28 -0.2"
SPRING = 20_000.0
"""N/m: how stiff an arm presses."""


class Floor:
    """A guarded motion above a floor on which the arm presses as a spring; above it, it stands where it is to."""

    def __init__(self, height, carried=0.0, **local):
        self.height, self.carried, self.most = height, carried, 0.0
        self.bench = Bench(CODE, frequency=250, local=local).init()
        self.stand(HERE)

    def stand(self, wanted):
        place = wanted.copy()
        place[2, 3] = max(wanted[2, 3], self.height)
        press = SPRING * (place[2, 3] - wanted[2, 3])
        self.most = max(self.most, press)
        self.bench["X_MEZ"], self.bench["F_MEZ"] = place, [0.0, 0.0, press - self.carried, 0.0, 0.0, 0.0]

    def go(self, line):
        self.bench.on(line)
        while self.bench.state is State.ON:
            self.stand(self.bench["X_REF"])
            self.bench.cycle()
        self.stand(self.bench["X_REF"])
        return self.bench


def test_where_nothing_is_in_its_way_the_tool_comes_to_the_target():  # R-D25
    floor = Floor(-1.0)
    bench = floor.go(f"{DOWN} 10 20 10")
    assert bench["X_REF"] == pytest.approx(pose_of_nine([float(word) for word in DOWN.split()]))
    assert (bench.finished.flow, bench.finished.loop, bench.warnings) == (0, False, [])
    assert bench.cycles == pytest.approx(2500, abs=2)


@pytest.mark.parametrize("limit", [15.0, 60.0])
def test_what_is_met_ends_the_motion_and_is_pressed_on_with_so_much_at_most(limit):  # R-D25
    floor = Floor(-0.15)
    bench = floor.go(f"{DOWN} 10 {limit} 10")
    assert (bench.finished.flow, bench.finished.loop) == (1, False)
    assert floor.most <= limit + 6.0  # what it goes on while it turns back
    assert SPRING * (-0.15 - bench["X_REF"][2, 3]) <= limit / 2 + 1e-6
    assert bench.warnings[0].startswith("the tool met something at x = 70.0, y = 28.0, z = -15.0 cm, with ")


def test_what_is_carried_is_no_obstacle():  # R-D25
    floor = Floor(-1.0, carried=25.0)
    assert floor.go(f"{DOWN} 10 15 10").finished.flow == 0


def test_what_twists_the_tool_ends_it_too():  # R-D25
    floor = Floor(-1.0)
    bench = floor.bench.on(f"{DOWN} 10 30 3").cycle(500)
    bench["F_MEZ"] = [0.0, 0.0, 0.0, 0.0, 3.5, 0.0]
    bench.cycle()
    bench["F_MEZ"] = np.zeros(6)
    assert bench.cycle(10).finished.flow == 1


def test_it_never_goes_back_beyond_where_it_began():  # R-D25
    floor = Floor(-1.0)
    bench = floor.bench.on(f"{DOWN} 10 30 10").cycle(100)
    bench["F_MEZ"] = [0.0, 40.0, 0.0, 0.0, 0.0, 0.0]
    bench.cycle(600)
    assert bench.state is State.OFF and bench["X_REF"] == pytest.approx(HERE)


def test_the_speed_at_which_force_is_felt_lengthens_a_motion_with_a_warning():  # R-D25
    floor = Floor(-1.0, SPEED=0.05)
    bench = floor.go(f"{DOWN} 1 30 10")
    assert bench.warnings[0].startswith("1 s is too short for a speed at which force is felt")
    assert bench.cycles / 250 == pytest.approx(1.875 * 0.1 / 0.05, abs=0.05)


def test_no_pose_asks_again():  # law 25
    bench = Floor(-1.0).bench.on("0 0 -1 0 0 1 0.7 0.28 -0.2 1 30 10")
    assert bench.state is State.ASKING


def test_a_hand_that_is_blocked_without_being_felt_is_an_error():  # R-X06
    bench = Floor(-1.0).bench.on(f"{DOWN} 10 30 10").cycle(2800)
    assert bench.state is State.ERROR
    assert "the hand did not come to its target" in bench.why
