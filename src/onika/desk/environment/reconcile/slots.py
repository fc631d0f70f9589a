"""The times for which robots are booked, as runtimes tell of them (requirement F09)."""

from dataclasses import replace

from msgspec import structs

from onika.desk.environment.outcome.outcome import Done, Order
from onika.desk.environment.reconcile.presence import you
from onika.desk.environment.state.model import Model
from onika.wire import booking, event, page, request, view
from onika.words.reason import Reason


def listed(model: Model, listing: booking.BookingList, at_s: float) -> Model:
    """With what is booked; `at_s` is when that was told, in seconds since 1970."""
    bookings = tuple(
        view.BookingView(known.number, known.user, known.begin_s, known.end_s, known.late, known.note)
        for known in listing.bookings
    )
    book = view.BookView(listing.robot, listing.you, listing.now_s, at_s, listing.is_needed, bookings)
    return replace(model, runtime=structs.replace(model.runtime, book=book))


def ask_bookings(at_s: float) -> Order:
    """Ask what is booked, where that is shown."""

    def answered(model: Model, response: request.Response) -> Done:
        return Done(listed(model, response, at_s) if isinstance(response, booking.BookingList) else model)

    return Order(booking.Bookings(), answered)


def after_slot(model: Model, message: event.SlotEnds | event.ClockSet, at_s: float) -> Done:
    """A user's time with the robot ends, or is over; or the clock by which all is booked was set."""
    if isinstance(message, event.ClockSet):
        runtime = structs.replace(model.runtime, clock_set_s=message.by_s)
        line = page.Say("warning", Reason.of("booking.clock_set", seconds=message.by_s))
        return Done(replace(model, runtime=runtime), says=(line,))
    is_over = message.left_s <= 0
    ends = None if is_over else view.SlotEndView(message.user, message.follower, at_s + message.left_s)
    model = replace(model, runtime=structs.replace(model.runtime, slot_ends=ends))
    is_yours = message.user == you(model).partition("#")[0]
    line = page.Say("warning" if is_yours else "info", _words(message))
    return Done(model, says=(line,), orders=(ask_bookings(at_s),))


def _words(message: event.SlotEnds) -> Reason:
    if message.left_s <= 0:
        return Reason.of("booking.over", user=message.user, follower=message.follower)
    minutes = max(1, round(message.left_s / 60))
    return Reason.of("booking.ends", user=message.user, minutes=minutes, follower=message.follower)
