import math

import numpy as np
import pytest

from onika.module import InVar
from onika.ring.slots import Ring
from onika.runtime.error import LawBroken
from onika.runtime.transfer.bumpless_channel import BumplessChannel

MOST = 50


class Wire:
    """A variable, the buffer a task reads it from, and its channel."""

    def __init__(self, limit, count=2):
        view = memoryview(bytearray(Ring.footprint(8 * count)))
        self.ring = Ring(view, 0, 8 * count)
        self.data = np.zeros(count)
        self.channel = BumplessChannel("TAU", "TAU", InVar(f"double[{count}]", "N m"), self.data, self.ring, limit)

    def passes(self, *values, now=0):
        """What the task is given in the next cycle."""
        self.ring.write(np.array(values, dtype=float).tobytes())
        self.channel.keep()
        self.channel.pass_on(now, MOST)
        return [round(float(value), 9) for value in self.data]


def test_the_step_that_is_the_largest_share_of_its_limit_is_told():  # R-X04
    wire = Wire(np.array([1.0, 10.0]))
    wire.passes(0.5, 2.0, now=7)
    seen = wire.channel.take("s", "arm")
    assert (seen.variable, seen.unit, seen.index, seen.step, seen.given, seen.limit) == ("TAU", "N m", 0, 0.5, 0.5, 1.0)
    assert (seen.cycles, seen.at_ns) == (0, 7)
    assert wire.channel.take("s", "arm") is None


def test_a_step_is_taken_back_evenly_while_the_new_value_goes_its_own_way():  # R-X04
    wire = Wire(1.0, 1)
    given = [wire.passes(3.0 + 0.1 * count)[0] for count in range(8)]
    steps = np.diff([0.0, *given])
    assert steps == pytest.approx([0.5, *[0.6] * 5, 0.1, 0.1])
    assert given[-1] == 3.7
    assert wire.channel.take("s", "arm").cycles == 6


def test_what_steps_on_while_it_is_blended_goes_no_farther_in_a_cycle():  # R-X04
    wire = Wire(1.0, 1)
    given = [0.0, *(wire.passes(value)[0] for value in [3.0, 3.0, 9.0, -5.0, *[-5.0] * 20])]
    assert max(abs(np.diff(given))) <= 1.0 + 1e-9
    assert given[-1] == -5.0


def test_what_runs_away_while_it_is_blended_is_refused_in_time():  # R-X04
    wire = Wire(1.0, 1)
    with pytest.raises(
        LawBroken, match=r"TAU would step by 50.. N m: a cycle may change it by 1 N m, 0\.1 s by 50 N m"
    ):
        for count in range(200):
            wire.passes(3.0 + 2.0 * count)
    assert wire.channel.take("s", "arm").cycles == 0


def test_a_value_is_objected_to_before_anybody_sees_it():  # R-X04
    wire = Wire(np.array([1.0, 10.0]))
    wire.passes(0.5, 0.0)
    assert not wire.channel.objection(np.array([50.5, 500.0]), MOST)
    objection = wire.channel.objection(np.array([0.5, -501.0]), MOST)
    assert str(objection).startswith("TAU[1] would step by 501 N m")
    assert list(wire.data) == [0.5, 0.0]


def test_elements_may_step_as_far_as_they_like_beside_others_that_may_not():  # R-X04
    wire = Wire(np.array([math.inf, 1.0]))
    assert wire.passes(1e6, 0.5) == [1e6, 0.5]
    assert wire.passes(0.0, 2.5)[1] < 2.0


def test_nothing_new_is_no_step():  # R-X04
    wire = Wire(1.0, 1)
    wire.passes(0.5)
    wire.channel.keep()
    assert wire.channel.pass_on(1, MOST) is False
    assert wire.channel.take("s", "arm").step == 0.5


def test_a_rough_course_is_cut_as_long_as_it_is_watched_and_then_goes_its_own_way():  # R-X04
    wire = Wire(1.0, 1)
    given = [0.0]
    for count in range(100):
        wire.ring.write(np.array([5.0 * (count // 10 % 2)]).tobytes())
        wire.channel.keep()
        is_blended = wire.channel.pass_on(count, MOST, is_bounded=count < 60)
        given.append(float(wire.data[0]))
    assert max(abs(np.diff(given[:60]))) <= 1.0 + 1e-9
    assert is_blended is False
    assert given[-1] == 5.0


def test_after_a_hold_it_steps_from_what_has_the_device_stay():  # R-X04
    wire = Wire(1.0, 1)
    wire.ring.write(np.array([5.0]).tobytes())
    wire.channel.keep()
    wire.channel.come_from(4.5)
    assert wire.channel.pass_on(0, MOST) is False
    assert wire.channel.take("s", "arm").step == 0.5
    wire.ring.write(np.array([90.0]).tobytes())
    wire.channel.keep()
    wire.channel.come_from(None)
    assert wire.channel.pass_on(0, MOST) is False
    assert wire.channel.take("s", "arm").step == 0.0
