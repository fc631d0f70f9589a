import math
import struct

import pytest
from hypothesis import given, strategies as st

from onika.host.diagnosis.variable_history import MOST_NUMBERS, VariableHistory
from onika.ring.segment import Segment
from onika.runtime.table import Table
from onika.words.shape import Shape

MS = 1_000_000


class Place:
    """A table whose variables are written by hand, and its history."""

    def __init__(self, every_ns=50 * MS, kept_ns=200 * MS, began_ns=0):
        self.table = Table(Segment.create("history", 1 << 20))
        self.history = VariableHistory({"flow0": self.table}, every_ns, kept_ns, began_ns)

    def has(self, name, shape="double"):
        self.table.entry(name, Shape.parse(shape))
        return self

    def write(self, name, *values):
        code = self.table.entries[name].shape.type.code
        self.table.ring(name).write(struct.pack(f"={len(values)}{code}", *values))
        return self

    def course(self, name):
        points = self.history.course("flow0", name)
        return None if points is None else list(zip(points.at_s, points.values, strict=True))


@pytest.fixture
def place():
    return Place()


def test_a_variable_is_sampled_on_a_grid_of_time(place):  # R-X06
    place.has("X").write("X", 1.5)
    place.history.tick(10 * MS)
    place.write("X", 2.5)
    for now in (20, 49, 50, 60, 100):
        place.history.tick(now * MS)
    assert place.course("X") == [(0.01, 1.5), (0.05, 2.5), (0.1, 2.5)]
    assert place.history.wake_at() == 150 * MS


def test_times_count_from_the_beginning_of_the_run():  # R-X06
    place = Place(began_ns=1000 * MS).has("X").write("X", 1.0)
    place.history.tick(1050 * MS)
    assert place.course("X") == [(0.05, 1.0)]


def test_what_is_older_than_is_kept_is_forgotten(place):  # R-X06
    place.has("X")
    for now in range(0, 1000, 50):
        place.write("X", float(now)).history.tick(now * MS)
    assert place.course("X") == [
        (milliseconds / 1000, float(milliseconds)) for milliseconds in (750, 800, 850, 900, 950)
    ]


def test_nothing_is_said_of_what_was_never_written_or_is_unknown(place):  # R-X06
    place.has("X").history.tick(0)
    assert place.course("X") is None
    assert place.course("Y") is None
    assert place.history.course("flow7", "X") is None


def test_a_course_begins_with_the_first_value_that_was_written(place):  # R-X06
    place.has("X").has("Y").write("Y", 1.0)
    place.history.tick(0)
    place.write("X", 3.0).history.tick(50 * MS)
    assert place.course("X") == [(0.05, 3.0)]
    assert place.course("Y") == [(0.0, 1.0), (0.05, 1.0)]


def test_variables_that_come_later_are_taken_up(place):  # R-X06
    place.has("X").write("X", 1.0).history.tick(0)
    place.has("Q", "double[2]").write("Q", 1.0, 2.0).history.tick(50 * MS)
    place.has("N", "int").write("N", 7).history.tick(100 * MS)
    assert place.course("Q") == [(0.05, [1.0, 2.0]), (0.1, [1.0, 2.0])]
    assert place.course("N") == [(0.1, 7)]
    assert len(place.course("X")) == 3


@pytest.mark.parametrize(
    ("shape", "is_sampled"),
    [("double[64]", True), ("double[65]", False), ("byte[8]", True), ("string", False), ("char", False)],
)
def test_only_numbers_and_not_too_many_of_them_are_sampled(place, shape, is_sampled):  # R-X06
    place.has("X", shape)
    place.table.ring("X").write(bytes(Shape.parse(shape).size))
    place.history.tick(0)
    assert (place.course("X") is not None) is is_sampled
    assert MOST_NUMBERS == 64


def test_a_look_out_of_time_is_the_last_one_and_does_not_move_the_grid(place):  # R-X06
    place.has("X").write("X", 1.0).history.tick(0)
    place.write("X", 2.0).history.look(30 * MS)
    assert place.course("X")[-1] == (0.03, 2.0)
    assert place.history.wake_at() == 50 * MS


def test_a_second_look_at_the_same_instant_sees_what_has_changed_in_it(place):  # R-X06
    place.has("X").write("X", 1.0).history.tick(0)
    place.write("X", math.inf).has("Y").write("Y", 5.0).history.look(0)
    assert place.course("X") == [(0.0, math.inf)]
    assert place.course("Y") == [(0.0, 5.0)]


def test_it_sleeps_where_nothing_changes_and_wakes_with_the_next_news(place):  # R-X06
    place.has("X").write("X", 1.0)
    for now in range(0, 1000, 50):
        place.history.tick(now * MS)
    assert place.history.wake_at() is None
    place.history.tick(2010 * MS)
    assert place.history.wake_at() is None
    place.write("X", 2.0).history.tick(2060 * MS)
    assert place.history.wake_at() == 2100 * MS


def test_it_sleeps_where_there_is_nothing_to_see(place):  # R-X06
    assert place.history.wake_at() is None
    place.history.tick(0)
    assert place.history.wake_at() is None
    place.has("X").history.tick(70 * MS)
    assert place.history.wake_at() == 100 * MS


def test_a_grid_wider_than_what_is_kept_is_no_history():
    with pytest.raises(ValueError, match="more often than"):
        VariableHistory({}, every_ns=2, kept_ns=1)


@given(st.lists(st.tuples(st.sampled_from("XYZ"), st.integers(0, 3), st.integers(0, 120)), max_size=60))
def test_a_course_is_what_stood_in_the_table_at_each_look(story):  # R-X06
    place, stood, looks, now = Place(), {}, [], 0
    for name, value, later in story:
        now += later
        place.has(name)
        if value:
            place.write(name, float(value))
            stood[name] = float(value)
        place.history.look(now * MS)
        if looks and looks[-1][0] == now:
            looks.pop()
        looks.append((now, dict(stood)))
    for name in "XYZ":
        expected = [(at / 1000, values[name]) for at, values in looks[-5:] if name in values]
        assert (place.course(name) or []) == expected
    place.table.segment.close()
