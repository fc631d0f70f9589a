import math

import numpy as np
import pytest

from onika.module import InVar
from onika.ring.slots import Ring
from onika.runtime.error import LawBroken
from onika.runtime.transfer.bumpless_channel import BLENDED_NS, BumplessChannel
from onika.words.reason import NOTHING, Reason

MOST = 50


class Wire:
    """A variable, the buffer a task reads it from, and its channel."""

    def __init__(self, limit, count=2, unit="N m"):
        view = memoryview(bytearray(Ring.footprint(8 * count)))
        self.ring = Ring(view, 0, 8 * count)
        self.data = np.zeros(count)
        self.channel = BumplessChannel("TAU", "PORT", InVar(f"double[{count}]", unit), self.data, self.ring, limit)

    def passes(self, *values, now=0, is_bounded=True):
        """What the task is given in the next cycle."""
        self.ring.write(np.array(values, dtype=float).tobytes())
        self.channel.keep()
        self.channel.pass_on(now, MOST, is_bounded)
        return [round(float(value), 9) for value in self.data]


def test_the_step_that_is_the_largest_share_of_its_limit_is_told():  # R-X04
    wire = Wire(np.array([1.0, 10.0]))
    wire.passes(0.5, 2.0, now=7)
    seen = wire.channel.take("s", "arm")
    assert (seen.variable, seen.unit, seen.index, seen.step, seen.given, seen.limit) == ("TAU", "N m", 0, 0.5, 0.5, 1.0)
    assert (seen.subsystem, seen.task, seen.cycles, seen.at_ns) == ("s", "arm", 0, 7)
    assert (wire.channel.port, BLENDED_NS) == ("PORT", 100_000_000)
    assert wire.channel.take("s", "arm") is None


def test_a_step_is_taken_back_evenly_while_the_new_value_goes_its_own_way():  # R-X04
    wire = Wire(1.0, 1)
    given = [wire.passes(3.0 + 0.1 * count)[0] for count in range(8)]
    steps = np.diff([0.0, *given])
    assert steps == pytest.approx([0.5, *[0.6] * 5, 0.1, 0.1])
    assert given[-1] == 3.7
    seen = wire.channel.take("s", "arm")
    assert (seen.cycles, seen.step, seen.given) == (6, 3.0, pytest.approx(0.6))


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
    assert wire.channel.objection(np.array([50.5, 500.0]), MOST) == NOTHING
    assert Wire(None).channel.objection(np.array([1e9, 0.0]), MOST) == NOTHING
    objection = wire.channel.objection(np.array([0.5, -501.0]), MOST)
    assert str(objection).startswith("TAU[1] would step by 501 N m")
    assert list(wire.data) == [0.5, 0.0]
    assert objection.args["task"] == Reason.of("runtime.the_hardware_task")
    assert objection.args["unit"] == " N m"
    assert wire.channel.objection(np.array([0.5, -501.0]), MOST, "arm").args["task"] == "arm"


def test_elements_may_step_as_far_as_they_like_beside_others_that_may_not():  # R-X04
    wire = Wire(np.array([math.inf, 1.0]))
    assert wire.passes(1e6, 0.5) == [1e6, 0.5]
    assert wire.passes(0.0, 2.5)[1] < 2.0


def test_nothing_new_is_no_step():  # R-X04
    wire = Wire(1.0, 1)
    wire.passes(0.5)
    wire.channel.keep()
    assert wire.channel.pass_on(1, MOST, True) is False
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
    assert wire.channel.pass_on(0, MOST, True) is False
    assert wire.channel.take("s", "arm").step == 0.5
    wire.ring.write(np.array([90.0]).tobytes())
    wire.channel.keep()
    wire.channel.come_from(None)
    assert wire.channel.pass_on(0, MOST, True) is False
    assert wire.channel.take("s", "arm").step == 0.0


@pytest.mark.parametrize(("unit", "said"), [("N m", "TAU would step by 51 N m"), ("-", "TAU would step by 51: ")])
def test_a_number_without_a_unit_is_said_without_one(unit, said):
    with pytest.raises(LawBroken) as broken:
        Wire(1.0, 1, unit).passes(51.0)
    assert said in str(broken.value)


def test_a_step_of_its_limit_is_passed_on_as_it_is_and_one_beyond_is_not():  # R-X04
    assert Wire(1.0, 1).passes(1.0) == [1.0]
    assert Wire(1.0, 1).passes(1.000001)[0] < 0.3


def test_a_step_of_all_that_a_blend_can_take_is_blended_and_one_beyond_is_refused():  # R-X04
    assert Wire(1.0, 1).passes(50.0) == [1.0]
    wire = Wire(1.0, 1)
    with pytest.raises(LawBroken):
        wire.passes(50.000001)
    seen = wire.channel.take("s", "arm")
    assert (seen.step, seen.given, seen.cycles) == (50.000001, 0.0, 0)


def test_of_what_was_refused_nothing_was_given_whatever_was_given_before():  # R-X04
    wire = Wire(1.0, 1)
    wire.passes(0.5)
    wire.channel.take("s", "arm")
    with pytest.raises(LawBroken):
        wire.passes(90.0)
    assert wire.channel.take("s", "arm").given == 0.0


def test_of_equal_steps_the_first_is_told():  # R-X04
    wire = Wire(np.array([1.0, 8.0]))
    for now, values in enumerate([(0.5, 0.0), (0.5, 4.0)]):
        wire.passes(*values, now=now)
    seen = wire.channel.take("s", "arm")
    assert (seen.index, seen.step, seen.given, seen.at_ns) == (0, 0.5, 0.5, 0)


