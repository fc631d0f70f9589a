"""A motion of joints from its begin to its rest."""

import numpy as np
import pytest

from onika.laws.arrival import Arrival
from onika.laws.joint_motion import JointMotion

DT = 0.125
END = np.array([1.0, -1.0])


class Straight:
    """Evenly to the end in half a second, and there."""

    duration = 0.5

    def at(self, t):
        return min(t / self.duration, 1.0) * END, END / self.duration


@pytest.fixture
def motion():
    return JointMotion(Straight(), END, np.zeros(2), settle=0.25)


def test_it_commands_what_its_path_says_one_cycle_after_the_other(motion):
    places = [motion.advance(DT)[0][0] for _ in range(6)]
    assert places == pytest.approx([0.25, 0.5, 0.75, 1.0, 1.0, 1.0])


def test_its_progress_is_the_share_of_its_time(motion):
    assert motion.progress == 0.0
    motion.advance(DT)
    assert motion.progress == pytest.approx(0.25)
    for _ in range(9):
        motion.advance(DT)
    assert motion.progress == 1.0


def test_it_is_over_when_its_time_is_and_the_joints_rest_or_a_while_later(motion):
    judged, late = Arrival.of_joints(END, np.zeros(2), 0.25), []
    for cycle in range(1, 10):
        motion.advance(DT)
        away = END * 0.9
        late.append(motion.is_over(away, DT))
        assert late[-1] == judged.is_over(cycle * DT - 0.5, away, DT)
    assert late.index(True) == 5


def test_a_joint_that_stayed_away_is_told_with_its_number(motion):
    assert motion.short(END, 0.05) is None
    assert "joint 2 is 0.30 rad" in str(motion.short(np.add(END, [0.0, 0.3]), 0.05))
