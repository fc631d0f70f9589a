from onika.agent.booked_robots import BookedRobots
from onika.booking.book import BookingBook
from onika.host.sessions.site_clock import SiteClock
from onika.wire.booking import Booking


def test_what_is_booked_is_read_at_the_time_of_the_site(tmp_path):  # R-F09
    now = [3000.0]
    book = BookingBook(tmp_path / "book")
    robots = BookedRobots(book, SiteClock(lambda: now[0], lambda: 0))
    booking = book.book("arm", Booking(0, "ann", 3000, 3600), 3000.0)
    assert (robots.now_s(), robots.of("arm"), robots.of("crane")) == (3000.0, (booking,), ())
    now[0] = 3700.0
    assert robots.of("arm") == ()


def test_a_book_that_cannot_be_read_now_says_nothing(tmp_path):
    path = tmp_path / "book"
    robots = BookedRobots(BookingBook(path), SiteClock(lambda: 0.0, lambda: 0))
    path.write_text("no book at all " * 100)
    assert robots.of("arm") == ()
