"""Console commands about the times for which the robot is booked: bookings, book, extend, cancel (F09).

Times are reckoned by the clock of the robot's site, which its answer tells, and shown in UTC and from now.
"""

import re

from onika.desk.console.session import ConsoleSession, Faults
from onika.wire import booking, request
from onika.wire.booking import step_after
from onika.words.reason import Reason
from onika.words.utc import utc

Words = tuple[str, ...]
_DAY_S = 86_400
_LENGTH = re.compile(r"(?:(\d{1,3})h)?(?:(\d{1,4})m)?")
_CLOCK = re.compile(r"(\d{1,2}):(\d{2})")


def bookings(session: ConsoleSession, words: Words) -> Faults:
    """Who has booked the robot, from now on."""
    del words
    listing = session.ask(booking.Bookings())
    if not isinstance(listing, booking.BookingList):
        return session.no(_why(listing))
    session.say(Reason.of("console.bookings", robot=listing.robot, now=utc(listing.now_s)))
    for booked in listing.bookings:
        session.say(_line(booked, listing.now_s, listing.you))
    if not listing.bookings:
        session.say(Reason.of("console.no_bookings_needed" if listing.is_needed else "console.no_bookings"))
    return ()


def book(session: ConsoleSession, words: Words) -> Faults:
    """`book now|in LENGTH|HH:MM for LENGTH [finish] [NOTE]`: book the robot for oneself."""
    listing = session.ask(booking.Bookings())
    if not isinstance(listing, booking.BookingList):
        return session.no(_why(listing))
    book_request = _book_request(words, listing.now_s)
    if book_request is None:
        return session.no(Reason.of("console.book_usage", words=words))
    return _say_booked(session, session.ask(book_request))


def extend(session: ConsoleSession, words: Words) -> Faults:
    """`extend NUMBER for LENGTH`: let a booking last so long from its begin."""
    number, length_s = _number(words[0]), _length_s(words[2]) if words[1:2] == ("for",) and len(words) == 3 else None
    if number is None or length_s is None:
        return session.no(Reason.of("console.extend_usage", words=words))
    listing = session.ask(booking.Bookings())
    if not isinstance(listing, booking.BookingList):
        return session.no(_why(listing))
    begins = [booked.begin_s for booked in listing.bookings if booked.number == number]
    end_s = step_after((begins[0] if begins else listing.now_s) + length_s)
    return _say_booked(session, session.ask(booking.ExtendBooking(number, end_s)))


def cancel(session: ConsoleSession, words: Words) -> Faults:
    """`cancel NUMBER`: take a booking back."""
    number = _number(words[0])
    if number is None:
        return session.no(Reason.of("console.cancel_usage", words=words))
    return session.order(booking.CancelBooking(number))


def _book_request(words: Words, now_s: float) -> booking.Book | None:
    """What is to be booked; None: the words do not say it."""
    begin_s: int | None = None
    if words[:1] == ("now",):
        begin_s, rest = int(now_s), words[1:]
    elif words[:1] == ("in",) and len(words) > 1:
        wait_s = _length_s(words[1])
        begin_s, rest = None if wait_s is None else step_after(now_s + wait_s), words[2:]
    else:
        begin_s, rest = _at_clock(words[0], now_s), words[1:]
    length_s = _length_s(rest[1]) if rest[:1] == ("for",) and len(rest) > 1 else None
    if begin_s is None or length_s is None:
        return None
    late = "finish" if rest[2:3] == ("finish",) else "stop"
    note = " ".join(rest[3:] if late == "finish" else rest[2:])
    return booking.Book(begin_s, step_after(begin_s + length_s), late, note)


def _at_clock(word: str, now_s: float) -> int | None:
    """The next time at which a clock in UTC shows this."""
    matched = _CLOCK.fullmatch(word)
    if matched is None or int(matched[1]) > 23 or int(matched[2]) > 59:
        return None
    today_s = int(now_s) // _DAY_S * _DAY_S
    at_s = today_s + int(matched[1]) * 3600 + int(matched[2]) * 60
    return at_s if at_s > now_s else at_s + _DAY_S


def _length_s(word: str) -> int | None:
    """`1h`, `30m`, `1h30m` in seconds."""
    matched = _LENGTH.fullmatch(word)
    if matched is None or not word:
        return None
    return int(matched[1] or 0) * 3600 + int(matched[2] or 0) * 60


def _number(word: str) -> int | None:
    return int(word) if word.isascii() and word.isdigit() and len(word) < 10 else None


def _line(booked: booking.Booking, now_s: float, you: str) -> Reason:
    key = "console.booking_own" if booked.user == you else "console.booking"
    minutes = max(0, round((booked.begin_s - now_s) / 60))
    note = f"  {booked.note}" if booked.note else ""
    begin, end = utc(booked.begin_s), utc(booked.end_s)
    return Reason.of(key, number=booked.number, user=booked.user, begin=begin, end=end, minutes=minutes, note=note)


def _say_booked(session: ConsoleSession, answer: request.Response) -> Faults:
    if not isinstance(answer, booking.Booked):
        return session.no(_why(answer))
    booked = answer.booking
    session.say(Reason.of("console.booked", number=booked.number, begin=utc(booked.begin_s), end=utc(booked.end_s)))
    return ()


def _why(answer: request.Response) -> Reason:
    return answer.reason if isinstance(answer, request.Refused) else Reason.plain(str(answer))
