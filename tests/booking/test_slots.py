"""Who may move a robot at a moment, by what is booked (F09)."""

import pytest
from hypothesis import given, strategies as st

from onika.booking.slots import CHANGE_S, Slots
from onika.wire.booking import Booking

H = 3600


def slots(*spans, given_away=()):
    """Bookings of these users from hour to hour."""
    bookings = [Booking(n, user, round(a * H), round(b * H)) for n, (user, a, b) in enumerate(spans, 1)]
    return Slots(bookings, frozenset(given_away))


def may(known, user, hour, **needed):
    return not known.refusal(user, hour * H, is_needed=needed.get("is_needed", False))


def test_while_a_robot_is_booked_only_its_user_moves_it():  # R-F09
    known = slots(("ann", 1, 2))
    assert [may(known, "ann", hour) for hour in (0.5, 1, 1.99, 2)] == [True, True, True, True]
    assert [may(known, "bob", hour) for hour in (0.5, 1, 1.99, 2)] == [True, False, False, True]
    assert "booked for ann until 1970-01-01 02:00 UTC" in str(known.refusal("bob", H, is_needed=False))


def test_where_booking_is_needed_nobody_moves_it_without():  # R-F09
    known = slots(("ann", 1, 2))
    assert [may(known, "ann", hour, is_needed=True) for hour in (0.5, 1, 2)] == [False, True, False]


def test_before_anothers_time_the_robot_is_left_alone_and_before_ones_own_it_is_not():  # R-F09
    known = slots(("ann", 1, 2), ("ann", 2, 3), ("bob", 3, 4))
    last = 3 - CHANGE_S / H
    assert may(known, "ann", 1.9999)
    assert may(known, "ann", last - 0.001)
    assert not may(known, "ann", last)
    assert not may(known, "bob", last), "it is being parked"
    assert "left for bob" in str(known.refusal("ann", last * H, is_needed=False))
    assert may(known, "bob", 3)


def test_time_that_was_given_away_is_nobodys():  # R-F09
    known = slots(("ann", 1, 2), given_away=[1])
    assert may(known, "bob", 1.5)
    assert known.next_after(0.5 * H) is None


def test_what_comes_next_is_known():  # R-F09
    known = slots(("bob", 3, 4), ("ann", 1, 2))
    assert known.next_after(0).user == "ann"
    assert known.next_after(H).user == "bob"
    assert known.next_after(3 * H) is None


@given(st.lists(st.tuples(st.sampled_from("abc"), st.integers(1, 3)), max_size=6), st.integers(0, 20 * 60))
def test_at_no_moment_two_users_may_move_what_is_booked(spans, minute):  # R-F09
    begin, known = 0, []
    for user, length in spans:
        known.append((user, begin, begin + length))
        begin += length
    slots_of_all = slots(*known)
    at = minute / 60
    users = [user for user in "abc" if may(slots_of_all, user, at, is_needed=True)]
    assert len(users) <= 1
    if users:
        assert any(user == users[0] and a <= at < b for user, a, b in known)


@pytest.mark.parametrize("gap_min", [0, 2])
def test_a_pause_that_is_there_anyway_costs_nobody_a_minute(gap_min):  # R-F09
    known = slots(("ann", 1, 2), ("bob", 2 + gap_min / 60, 3))
    assert may(known, "ann", 2 - 0.5 / 60) == bool(gap_min)
