import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.model.task import Task
from onika.wire import act, booking, request
from onika.wire.booking import STEP_S
from onika.words.reason import Reason

NOW_S = 1_000_000 * STEP_S + 7.0
MINE = booking.Booking(3, "ann", int(NOW_S), int(NOW_S) + 893, "finish", "welding")


@pytest.fixture
def duet(tmp_path):
    env = FakeRuntimeEnv(tmp_path, (Task("a", "a", outvar=("A",), frequency=10.0),))
    env.connected("a")
    env.rebuffs = {booking.Bookings: booking.BookingList("arm", NOW_S, "ann", (MINE,), True)}
    return env


def refuses(duet, kind):
    duet.rebuffs = {**duet.rebuffs, kind: request.Refused(Reason.of("booking.too_many", most=8))}


def test_what_is_booked_is_shown_with_the_time_at_the_robots_site(duet):  # R-F09
    assert duet.do(act.LookAtBookings()) is None
    book = duet.environment.tree.runtime.book
    assert (book.robot, book.you, book.now_s, book.is_needed) == ("arm", "ann", NOW_S, True)
    assert [(known.number, known.user, known.late, known.note) for known in book.bookings] == [
        (3, "ann", "finish", "welding")
    ]
    duet.do(act.Company())
    assert duet.environment.tree.runtime.book == book


def test_a_runtime_without_bookings_says_so_and_shows_none(duet):  # R-F09
    duet.rebuffs = {booking.Bookings: request.Refused(Reason.of("booking.nothing"))}
    assert duet.do(act.LookAtBookings()).key == "booking.nothing"
    assert duet.environment.tree.runtime.book is None


def test_what_is_booked_from_now_on_begins_by_the_clock_of_the_site_and_ends_at_a_step(duet):  # R-F09
    duet.rebuffs = {**duet.rebuffs, booking.Book: booking.Booked(MINE)}
    duet.do(act.BookRobot(900, late="finish", note="welding"))
    begin_s = int(NOW_S)
    end_s = 1_000_000 * STEP_S + 4 * STEP_S
    assert booking.Book(begin_s, end_s, "finish", "welding") in duet.carried_out
    assert duet.environment.tree.runtime.book.bookings[0].number == 3


def test_what_is_booked_for_later_begins_when_it_was_said(duet):  # R-F09
    duet.rebuffs = {**duet.rebuffs, booking.Book: booking.Booked(MINE)}
    duet.do(act.BookRobot(1800, begin_s=1_000_010 * STEP_S))
    assert booking.Book(1_000_010 * STEP_S, 1_000_016 * STEP_S) in duet.carried_out


def test_a_booking_lasts_longer_or_is_taken_back_and_what_is_left_is_shown(duet):  # R-F09
    duet.rebuffs = {**duet.rebuffs, booking.ExtendBooking: booking.Booked(MINE)}
    duet.do(act.ProlongBooking(3, 1_000_006 * STEP_S))
    assert booking.ExtendBooking(3, 1_000_006 * STEP_S) in duet.carried_out
    duet.rebuffs = {
        booking.Bookings: booking.BookingList("arm", NOW_S, "ann"),
        booking.CancelBooking: request.Done(),
    }
    duet.do(act.TakeBackBooking(3))
    assert duet.environment.tree.runtime.book.bookings == ()


@pytest.mark.parametrize(
    ("kind", "command"),
    [
        (booking.Book, act.BookRobot(900)),
        (booking.ExtendBooking, act.ProlongBooking(3, 600)),
        (booking.CancelBooking, act.TakeBackBooking(3)),
        (booking.Bookings, act.BookRobot(900)),
    ],
)
def test_what_the_runtime_refuses_is_said_in_its_words(duet, kind, command):  # R-F09
    refuses(duet, kind)
    assert duet.answer(command).no.reason.key == "booking.too_many"
