"""Turns what is wrong with a steering line into a fault at its place."""

from onika.words.fault import Fault, Place
from onika.words.reason import Reason, Text

GOES_ON = Reason.of("desk.run_goes_on")


def objection(place: Place, reason: Text, instead: Reason) -> Fault:
    """The fault of a line for a reason; of a bare text, that it was not done because of it."""
    if isinstance(reason, Reason):
        return Fault(place, reason, instead)
    return Fault(place, Reason.of("desk.line_refused", text=reason), instead)
