"""The robot is booked from a console, by the clock of its site (F09)."""

import pytest

from kit.desk.live_runtime import LiveRuntime
from onika.wire import booking, request
from onika.words.reason import Reason

NOON = 1_790_078_400
"""2026-09-22 12:00 UTC."""


class BookedRuntime(LiveRuntime):
    """Keeps what is booked, without judging it."""

    def __init__(self):
        super().__init__()
        self.known = booking.BookingList("arm", NOON + 61.5, "ann")

    def ask(self, message):
        match message:
            case booking.Bookings():
                self.asked.append(message)
                return self.known
            case booking.Book():
                self.asked.append(message)
                return booking.Booked(booking.Booking(7, "ann", message.begin_s, message.end_s, message.late))
            case booking.ExtendBooking():
                self.asked.append(message)
                return booking.Booked(booking.Booking(message.number, "ann", NOON, message.end_s))
        return super().ask(message)


@pytest.fixture
def sitting(sit):
    return sit(BookedRuntime())


@pytest.mark.parametrize(
    ("line", "wanted"),
    [
        ("book now for 1h", booking.Book(NOON + 61, NOON + 3900)),
        ("book in 30m for 1h30m", booking.Book(NOON + 2100, NOON + 7500)),
        ("book 14:00 for 2h finish", booking.Book(NOON + 7200, NOON + 14400, "finish")),
        ("book 9:30 for 30m for the visitors", booking.Book(NOON + 77_400, NOON + 79_200, "stop", "for the visitors")),
        ("book 14:00 for 2h finish calibration", booking.Book(NOON + 7200, NOON + 14400, "finish", "calibration")),
    ],
)
def test_a_time_is_said_by_the_clock_there_or_from_now(sitting, line, wanted):  # R-F09
    (told,) = sitting.does(line)
    assert sitting.requests_of(booking.Book) == [wanted]
    assert told.startswith("booking 7: from 2026-09-2")


@pytest.mark.parametrize(
    "line",
    ["book 25:00 for 1h", "book 12:60 for 1h", "book in soon for 1h", "book now until 13:00", "book now for long"],
)
def test_what_is_no_time_is_told_with_what_was_expected(sitting, line):  # R-F09
    assert "a length as 1h30m" in str(sitting.fails(line).reason)
    assert sitting.requests_of(booking.Book) == []


def test_what_is_booked_is_shown_from_now_on(sitting):  # R-F09
    assert sitting.does("bookings") == [
        "arm, where it is 2026-09-22 12:01 UTC", "nobody has booked: whoever comes first may move it",
    ]  # fmt: skip
    bookings = (booking.Booking(3, "ann", NOON, NOON + 3600), booking.Booking(4, "bob", NOON + 3600, NOON + 7200))
    sitting.runtime.known = booking.BookingList("arm", NOON + 60, "ann", bookings)
    own, other = sitting.does("bookings")[1:]
    assert own == "3  2026-09-22 12:00 UTC to 2026-09-22 13:00 UTC  you, in 0 min"
    assert other == "4  2026-09-22 13:00 UTC to 2026-09-22 14:00 UTC  bob, in 59 min"
    sitting.runtime.known = booking.BookingList("arm", NOON, "ann", is_needed=True)
    assert "nobody moves it without" in sitting.does("bookings")[1]


def test_a_booking_is_made_longer_from_its_begin_and_taken_back(sitting):  # R-F09
    sitting.runtime.known = booking.BookingList("arm", NOON, "ann", (booking.Booking(3, "ann", NOON + 61, NOON + 900),))
    sitting.does("extend 3 for 1h", "cancel 3")
    assert sitting.requests_of(booking.ExtendBooking) == [booking.ExtendBooking(3, NOON + 3900)]
    assert sitting.requests_of(booking.CancelBooking) == [booking.CancelBooking(3)]
    assert "expected `extend NUMBER" in str(sitting.fails("extend three for 1h").reason)
    assert "expected `cancel NUMBER`" in str(sitting.fails("cancel all").reason)


@pytest.mark.parametrize("line", ["bookings", "book now for 1h", "extend 3 for 1h"])
def test_where_nothing_is_booked_that_is_said(sitting, line):  # R-F09
    sitting.runtime.known = request.Refused(Reason.of("booking.nothing"))
    assert "keeps no bookings" in str(sitting.fails(line).reason)
