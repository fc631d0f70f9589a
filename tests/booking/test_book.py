"""The book of bookings: no two of a robot ever overlap, whoever writes (F09)."""

import sqlite3
import threading
from contextlib import suppress

import pytest

from onika.booking.book import AHEAD_S, LONGEST_S, MOST, BookingBook, BookRefused, book_path
from onika.wire.booking import STEP_S, Booking

NOW = 1_000_000 * STEP_S
ARM = "arm"


@pytest.fixture
def book(tmp_path):
    return BookingBook(tmp_path / "bookings")


def wanted(user="ann", begin=1, end=2, **more):
    """From step to step, counted from now."""
    return Booking(0, user, NOW + begin * STEP_S, NOW + end * STEP_S, **more)


def refused(book, *arguments, **named):
    with pytest.raises(BookRefused) as why:
        book(*arguments, **named)
    return why.value.reason.key.removeprefix("booking.")


def test_what_is_booked_stands_in_the_book_in_order(book):  # R-F09
    second = book.book(ARM, wanted("bob", 3, 4, late="finish", note="calibration"), NOW)
    first = book.book(ARM, wanted("ann", 1, 3), NOW)
    assert book.bookings(ARM, NOW) == (first, second)
    assert (second.late, second.note, first.number != second.number) == ("finish", "calibration", True)
    assert book.bookings("another", NOW) == ()
    assert book.bookings(ARM, first.end_s) == (second,), "what is over is not shown"


@pytest.mark.parametrize(("begin", "end"), [(1, 2), (0, 3), (2, 3), (0, 2)])
def test_what_overlaps_is_refused_and_says_whose_time_it_is(book, begin, end):  # R-F09
    book.book(ARM, wanted("bob", 1, 3), NOW)
    with pytest.raises(BookRefused, match="bob has booked from"):
        book.book(ARM, wanted("ann", begin, end), NOW)
    book.book("another", wanted("ann", begin, end), NOW)


def test_times_that_touch_do_not_overlap(book):  # R-F09
    book.book(ARM, wanted("bob", 2, 3), NOW)
    book.book(ARM, wanted("ann", 1, 2), NOW)
    book.book(ARM, wanted("ann", 3, 4), NOW)


@pytest.mark.parametrize(
    ("booking", "key"),
    [
        (wanted(begin=-2), "begin"),
        (Booking(0, "ann", NOW + 7, NOW + STEP_S), "begin"),
        (Booking(0, "ann", NOW, NOW + 7), "end"),
        (wanted(begin=2, end=2), "end"),
        (wanted(begin=3, end=2), "end"),
        (wanted(end=2 + LONGEST_S // STEP_S), "long"),
        (wanted(begin=AHEAD_S // STEP_S, end=AHEAD_S // STEP_S + 1), "ahead"),
        (wanted(late="never"), "late"),
        (wanted(note="x" * 201), "note"),
        (wanted(note="two\nlines"), "note"),
    ],
)
def test_what_is_no_time_to_book_is_refused(book, booking, key):  # R-F09
    assert refused(book.book, ARM, booking, NOW) == key
    assert book.bookings(ARM, 0) == ()


def test_a_booking_may_begin_now_in_the_middle_of_a_step(book):  # R-F09
    book.book(ARM, Booking(0, "ann", NOW + 7, NOW + STEP_S), NOW + 7.4)


def test_nobody_books_all_there_is(book):  # R-F09
    for number in range(MOST):
        book.book(ARM, wanted(begin=number, end=number + 1), NOW)
    assert refused(book.book, ARM, wanted(begin=MOST, end=MOST + 1), NOW) == "too_many"
    book.book(ARM, wanted("bob", MOST, MOST + 1), NOW)


def test_a_booking_is_made_longer_where_nobody_follows_and_by_its_user(book):  # R-F09
    mine = book.book(ARM, wanted("ann", 0, 2), NOW)
    book.book(ARM, wanted("bob", 4, 5), NOW)
    longer = book.extend(ARM, mine.number, NOW + 4 * STEP_S, "ann", NOW + 30)
    assert book.bookings(ARM, NOW)[0] == longer
    assert refused(book.extend, ARM, mine.number, NOW + 5 * STEP_S, "ann", NOW) == "taken"
    assert refused(book.extend, ARM, mine.number, NOW + 3 * STEP_S, "bob", NOW) == "of_another"
    assert refused(book.extend, ARM, 99, NOW + 3 * STEP_S, "bob", NOW) == "none"
    assert refused(book.extend, ARM, mine.number, NOW, "ann", NOW + 30) == "end"


def test_a_booking_is_taken_back_by_its_user_or_the_owner_and_stays_in_the_trail(book, tmp_path):  # R-F09
    mine = book.book(ARM, wanted("ann"), NOW)
    assert refused(book.cancel, ARM, mine.number, "bob", NOW, is_owner=False) == "of_another"
    book.cancel(ARM, mine.number, "owner", NOW, is_owner=True)
    assert book.bookings(ARM, NOW) == ()
    book.book(ARM, wanted("bob"), NOW)
    assert refused(book.cancel, ARM, mine.number, "ann", NOW, is_owner=False) == "none"
    rows = sqlite3.connect(tmp_path / "bookings")
    assert rows.execute("SELECT cancelled_by FROM booking WHERE number = ?", (mine.number,)).fetchall() == [("owner",)]
    rows.close()


def test_many_who_book_at_once_get_no_time_twice(tmp_path):  # R-F09
    def press(user):
        own = BookingBook(tmp_path / "bookings")
        for begin in range(MOST):
            with suppress(BookRefused):
                made.append(own.book(ARM, wanted(user, begin, begin + 1), NOW))

    made = []
    threads = [threading.Thread(target=press, args=(user,)) for user in "abcd"]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sorted(booking.begin_s for booking in made) == [NOW + step * STEP_S for step in range(MOST)]


def test_a_book_that_is_none_is_told(tmp_path):  # R-F09
    path = book_path({"XDG_STATE_HOME": str(tmp_path)})
    path.parent.mkdir()
    path.write_text("my diary " * 200)
    with pytest.raises(OSError, match="cannot be used"):
        BookingBook(path)
    assert path.read_text().startswith("my diary"), "nothing was lost"


def test_only_its_user_reads_the_book_and_a_change_is_seen(book, tmp_path):  # R-F09
    assert (tmp_path / "bookings").stat().st_mode & 0o077 == 0
    before = book.stamp()
    BookingBook(tmp_path / "bookings").book(ARM, wanted(), NOW)
    assert book.stamp() != before
