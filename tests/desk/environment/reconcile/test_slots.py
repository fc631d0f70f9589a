import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.model.task import Task
from onika.wire import booking, event, holding


@pytest.fixture
def duet(tmp_path):
    env = FakeRuntimeEnv(tmp_path, (Task("a", "a", outvar=("A",), frequency=10.0),))
    env.connected("a")
    env.tell(event.Company((holding.SessionStanding("you", "owner"),)))
    return env


def last(duet):
    return duet.says[-1].level, duet.says[-1].text.key


def test_the_end_of_ones_own_time_is_shown_until_it_is_over(duet):  # R-F09
    duet.tell(event.SlotEnds("you", 600.0, "bob"))
    ends = duet.environment.tree.runtime.slot_ends
    assert (ends.user, ends.follower) == ("you", "bob")
    assert ends.at_s >= 600.0
    assert last(duet) == ("warning", "booking.ends")
    assert booking.Bookings() in duet.carried_out
    duet.tell(event.SlotEnds("you", 0.0, "bob"))
    assert duet.environment.tree.runtime.slot_ends is None
    assert last(duet) == ("warning", "booking.over")


def test_the_end_of_anothers_time_is_only_said(duet):  # R-F09
    duet.tell(event.SlotEnds("bob", 60.0, "you"))
    assert last(duet) == ("info", "booking.ends")


def test_a_clock_that_was_set_is_shown_and_said(duet):  # R-F09
    duet.tell(event.ClockSet(-3600.0))
    assert duet.environment.tree.runtime.clock_set_s == -3600.0
    assert last(duet) == ("warning", "booking.clock_set")


def test_what_is_booked_is_asked_anew_and_an_answer_that_is_none_changes_nothing(duet):  # R-F09
    duet.rebuffs = {booking.Bookings: booking.BookingList("arm", 5.0, "you")}
    duet.tell(event.SlotEnds("you", 60.0, "bob"))
    book = duet.environment.tree.runtime.book
    assert (book.robot, book.now_s) == ("arm", 5.0)
    duet.rebuffs = {}
    duet.tell(event.SlotEnds("you", 59.0, "bob"))
    assert duet.environment.tree.runtime.book == book
