"""At the runtime of a robot: it is moved by whom it is booked for, and stopped by everybody (F09)."""

import pytest

from onika.booking.book import BookingBook
from onika.host.sessions.booked_use import BookedUse
from onika.host.sessions.site_clock import SiteClock
from onika.link.caller import Role
from onika.wire import booking, event, holding, live, request, steer
from onika.wire.booking import STEP_S
from onika.words.reason import NOTHING

NOW = 1_000_000 * STEP_S
MOVING = [live.Take("s0"), live.Change("s0"), live.Reset(), steer.Resume(), request.Begin()]


class Site:
    """A robot with its book, its clock, whoever is connected, and who holds what."""

    def __init__(self, folder, **given):
        self.at_s = 0.0
        self.told = []
        self.held = set()
        self.ended = []
        self.here = []
        self.book = BookingBook(folder / "bookings")
        clock = SiteClock(lambda: NOW + self.at_s, lambda: round(self.at_s * 1e9))
        self.use = BookedUse("arm", self.book, clock, self.told.append, **given)

    def users(self):
        return self.held

    def end_use(self, user, late, cause, now):
        self.held.discard(user)
        self.ended.append((self.at_s, user, late, cause.key))

    def ask(self, session, message, role=Role.OPERATOR):
        return self.use.answer(session, role, message)

    def books(self, user, begin, end, **more):
        answer = self.ask(f"{user}#1", booking.Book(NOW + begin * STEP_S, NOW + end * STEP_S, **more))
        assert isinstance(answer, booking.Booked), answer
        return answer.booking

    def may(self, session, message=MOVING[0]):
        return not self.use.refusal(session, message)

    def until(self, steps):
        """Let the time pass, in seconds."""
        while self.at_s < steps * STEP_S:
            self.at_s += 1.0
            self.use.judge([holding.SessionStanding(name, "operator") for name in self.here], self, 7)


@pytest.fixture
def site(tmp_path):
    return Site(tmp_path)


@pytest.mark.parametrize("message", MOVING, ids=lambda message: type(message).__name__)
def test_in_a_users_time_nobody_else_moves_anything(site, message):  # R-F09
    site.books("ann", 0, 2)
    assert site.may("ann#3", message)
    assert not site.may("bob#1", message)
    assert not site.may("owner#1", message), "the owner takes the booking back first"


@pytest.mark.parametrize(
    "message",
    [request.Stop(NOTHING), request.Abort("", NOTHING), live.Survey(), steer.Pause(), live.Release("s0")],
    ids=lambda message: type(message).__name__,
)
def test_to_stop_and_to_look_is_everybodys_at_any_time(site, message):  # R-F09
    site.books("ann", 0, 2)
    assert site.may("bob#1", message)


def test_where_another_follows_the_end_is_announced_and_then_what_the_user_drives_rests(site):  # R-F09
    site.books("ann", 0, 6, late="finish")
    site.books("bob", 6, 8)
    site.here, site.held = ["ann#1"], {"ann"}
    site.until(8)
    left = [(one.user, round(one.left_s), one.follower) for one in site.told if isinstance(one, event.SlotEnds)]
    assert left == [("ann", 600, "bob"), ("ann", 60, "bob"), ("ann", 0, "bob")]
    assert site.ended == [(6 * STEP_S - 60, "ann", "finish", "booking.over")]


def test_where_nobody_follows_a_user_goes_on(site):  # R-F09
    site.books("ann", 0, 2)
    site.here, site.held = ["ann#1"], {"ann"}
    site.until(4)
    assert (site.told, site.ended) == ([], [])


def test_who_came_first_leaves_when_somebodys_time_begins(site):  # R-F09
    site.books("ann", 2, 4)
    site.held, site.here = {"bob"}, ["ann#1"]
    site.until(3)
    assert site.ended == [(2 * STEP_S, "bob", "stop", "booking.over")]


def test_who_does_not_come_within_ten_minutes_has_given_his_time_away(site):  # R-F09
    site.books("ann", 0, 6)
    site.here = ["bob#1"]
    site.until(1)
    assert not site.may("bob#1")
    site.until(2.1)
    assert site.may("bob#1")
    site.here = ["ann#1"]
    site.until(3)
    assert site.may("bob#1"), "it is nobody's now"


def test_who_has_come_keeps_his_time_when_he_goes_for_a_while(site):  # R-F09
    site.books("ann", 0, 6)
    site.here = ["ann#1"]
    site.until(0.1)
    site.here = []
    site.until(4)
    assert not site.may("bob#1")


def test_a_clock_that_is_set_is_told_and_takes_nobodys_time(site):  # R-F09
    site.books("ann", 0, 6)
    site.here = ["ann#1"]
    site.until(0.1)
    wall = site.use._clock._wall
    site.use._clock._wall = lambda: wall() + 7200
    site.until(0.2)
    assert [one.by_s for one in site.told if isinstance(one, event.ClockSet)] == [pytest.approx(7200)]
    assert not site.may("bob#1")


def test_what_is_booked_is_shown_with_the_time_there(site):  # R-F09
    mine = site.books("ann", 1, 2)
    shown = site.ask("bob#1", booking.Bookings())
    assert (shown.robot, shown.you, shown.bookings, shown.now_s) == ("arm", "bob", (mine,), NOW)


def test_a_booking_is_changed_by_its_user_and_taken_back_by_the_owner(site):  # R-F09
    mine = site.books("ann", 1, 2)
    longer = site.ask("ann#2", booking.ExtendBooking(mine.number, NOW + 3 * STEP_S))
    assert longer.booking.end_s == NOW + 3 * STEP_S
    assert isinstance(site.ask("bob#1", booking.CancelBooking(mine.number)), request.Refused)
    assert site.ask("owner#1", booking.CancelBooking(mine.number), Role.OWNER) == request.Done()
    assert site.ask("bob#1", booking.Bookings()).bookings == ()


def test_where_it_is_needed_nobody_moves_the_robot_without_a_booking(tmp_path):  # R-F09
    site = Site(tmp_path, is_needed=True)
    assert not site.may("ann#1")
    site.books("ann", 0, 1)
    assert site.may("ann#1")


def test_a_book_that_is_gone_changes_nothing_that_is_known(site, tmp_path):  # R-F09
    site.books("ann", 0, 6)
    assert not site.may("bob#1")
    (tmp_path / "bookings").unlink()
    site.here = ["ann#1"]
    site.until(1)
    assert not site.may("bob#1")
    assert isinstance(site.ask("bob#1", booking.Bookings()), request.Refused)
