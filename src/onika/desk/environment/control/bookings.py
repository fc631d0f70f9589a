"""Acts about the times for which robots are booked: the robot's own runtime judges them (requirement F09)."""

from onika.desk.environment.outcome.outcome import Ask, Done, No, Procedure
from onika.desk.environment.outcome.runtime_refusal import refusal
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.reconcile.slots import ask_bookings, listed
from onika.desk.environment.state.model import Model
from onika.wire import act, booking, request
from onika.wire.booking import step_after


def look(model: Model, _asked: act.LookAtBookings, outside: Services) -> Procedure:
    """Ask what is booked; the value is why nothing is, where the runtime keeps no bookings."""
    model, listing = yield Ask(model, booking.Bookings())
    if isinstance(listing, booking.BookingList):
        return Done(listed(model, listing, outside.calendar()))
    return Done(model, value=refusal(listing))


def book(model: Model, command: act.BookRobot, outside: Services) -> Procedure:
    """Book for oneself, from now on or later; the value says what was booked."""
    begin_s = command.begin_s
    if not begin_s:
        model, listing = yield Ask(model, booking.Bookings())
        if not isinstance(listing, booking.BookingList):
            return No(refusal(listing))
        begin_s = int(listing.now_s)
    wanted = booking.Book(begin_s, step_after(begin_s + command.length_s), command.late, command.note)
    model, response = yield Ask(model, wanted)
    return _booked(model, response, outside)


def prolong(model: Model, command: act.ProlongBooking, outside: Services) -> Procedure:
    """Let a booking end at another time."""
    model, response = yield Ask(model, booking.ExtendBooking(command.number, command.end_s))
    return _booked(model, response, outside)


def take_back(model: Model, command: act.TakeBackBooking, outside: Services) -> Procedure:
    """Give a time back."""
    model, response = yield Ask(model, booking.CancelBooking(command.number))
    return _booked(model, response, outside)


def _booked(model: Model, response: request.Response, outside: Services) -> Done | No:
    """What is booked now is asked anew, whatever came of it: others book too."""
    if isinstance(response, booking.Booked | request.Done):
        return Done(model, orders=(ask_bookings(outside.calendar()),))
    return No(refusal(response))