@pytest.mark.parametrize(
    ("target", "given", "following"),
    [(9.0, 1.5, 9.0 - 7.5 * 15 / 16), (-9.0, -0.5, -9.0 + 8.5 * 17 / 18)],
    ids=["up", "down"],
)
def test_what_is_cut_off_is_taken_back_in_twice_as_many_cycles_as_it_takes(target, given, following):  # R-X04
    wire = Wire(1.0, 1)
    assert wire.passes(3.0) == [0.5]
    assert wire.passes(target) == [given]
    assert wire.passes(target) == [pytest.approx(following)]
    cycles = 3
    while wire.data[0] != target:
        wire.passes(target)
        cycles += 1
    assert cycles == 2 + (16 if target > 0 else 18)


def test_what_is_cut_off_may_be_all_that_a_blend_can_take_and_no_more():  # R-X04
    wire = Wire(1.0, 1)
    wire.passes(3.0)
    assert wire.passes(51.5) == [1.5]
    wire = Wire(1.0, 1)
    wire.passes(3.0)
    with pytest.raises(LawBroken):
        wire.passes(51.500001)


def test_the_element_that_runs_away_farthest_is_named():  # R-X04
    wire = Wire(np.array([1.0, 10.0]))
    wire.passes(3.0, 0.0)
    with pytest.raises(LawBroken, match=r"TAU\[1\] would step by"):
        wire.passes(3.0, 1000.0)


def test_a_step_of_just_its_limit_in_the_midst_of_a_blend_makes_it_no_longer():  # R-X04
    wire = Wire(1.0, 1)
    assert [wire.passes(value)[0] for value in (3.0, 3.0, 3.5)] == [0.5, 1.0, 2.0]
    assert [wire.passes(3.5)[0] for _ in range(3)] == [2.5, 3.0, 3.5]
    assert wire.channel.take("s", "arm").cycles == 6


def test_what_is_no_more_bounded_goes_its_own_way_and_is_told_as_it_went():  # R-X04
    wire = Wire(1.0, 1)
    wire.passes(3.0)
    assert wire.passes(33.0) == [1.5]
    assert wire.passes(33.0) == [pytest.approx(33.0 - 31.5 * 49 / 50)]  # no blend is longer
    before = float(wire.data[0])
    after = wire.passes(33.0 + 1.0, is_bounded=False)[0]
    assert after - before > 1.5
    assert wire.channel.take("s", "arm").given == pytest.approx(after - before)


def test_at_another_rate_a_blend_takes_as_long_as_before():  # R-X04
    wire = Wire(1.0, 1)
    assert wire.passes(3.0) == [0.5]
    wire.channel.change_rate(2.0)
    assert wire.passes(3.0) == [0.75]
    for _ in range(9):
        wire.passes(3.0)
    assert wire.data[0] == 3.0
    assert wire.channel.take("s", "arm").cycles == 12


def test_what_was_taken_is_given_up_and_not_told_again():  # R-X04
    wire = Wire(1.0, 1)
    wire.passes(3.0)
    wire.channel.take("s", "arm")
    assert wire.passes(1.0) == [1.0]
    seen = wire.channel.take("s", "arm")
    assert (seen.step, seen.given, seen.cycles) == (0.5, 0.5, 0)


@pytest.mark.parametrize(
    ("limit", "held", "is_near"),
    [(1.0, 4.0, True), (1.0, 3.9, False), (1.0, 6.1, False), (1.0, None, True), (None, 0.0, True)],
)
def test_whether_a_value_is_within_a_step_of_what_holds_the_device(limit, held, is_near):  # R-X04
    wire = Wire(limit, 1)
    wire.ring.write(np.array([5.0]).tobytes())
    assert wire.channel.come_from(held) is is_near


def test_the_farthest_element_says_whether_a_value_is_near():  # R-X04
    wire = Wire(np.array([1.0, 1.0, 1.0]), 3)
    wire.ring.write(np.array([0.0, 2.0, 0.0]).tobytes())
    assert wire.channel.come_from([0.0, 0.0, 0.0]) is False


def test_where_no_limit_is_known_a_step_is_told_without_one_and_passed_on():  # R-X04
    wire = Wire(None, 1)
    assert wire.passes(100.0) == [100.0]
    seen = wire.channel.take("s", "arm")
    assert (seen.step, seen.given, seen.limit, seen.cycles) == (100.0, 100.0, 0.0, 0)


def test_the_largest_step_that_was_given_is_told_whenever_it_was():  # R-X04
    wire = Wire(1.0, 1)
    assert [wire.passes(value)[0] for value in (3.0, 2.75)] == [0.5, 0.75]
    assert wire.channel.take("s", "arm").given == 0.5


def test_a_little_too_far_in_the_midst_of_a_blend_is_cut_too():  # R-X04
    wire = Wire(1.0, 1)
    assert [wire.passes(value)[0] for value in (3.0, 4.0)] == [0.5, 1.5]


def test_with_twice_the_limit_all_goes_twice_as_far_in_as_many_cycles():  # R-X04
    one, two = Wire(1.0, 1), Wire(2.0, 1)
    for _ in range(20):
        assert [2.0 * value for value in one.passes(9.0)] == two.passes(18.0)
    one, two = Wire(1.0, 1), Wire(2.0, 1)
    for value in [3.0, *[9.0] * 18]:
        assert [2.0 * value for value in one.passes(value)] == two.passes(2.0 * value)
    assert one.channel.take("s", "arm").cycles == two.channel.take("s", "arm").cycles == 18
